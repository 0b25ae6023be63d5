#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "mlab/console.pb.h"
#include "mlab/console/published/scene_encoder.h"
#include "mlab/flow/program.h"
#include "mlab/mission/mission.h"
#include "mlab/run/mission_run.h"

namespace mlab::console {

/// The steps of a mission as its author planned them.
void encode_plan(const mission::Mission& mission, std::uint64_t revision, const PlaceOf& place_of, Plan& out);

/// Robots, named units and robot programs with their ports.
void encode_roster(const run::MissionRun& run, Roster& out);

/// The named units of a mission alone.
void encode_units(const mission::Mission& mission, Roster& out);

/// A port as a browser shows it.
void encode_port(const flow::Program& program, const flow::Port& port, Port& out);

/// Text of a mission's author for a browser: as it is, but for control characters and what is no UTF-8.
std::string clean(std::string_view text);

}  // namespace mlab::console
