#pragma once

#include <string>
#include <vector>

#include "mlab/comparison/comparison.h"
#include "mlab/comparison/program_pair.h"
#include "mlab/comparison/wire_walk.h"
#include "mlab/run/mission_run.h"

// Why two runs part: sentences, those about what is nearest first.
namespace mlab::comparison {

/// What wires and people say of the first value that differs.
std::vector<std::string> causes_at(const WireWalk& walk, const Both<robot::Workings>& workings,
                                   const ProgramPair::PortPair& first);

/// What else is different between the runs by now: the robot's order and start, the world, the plan, what
/// came in, seed, settings, texts. Each only where it can be behind what is known so far.
/// @param robots  the first that parts; both null: it is about none
void add_causes(const Both<const run::MissionRun*>& runs, const Both<const fleet::FleetRobot*>& robots,
                const Comparison& comparison, Parting& parting);

}  // namespace mlab::comparison
