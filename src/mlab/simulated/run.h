#pragma once

#include <memory>

#include "mlab/binding/binding.h"
#include "mlab/mission/mission.h"
#include "mlab/robot/program/robot_program.h"
#include "mlab/run/crew.h"
#include "mlab/run/mission_run.h"
#include "mlab/text/diagnostic.h"

namespace mlab::simulated {

/// Bodies in a simulated world of the mission's map, and vehicles that stand in it.
std::unique_ptr<binding::Binding> make_bodies(const mission::Mission& mission,
                                              const run::RunSettings& settings);

/// A mission that is carried out in simulation; nothing is started.
std::unique_ptr<run::MissionRun> make_run(std::shared_ptr<const run::Crew> crew,
                                          const run::RunSettings& settings);

/// The same, after everything that the mission names has been made ready: programs built, bodies and world
/// set up.
/// @return null where there were errors, all in `sink`
std::unique_ptr<run::MissionRun> make_run(const std::shared_ptr<const mission::Mission>& mission,
                                          const robot::ProgramSources& sources,
                                          const run::RunSettings& settings, text::Diagnostics& sink);

}  // namespace mlab::simulated
