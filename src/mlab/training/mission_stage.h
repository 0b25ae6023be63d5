#pragma once

#include <expected>
#include <functional>
#include <memory>

#include "mlab/run/mission_run.h"
#include "mlab/training/stage.h"

namespace mlab::training {

/// Makes a run of a mission, nothing of which has started.
/// @errors  a sentence
using RunMaker =
    std::function<std::expected<std::unique_ptr<run::MissionRun>, std::string>(std::uint64_t seed)>;

/// Robots of a mission. The mission goes on as it is planned; parameters are set and outputs held as by a
/// person, so a run that is recorded has all of it.
/// @param robots  whose rows there are; empty: all of the mission
/// @errors  a sentence: there is no such robot, its values are kept elsewhere, it has no such port
std::expected<std::unique_ptr<Stage>, std::string> make_mission_stage(RunMaker make,
                                                                      std::vector<base::RobotId> robots,
                                                                      std::vector<std::string> seen,
                                                                      std::vector<std::string> acted);

}  // namespace mlab::training
