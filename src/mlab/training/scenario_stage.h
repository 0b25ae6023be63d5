#pragma once

#include <expected>
#include <memory>

#include "mlab/flow/program.h"
#include "mlab/training/stage.h"

namespace mlab::training {

/// What a crowd of robots is, and how it is run.
struct ScenarioSettings {
  std::uint32_t robots = 1000;
  std::uint64_t places = 1;     ///< seed of where robots and obstacles are
  double range = 1.0;           ///< of the robots' range sensors [m]
  double cycle_duration = 0.1;  ///< [s]
  int threads = 1;
  /// A parameter of the program that is half the side of the square in which robots are sent about, as in
  /// `mlab bench`; where it has one.
  std::string half_parameter = "half";
};

/// The scenario of `mlab bench`: a square arena with walls, discs, and robots of one program. It is the same
/// run as that of `mlab bench` of the same seed, bit for bit, where the actions are what the program has
/// anyway.
/// @param program  outlives the stage
/// @errors  a sentence: as SeenColumns, ActionColumns
std::expected<std::unique_ptr<Stage>, std::string> make_scenario_stage(
    const ScenarioSettings& settings, std::shared_ptr<const flow::Program> program,
    std::span<const std::string> seen, std::span<const std::string> acted);

}  // namespace mlab::training
