#pragma once

#include <cstdint>
#include <limits>
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

/// The step index of what belongs to no step of the plan (a typed command).
inline constexpr std::uint32_t kNoStep = std::numeric_limits<std::uint32_t>::max();

/// What the executive wants to happen. The caller carries the effects out in their order.
namespace effect {
/// Bring a robot into the world at this pose (START).
struct Start {
  base::RobotId robot;
  geom::Pose pose;
};
/// An order for several robots, the same for all of them. Their stations and their centre are computed among
/// `members`; a robot's rank is its place in the list.
///
/// An order whose sequence the robots already have is not a new one: only `halted` or the members changed
/// (some robot went to another order); what they have done of it stays done.
struct Order {
  std::vector<base::RobotId> members;
  percept::Order order;                        ///< `route` points into `command`
  std::shared_ptr<const UnitCommand> command;  ///< keeps the route alive
};
/// The robot ends: halted, out of the run, still standing in the world (STOP, abort).
struct Stop {
  base::RobotId robot;
};
/// An option of the console or the simulation changes.
struct Set {
  std::variant<SetBoolean, SetNumber> option;
};
/// Print the robots, or all that the console knows.
struct Print {
  bool robot_info = false;
};
/// The run ends, all robots with it.
struct Quit {};
/// All robots hold where they are, or go on.
struct PauseRobots {
  bool paused = true;
};
/// Ask the operator. The same id is withdrawn or answered later.
struct Ask {
  std::uint32_t question = 0;
  std::string text;               ///< `Unit "scouts" is occupying AA-AA1. Proceed?`
  std::optional<double> expires;  ///< at this time it answers itself with yes [s]
  std::uint32_t command = 0;      ///< index into State::commands; meaningless where a robot asks
  base::RobotId robot = {};       ///< whose program asks; 0: a unit's command does
};
/// What the robot's program asked is answered with yes.
struct LetProceed {
  base::RobotId robot;
};
/// The question has answered itself, or nobody waits for its answer any more. Not sent for an answered one.
struct Withdraw {
  std::uint32_t question = 0;
};
/// The operator's stick steers the robots of this command until he says that it is enough.
struct OpenTeleoperation {
  std::uint32_t command = 0;  ///< index into State::commands
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
  std::uint32_t step = kNoStep;  ///< index into Mission::steps; kNoStep for orders of the operator
  std::uint32_t command = 0;     ///< index into State::commands; meaningful for the command kinds
  std::string text;
};
}  // namespace effect
using Effect = std::variant<effect::Start, effect::Order, effect::Stop, effect::Set, effect::Print,
                            effect::Quit, effect::PauseRobots, effect::Ask, effect::LetProceed,
                            effect::Withdraw, effect::OpenTeleoperation, effect::Tell>;

}  // namespace mlab::mission
