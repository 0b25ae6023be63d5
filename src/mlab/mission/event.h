#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "mlab/base/id.h"
#include "mlab/geom/pose.h"
#include "mlab/mission/mission.h"

namespace mlab::mission {

/// What a robot's program and body tell the executive each cycle.
struct RobotReport {
  base::RobotId id;
  geom::Pose pose;             ///< [m, rad, world]
  double radius = 0.2;         ///< of its body [m]
  bool is_running = false;     ///< started, not stopped, no fault
  std::uint32_t sequence = 0;  ///< of the order that `done` and `remaining` speak of
  bool done = false;
  double remaining = 0.0;  ///< [m]; infinite: it can do no more of it

  friend bool operator==(const RobotReport&, const RobotReport&) = default;
};

namespace event {
/// A control cycle has passed. `robots` holds all started robots; who is missing counts as lost.
struct Cycle {
  double time = 0.0;  ///< simulated or real seconds since the start of the run; time never runs backwards
  std::vector<RobotReport> robots;
};
/// Start at the current step, or go on after a pause.
struct Execute {};
struct Pause {};
struct Resume {};
/// Running: abandon the step and start the next. Else: start one step, and stop after it.
struct SingleStep {};
/// A step runs: finish it, then stop. Else: nothing.
struct StopAfterStep {};
/// Running: start that step now. Else: go there.
struct Jump {
  std::uint32_t step = 0;
};
/// Abandon the step that runs, go to the first, don't start it.
struct Rewind {};
/// Stop all robots, rewind.
struct Abort {};
/// The program of a robot asks whether it may go on. One that has asked and got no answer yet asks no second
/// time.
struct RobotAsks {
  base::RobotId robot;
};
/// Answer to a question (Proceed?, phase line, a robot's own). Without `proceed` it is an Abort.
struct Answer {
  std::uint32_t question = 0;
  bool proceed = true;
};
/// An order of the operator, already resolved against the mission; several commands were joined by AND. It
/// ends what its own robots do, and nothing else.
struct Typed {
  std::vector<Command> commands;
  std::string line = {};  ///< the same in the mission's language
};
/// The plan was edited; the step that runs goes on if its label is still there.
struct Edited {
  std::shared_ptr<const Mission> mission;
};
/// The operator says that the teleoperation by this command is over.
struct TeleoperationComplete {
  std::uint32_t command = 0;  ///< index into State::commands
};
}  // namespace event
using Event =
    std::variant<event::Cycle, event::Execute, event::Pause, event::Resume, event::SingleStep, event::Jump,
                 event::Rewind, event::Abort, event::Answer, event::Typed, event::Edited,
                 event::TeleoperationComplete, event::StopAfterStep, event::RobotAsks>;

}  // namespace mlab::mission
