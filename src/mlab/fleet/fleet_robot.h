#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/base/id.h"
#include "mlab/binding/body.h"
#include "mlab/fleet/failsafes.h"
#include "mlab/geom/pose.h"
#include "mlab/percept/action.h"
#include "mlab/percept/object_classes.h"
#include "mlab/percept/percepts.h"
#include "mlab/robot/program/program_runner.h"
#include "mlab/robot/program/robot_program.h"

namespace mlab::fleet {

/// What became of a robot.
enum class RobotLife : std::uint8_t {
  kNotStarted,  ///< no START yet
  kRunning,
  kParked,   ///< stands in the world, but nothing here answers to its program's name
  kStopped,  ///< by STOP or abort; it keeps standing
  kFaulted,  ///< its program failed or put out what is no number, or its body is gone; the others go on
};
std::string_view name(RobotLife life);

/// Something that a robot wants of its operator, or of the run as a whole.
struct RobotCall {
  enum class Kind : std::uint8_t {
    kAlert,       ///< `text` is to be shown
    kProceed,     ///< asks whether it may go on
    kHalt,        ///< its program has ended
    kEndMission,  ///< the mission is to end for all
    kFailsafe,    ///< `text` says which failsafe acts, or no longer
  };
  base::RobotId robot;
  Kind kind = Kind::kAlert;
  std::string text;
};

/// One robot of the run.
struct FleetRobot {
  base::RobotId id;
  std::string type;  ///< name of its robot type
  const robot::RobotProgram* program = nullptr;
  binding::BodySpec body_spec;         ///< as the mission wants it
  binding::Capabilities capabilities;  ///< as it is, once started; before, as the mission wants it
  binding::Kinematics kinematics;      ///< likewise
  percept::ObjectClass seen_as = percept::ObjectClass::kFriendlyRobot;  ///< when it starts, by its colour
  RobotLife life = RobotLife::kNotStarted;
  binding::BodyIndex body = binding::kNoBody;  ///< once started
  std::uint32_t group = kNoGroup;
  std::uint32_t rank = 0;
  percept::Action action;  ///< of the last cycle
  percept::Joystick joystick;
  bool is_teleoperated = false;              ///< an operator is to steer it
  bool is_stick_held = false;                ///< and somebody has the stick in his hand, wherever that points
  std::vector<std::uint64_t> notifications;  ///< its inbox, ascending
  std::vector<percept::SharedPlace>
      places;  ///< that it has heard of, by who told it, where radios don't reach all
  std::vector<percept::AskedPassage> passages;  ///< likewise
  std::uint32_t team = 0;                       ///< robots of the same number are one team
  geom::Pose start;
  std::uint16_t failsafes = 0;  ///< rows of the mission's table that are its own, a bit for each
  FailsafeState failsafe;
  std::string fault;         ///< path of the port that went wrong; empty: none
  std::uint32_t starts = 0;  ///< how often its program was to be brought to life, in whatever place
  std::string failure;  ///< what the process of its program did instead of acting: `ended with exit status 3`
  std::string ailment;  ///< why its body could not be counted on any more: `has no more percepts`
  robot::ProgramRunner* runner = nullptr;   ///< of its program; null: nothing here answers to its name
  robot::ProgramRunner::Member member = 0;  ///< among those of the runner

  /// What its program computes with.
  robot::Workings workings() const {
    return runner != nullptr ? runner->workings(member) : robot::Workings{};
  }

  static constexpr std::uint32_t kNoGroup = 0xffffffffU;
};
/// What it asked for in the last cycle.
inline std::span<const percept::Request> requests_of(const FleetRobot& robot) {
  const std::size_t most = percept::Action::kMaxRequests;
  const std::size_t asked = robot.action.request_count;
  return {robot.action.requests.data(), asked < most ? asked : most};
}

/// What is wrong with a robot that stands because of it, apart from details.
enum class Fault : std::uint8_t { kNone, kBody, kNoNumber, kProgram };
Fault fault_of(const FleetRobot& robot);
/// `its body is gone`, ...; empty for none
std::string_view name(Fault fault);
/// What its program or its body did instead of going on, as a sentence: `its program `scout` ended with exit
/// status 3`. Empty: nothing, it has no fault.
std::string failure_of(const FleetRobot& robot);

}  // namespace mlab::fleet
