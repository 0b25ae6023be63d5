#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "mlab/base/id.h"
#include "mlab/geom/pose.h"
#include "mlab/mission/mission.h"
#include "mlab/percept/percepts.h"

namespace mlab::mission {

/// What a robot's program and body tell the executive each cycle.
struct RobotReport {
  base::RobotId id;
  geom::Pose pose;             ///< [m, rad, world]
  double radius = 0.2;         ///< of its body [m]
  bool is_running = false;     ///< started, not stopped, no fault
  std::uint32_t sequence = 0;  ///< of the order that `done` and `remaining` speak of
  bool done = false;
  double remaining = 0.0;  ///< [m]
};

namespace event {
/// A control cycle has passed. `robots` holds all started robots, by id.
struct Cycle {
  double time = 0.0;  ///< simulated or real seconds since the start of the run
  std::vector<RobotReport> robots;
};
struct Execute {};  ///< start at the current step, or go on after a pause
struct Pause {};
struct Resume {};
struct SingleStep {};  ///< running: abandon the step and start the next; else start one step
struct Jump {
  std::uint32_t step = 0;
};  ///< start that step now (running), or go there (not running)
struct Rewind {};
struct Abort {};  ///< stop all robots, rewind
/// Answer to a question (Proceed?, phase line).
struct Answer {
  std::uint32_t question = 0;
  bool proceed = true;
};
/// A typed command, already resolved against the mission; several were joined by AND.
struct Typed {
  std::vector<Command> commands;
};
/// The plan was edited; the step that runs goes on if its label is still there.
struct Edited {
  std::shared_ptr<const Mission> mission;
};
/// The operator says that teleoperation of this unit is over.
struct TeleoperationComplete {
  std::uint32_t unit = 0;
};
}  // namespace event
using Event = std::variant<event::Cycle, event::Execute, event::Pause, event::Resume, event::SingleStep,
                           event::Jump, event::Rewind, event::Abort, event::Answer, event::Typed,
                           event::Edited, event::TeleoperationComplete>;

enum class Outcome : std::uint8_t { kPending, kRunning, kDone, kFailed, kAborted, kReplaced, kSkipped };
std::string_view name(Outcome outcome);

namespace effect {
/// Bring robots into the world at these poses (START).
struct Start {
  base::RobotId robot;
  geom::Pose pose;
};
/// A new order for one robot. `members` are the robots among which its station and centre are computed, in
/// rank order.
struct Order {
  base::RobotId robot;
  percept::Order order;                    ///< `route` points into the mission, which outlives it
  std::shared_ptr<const Mission> mission;  ///< keeps the route alive
  std::vector<base::RobotId> members;
};
/// The robot ends: halted, out of the run, still standing in the world (STOP, abort).
struct Stop {
  base::RobotId robot;
};
struct Set {
  std::variant<SetBoolean, SetNumber> option;
};
struct Print {
  bool robot_info = false;
};
struct Quit {};
struct PauseRobots {
  bool paused = true;
};
/// Ask the operator. The same id is withdrawn or answered later.
struct Ask {
  std::uint32_t question = 0;
  std::string text;               ///< `Unit "scouts" is occupying AA-AA1. Proceed?`
  std::optional<double> expires;  ///< at this time it answers itself with yes [s]
  std::uint32_t command = 0;      ///< index into State::commands
};
struct Withdraw {
  std::uint32_t question = 0;
};
struct OpenTeleoperation {
  std::uint32_t unit = 0;
};
/// Something happened that is shown and logged.
struct Tell {
  enum class Kind : std::uint8_t {
    kStepStarted,
    kStepEnded,
    kCommandStarted,
    kCommandEnded,
    kMessage,
    kWarning,
    kMissionEnded
  };
  Kind kind = Kind::kMessage;
  std::uint32_t step = 0;     ///< index; meaningful for the step and command kinds
  std::uint32_t command = 0;  ///< index into State::commands
  std::string text;
};
}  // namespace effect
using Effect =
    std::variant<effect::Start, effect::Order, effect::Stop, effect::Set, effect::Print, effect::Quit,
                 effect::PauseRobots, effect::Ask, effect::Withdraw, effect::OpenTeleoperation, effect::Tell>;

}  // namespace mlab::mission
