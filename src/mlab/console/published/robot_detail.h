#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mlab/console.pb.h"
#include "mlab/console/run/estimates.h"
#include "mlab/run/mission_run.h"

namespace mlab::console {

/// What of a robot's details is wanted beyond the ordinary.
struct DetailWishes {
  bool ports = false;
  bool readings = false;
  /// How its sequences stood before its last cycle; empty: unknown.
  std::span<const flow::Program::SequenceState> before = {};
  /// Of the ports these alone, ascending indices into the program's ports; nothing: of all.
  std::optional<std::vector<std::uint32_t>> some_ports = std::nullopt;
};

/// Everything about one robot but for what it waits for: where it is, what it follows, why it moves as it
/// does.
void encode_detail(const run::MissionRun& run, const Estimates& estimates, const fleet::FleetRobot& robot,
                   const DetailWishes& wishes, RobotDetail& out);

/// Values of some ports of a program, behind those that `out` has already.
///
/// @param ran      Program::ran of the cycle
/// @param which    indices into the program's ports
/// @param told_as  what each of them is called in `out.vectors`
void encode_port_values(const flow::Program& program, const std::byte* frame,
                        std::span<const std::uint32_t> ran, std::span<const std::uint32_t> which,
                        std::span<const std::uint32_t> told_as, RobotDetail& out);

/// Where the program has these ports, ascending; those that it does not have are left out.
std::vector<std::uint32_t> port_indices(const flow::Program& program, std::span<const std::string> paths);

/// Why the robot is not done, and what would change that, in sentences. Looks at all that is near, so it
/// costs more than the rest.
std::vector<std::string> waits_for(const run::MissionRun& run, const fleet::FleetRobot& robot);

}  // namespace mlab::console
