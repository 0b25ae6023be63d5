#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mlab/flow/network.h"
#include "mlab/flow/program.h"
#include "mlab/robot/program/program_runners.h"
#include "mlab/robot/program/robot_program.h"
#include "mlab/run/mission_run.h"

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
  /// @param as_is   it has the robot's state, as when reading began; else it has just started. State that a
  ///                process of its own has computed is for such a process only
  FieldReading(FieldProgram part, FieldGrid grid, bool as_is);

  FieldReading(const FieldReading&) = delete;  // runners know where the program is
  FieldReading& operator=(const FieldReading&) = delete;

  /// Goes on for so long [s], at least a few places.
  /// @param body    whose senses and orders it has
  /// @return  true: it is done
  bool read(const run::MissionRun& run, const fleet::FleetRobot& body, double budget);
  /// Why it can't be read, as a sentence: the mission lacks a place that the part wants. Empty: it can.
  const std::string& problem() const { return problem_; }
  /// What has been read is of the robot's state; once reading has begun.
  bool is_as_is() const { return as_is_; }
  /// What has been read.
  const std::string& arrows() const { return arrows_; }

 private:
  void begin(const run::MissionRun& run, const fleet::FleetRobot& body);
  void find_places(const run::MissionRun& run);
  void read_places(const run::MissionRun& run, const fleet::FleetRobot& body);
  geom::Pose pose_of(std::uint32_t place) const {
    return grid_.pose(place % grid_.columns, place / grid_.columns);
  }
  void add_arrow(std::uint32_t place);

  robot::RobotProgram program_;                ///< of the part
  std::vector<robot::PlaceParameter> places_;  ///< of the mission, that it wants
  const flow::Port* port_;
  FieldGrid grid_;
  bool as_is_;
  flow::Frame start_;  ///< a robot's values at each place
  percept::Needs needs_;
  std::optional<robot::ProgramRunners> runners_;  ///< since reading began
  robot::ProgramRunner* runner_ = nullptr;        ///< of the part
  std::vector<robot::ProgramRunner::Member> robots_;
  std::uint32_t next_ = 0;  ///< place
  std::string arrows_;
  std::string problem_;
};

/// The whole field at once.
/// @errors  as FieldReading::problem
text::Result<std::string> field_arrows(const run::MissionRun& run, const fleet::FleetRobot& body, bool as_is,
                                       const FieldProgram& part, const FieldGrid& grid);

}  // namespace mlab::designer
