#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "mlab/geom/pose.h"
#include "mlab/model_vehicles/model_vehicle.h"
#include "mlab/overlay/overlay.h"

namespace mlab::model_vehicles {

/// Exit statuses, those of `mlab`.
inline constexpr int kDone = 0;
inline constexpr int kFailed = 1;    ///< the machine would not let it
inline constexpr int kBadInput = 2;  ///< what was asked for can't be understood

/// What is asked of all programs of model vehicles.
struct ProgramOptions {
  std::string overlay;  ///< path; empty: there is nothing in its world
  double x = 0.0;       ///< [m]
  double y = 0.0;       ///< [m]
  double heading_deg = 0.0;
  std::uint64_t seed = 1;
  std::string link;  ///< see PseudoTerminal::open
  geom::Pose place() const;
};
void add_options(CLI::App& app, ProgramOptions& options);

/// Reads the overlay; says on standard error what is wrong with it.
/// @return  false: it can't be used
bool read_world(const ProgramOptions& options, overlay::Overlay& into);

/// Runs the vehicle on a pseudo-terminal until SIGINT or SIGTERM comes: prints `line: PATH`, and then as much
/// time goes by for it as for everybody.
/// @return  exit status
int serve(ModelVehicle& vehicle, const ProgramOptions& options);

}  // namespace mlab::model_vehicles
