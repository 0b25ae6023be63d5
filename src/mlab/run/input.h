#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <variant>

#include "mlab/base/id.h"
#include "mlab/binding/binding.h"
#include "mlab/mission/event.h"
#include "mlab/percept/percepts.h"
#include "mlab/run/crew.h"
#include "mlab/run/intervention.h"

namespace mlab::run {

/// What comes into a run from outside, always between two cycles. Together with what the run was made from,
/// these are all that decides how it goes on: whoever gives the same ones at the same moments gets the same
/// run, bit for bit, as long as nothing is sensed that was not simulated.
namespace input {
/// Execute, Pause, an answer, a typed command, ...
struct Posted {
  mission::Event event;
};
/// Another version of the mission, or of its programs.
struct Exchanged {
  std::shared_ptr<const Crew> crew;
  bool takes_over = false;  ///< robots in the world go on with the new programs
};
struct EmergencyStop {
  bool is_engaged = false;
};
struct Steered {
  base::RobotId robot;
  percept::Joystick stick;
  bool is_held = true;  ///< somebody has it in his hand; else it is in its middle
};
struct ParameterSet {
  base::RobotId robot;
  std::string port;
  std::string value;
};
struct Intervened {
  base::RobotId robot;
  InterventionRecord::Kind kind = InterventionRecord::Kind::kForce;
  std::string path;
  std::string value;
};
/// As MissionRun::set_stands_still_for_operator.
struct StandStill {
  bool stands_still = false;
};
/// What a body has said that is not simulated.
struct Heard {
  binding::Heard heard;
};
}  // namespace input
using Input = std::variant<input::Posted, input::Exchanged, input::EmergencyStop, input::Steered,
                           input::ParameterSet, input::Intervened, input::StandStill, input::Heard>;

/// When something came: between which two cycles, and on which side of what the executive did there.
struct Moment {
  std::uint64_t cycle = 0;  ///< that had run
  bool has_looked = false;  ///< the executive knew already how the robots stood after it
  friend auto operator<=>(const Moment&, const Moment&) = default;
};

}  // namespace mlab::run
