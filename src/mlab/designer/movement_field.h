#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "mlab/fleet/mission_run.h"
#include "mlab/flow/network.h"
#include "mlab/flow/program.h"
#include "mlab/robot_host/hosted_cycle.h"

namespace mlab::designer {

/// A part of a robot's program that gives a movement, to be asked without the rest.
struct FieldProgram {
  std::shared_ptr<const flow::Program> program;
  std::string port;            ///< of the movement
  flow::Network network = {};  ///< what it was built from
  /// As robot::BuiltProgram.
  std::shared_ptr<const robot_host::HostedProgram> hosted = nullptr;
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
/// the movement in the world frame as a share of full strength. The run is only read, between cycles; a large
/// grid in pieces, so that the run need not wait for all of it.
class FieldReading {
 public:
  /// @param as_is   it has the robot's state, as when reading began; else it has just started
  FieldReading(FieldProgram part, FieldGrid grid, bool as_is);

  /// Goes on for so long [s], at least one place.
  /// @param body    whose senses and orders it has
  /// @return  true: it is done
  bool read(const fleet::MissionRun& run, const fleet::FleetRobot& body, double budget);
  /// What has been read.
  const std::string& arrows() const { return arrows_; }

 private:
  void begin(const fleet::FleetRobot& body);
  percept::Percepts perceive(const fleet::MissionRun& run, const fleet::FleetRobot& body,
                             std::uint32_t place) const;
  void add_arrow(const geom::Pose& pose, const std::byte* frame);
  void read_place(const fleet::MissionRun& run, const fleet::FleetRobot& body);
  void read_hosted(const fleet::MissionRun& run, const fleet::FleetRobot& body);

  FieldProgram part_;
  FieldGrid grid_;
  bool as_is_;
  const flow::Port* port_;
  flow::Frame start_;
  flow::Frame frame_;
  percept::Needs needs_;
  std::unique_ptr<robot_host::HostedCycle> hosted_;  ///< where the part has a process of its own
  std::uint32_t next_ = 0;                           ///< place; 0: not begun
  std::string arrows_;
};

/// The whole field at once.
std::string field_arrows(const fleet::MissionRun& run, const fleet::FleetRobot& body, bool as_is,
                         const FieldProgram& part, const FieldGrid& grid);

}  // namespace mlab::designer
