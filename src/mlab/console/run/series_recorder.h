#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "mlab/console.pb.h"
#include "mlab/run/mission_run.h"

namespace mlab::console {

/// Quantities over time, recorded in every cycle while somebody watches them and for kKept after. Once kMost
/// samples are there, every second one is dropped, and only every second cycle is recorded from then on.
class SeriesRecorder {
 public:
  static constexpr double kKept = 60.0;  ///< wall clock [s]
  static constexpr std::size_t kMost = 65'536;

  struct Sample {
    double time;
    double value;
  };

  /// What is watched now, by anybody.
  void watch(const std::vector<Series>& wanted, double wall);
  /// Once per cycle.
  void look(const run::MissionRun& run);
  /// All samples are gone; what is watched stays so.
  void clear();
  /// Samples of a series after that time; none where it is not recorded.
  void encode_since(const Series& series, double time, std::string& samples) const;
  /// Time of the last sample, or what was given where there is none.
  double last_time(const Series& series, double otherwise) const;
  bool is_recorded(const Series& series) const { return tracks_.contains(key_of(series)); }
  std::size_t count() const { return tracks_.size(); }

 private:
  using Key = std::tuple<int, std::uint32_t, std::string, std::string>;
  struct Track {
    Series series;
    std::vector<Sample> samples;
    std::uint64_t stride = 1;  // of how many cycles one is recorded
    std::uint64_t cycles = 0;
    double unwatched_at = -1.0;  // negative: it is watched
  };
  static Key key_of(const Series& series);

  std::map<Key, Track> tracks_;
};

}  // namespace mlab::console
