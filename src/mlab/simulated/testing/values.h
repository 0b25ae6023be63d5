#pragma once

#include <string>
#include <vector>

#include "mlab/fleet/fleet.h"
#include "mlab/flow/program.h"

namespace mlab::simulated::testing {

/// All that a robot's program holds, in words: its values, and the states of its sequences. Frames can't be
/// compared byte by byte: what lies between the members of a value is nobody's.
inline std::vector<std::string> values_of(const fleet::FleetRobot& robot) {
  const robot::Workings at = robot.workings();
  std::vector<std::string> out;
  for (const flow::Port& port : at.program->ports())
    out.push_back(port.path + " = " + flow::Program::print(at.frame, port));
  std::vector<flow::Program::SequenceState> states;
  at.program->sequence_states(at.frame, states);
  for (const flow::Program::SequenceState& one : states)
    out.push_back(std::to_string(one.active) + " in cycle " + std::to_string(one.cycle));
  return out;
}

}  // namespace mlab::simulated::testing
