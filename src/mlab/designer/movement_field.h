#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "mlab/fleet/mission_run.h"
#include "mlab/flow/network.h"
#include "mlab/flow/program.h"

namespace mlab::designer {

/// A part of a robot's program that gives a movement, to be asked without the rest.
struct FieldProgram {
  std::shared_ptr<const flow::Program> program;
  std::string port;  ///< of the movement
};

/// @param network  of the whole robot
/// @param node     path of the node whose movement is asked for
/// @errors  a sentence for a person: there is no such node, it gives no movement
text::Result<FieldProgram> field_program(flow::Network network, const flow::Library& library,
                                         const std::string& node);

/// Where it is asked.
struct FieldGrid {
  double x_min = 0.0;  ///< [m, world]
  double y_min = 0.0;
  double x_max = 0.0;
  double y_max = 0.0;
  std::uint32_t columns = 1;
  std::uint32_t rows = 1;
  double heading = 0.0;  ///< of the robot there [rad]

  geom::Pose pose(std::uint32_t column, std::uint32_t row) const;
};

/// What the part would make a robot do at each place, row by row from the lower left: float32 x, y, dx, dy,
/// the movement in the world frame as a share of full strength. The run is only read; to be called between
/// cycles.
/// @param body    whose senses and orders it has
/// @param as_is   it has the robot's state as well; else it has just started
std::string field_arrows(const fleet::MissionRun& run, const fleet::FleetRobot& body, bool as_is,
                         const FieldProgram& part, const FieldGrid& grid);

}  // namespace mlab::designer
