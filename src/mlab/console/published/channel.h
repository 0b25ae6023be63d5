#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <string>

#include "mlab/console.pb.h"
#include "mlab/console/server/connection_id.h"

namespace mlab::console {

/// What is under way to one connection, and what it wants to see. A slow one gets fewer frames, never older
/// ones.
class Channel {
 public:
  static constexpr std::size_t kMostUnderWay = 2;
  static constexpr std::size_t kMostDetails = 64;
  static constexpr std::size_t kMostSeries = 64;
  static constexpr std::size_t kMostPorts = 10'000;

  explicit Channel(ConnectionId connection) : connection_(connection) {}

  ConnectionId connection() const { return connection_; }
  const Watch& watched() const { return watch_; }
  /// Replaces what it watched. Lists that are too long are cut.
  void watch(const Watch& wanted);
  /// How often that was replaced.
  std::uint64_t watch_number() const { return watch_number_; }

  /// It has drawn all frames but one.
  bool has_room() const { return under_way_.size() < kMostUnderWay; }
  /// A frame may be sent: there is room, and its time has come.
  bool wants_frame(double wall) const { return has_room() && wall >= next_; }
  /// When it will want one [s]; a far moment where it has to acknowledge first.
  double next_frame() const;
  /// The number of the frame that is sent now.
  std::uint64_t begin_frame(double wall);
  void acknowledge(std::uint64_t frame);

  bool looks_back = false;        ///< at another moment than now: what becomes of the run is not told to it
  std::uint64_t beat = 0;         ///< number of the browser's last one
  std::uint64_t seen = 0;         ///< version of the world in its last frame
  std::uint64_t status_seen = 0;  ///< number of the last status that it was told
  std::uint64_t alerts_seen = 0;  ///< EventLog::alerts_after that it was told
  std::uint64_t log_seen = 0;     ///< number of the last log entry that it has
  std::map<std::uint32_t, double>
      series_seen;  ///< time of the last sample that it has, by its id of the series
  std::map<std::uint32_t, std::string> failsafes_seen;  ///< by robot: how its rows stood, as it was told

 private:
  ConnectionId connection_;
  Watch watch_;
  std::uint64_t watch_number_ = 0;
  double interval_ = 1.0 / 30.0;  // between frames [s]
  double next_ = 0.0;
  std::uint64_t last_frame_ = 0;
  std::deque<std::uint64_t> under_way_;
};

}  // namespace mlab::console
