#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "mlab/console.pb.h"
#include "mlab/run/mission_run.h"

namespace mlab::console {

/// The last transition of each sequence of the robots that somebody looks at, and what their last cycle
/// computed. Browsers get fewer frames than there are cycles; a transition between two frames is not lost.
class TransitionRecorder {
 public:
  /// Whose, by id. Of a robot that is new here nothing is known yet.
  void watch(std::span<const std::uint32_t> robots);
  /// Programs of the run were exchanged, and those that no robot has any more are gone.
  void change(const run::MissionRun& run);
  /// Once per cycle.
  void look(const run::MissionRun& run);
  /// Of a robot's sequences, those that made any.
  void encode(std::uint32_t robot, RobotDetail& out) const;
  /// How the robot's sequences stood before its last cycle; empty where it is not known.
  std::span<const flow::Program::SequenceState> before(std::uint32_t robot) const;

 private:
  struct TimedTransit {
    flow::Program::Transit transit;
    double time = 0.0;
    std::uint64_t cycle = 0;
  };
  struct Watched {
    const flow::Program* program = nullptr;
    std::vector<flow::Program::SequenceState> before;
    std::vector<flow::Program::SequenceState> now;
    std::map<std::uint32_t, TimedTransit> last;  ///< by sequence
  };
  std::map<std::uint32_t, Watched> robots_;
};

}  // namespace mlab::console
