#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "mlab/console.pb.h"
#include "mlab/console/run/series_recorder.h"
#include "mlab/history/replay.h"

namespace mlab::console {

/// Quantities and states over a whole run, whoever looked at them when it went on: the run is computed once
/// more from its beginning, piece by piece.
class Survey {
 public:
  /// @param replay  at the run's beginning
  /// @param states_of  robots
  Survey(std::unique_ptr<history::Replay> replay, const std::vector<Series>& series,
         const std::vector<std::uint32_t>& states_of);

  /// Goes on.
  /// @param seconds  that it may take, about
  void advance(double seconds);
  /// All of it is there up to this moment [s].
  double known_to() const { return known_to_; }
  /// It has all of these.
  bool has(const Series& series) const { return series_.is_recorded(series); }
  bool has_states_of(std::uint32_t robot) const { return robots_.contains(robot); }

  void encode(const Series& series, Past::Samples& out) const;
  void encode_states(std::uint32_t robot, Past::States& out) const;

 private:
  /// One sequence of a robot; what it did is told as it changes.
  struct Track {
    std::string path;
    std::string state;  // of the last span
    std::vector<Past::Sequence::Span> spans;
  };
  struct Robot {
    const flow::Program* program = nullptr;  // of the last look; its sequences are in `tracks`, in order
    std::vector<flow::Program::SequenceState> states;
    std::vector<std::size_t> sequences;  // places in `tracks`, by sequence of the program
    std::vector<Track> tracks;
  };
  void look();
  void look_at(Robot& known, std::uint32_t id);
  void note(Track& track, const std::string& state) const;

  std::unique_ptr<history::Replay> replay_;
  SeriesRecorder series_;
  std::map<std::uint32_t, Robot> robots_;
  double known_to_ = 0.0;
};

}  // namespace mlab::console
