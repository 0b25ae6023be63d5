#pragma once

#include <memory>

#include "mlab/binding/binding.h"
#include "mlab/fleet/crew.h"
#include "mlab/fleet/mission_run.h"
#include "mlab/mission/mission.h"
#include "mlab/robot/robot_program.h"
#include "mlab/text/diagnostic.h"

namespace mlab::simulated {

/// Bodies in a simulated world of the mission's map.
std::unique_ptr<binding::Binding> make_bodies(const mission::Mission& mission,
                                              const fleet::RunSettings& settings);

/// A mission that is carried out in simulation; nothing is started.
std::unique_ptr<fleet::MissionRun> make_run(std::shared_ptr<const fleet::Crew> crew,
                                            const fleet::RunSettings& settings);

/// The same, after everything that the mission names has been made ready: programs built, bodies and world
/// set up.
/// @return null where there were errors, all in `sink`
std::unique_ptr<fleet::MissionRun> make_run(const std::shared_ptr<const mission::Mission>& mission,
                                            const robot::ProgramSources& sources,
                                            const fleet::RunSettings& settings, text::Diagnostics& sink);

}  // namespace mlab::simulated
