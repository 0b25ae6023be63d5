#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "mlab/flow/frame_difference.h"
#include "mlab/flow/interventions.h"
#include "mlab/robot/program/robot_program.h"

namespace mlab::robot {

/// All that a robot goes on from with its program between two cycles: values, and what people set, hold and
/// force.
struct RobotMemory {
  const RobotProgram* program = nullptr;                     ///< outlives this
  flow::FrameDifference values;                              ///< from the program's initial ones
  std::shared_ptr<const flow::Interventions> interventions;  ///< null: none
  std::map<std::uint32_t, std::string> set;  ///< by a person, as written, by index of the program's ports
  bool has_started = false;

  /// That it takes up, about.
  std::size_t bytes() const;
};

}  // namespace mlab::robot
