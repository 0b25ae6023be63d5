#include "mlab/simulated/run.h"

#include <utility>

#include "mlab/sim/simulated_binding.h"
#include "mlab/sim/world.h"

namespace mlab::simulated {

std::unique_ptr<binding::Binding> make_bodies(const mission::Mission& mission,
                                              const fleet::RunSettings& settings) {
  return std::make_unique<sim::SimulatedBinding>(sim::world_of(mission.overlay),
                                                 sim::SimulatorSettings{settings.seed, settings.threads});
}

std::unique_ptr<fleet::MissionRun> make_run(std::shared_ptr<const fleet::Crew> crew,
                                            const fleet::RunSettings& settings) {
  auto bodies = make_bodies(*crew->mission, settings);
  return std::make_unique<fleet::MissionRun>(std::move(crew), settings, std::move(bodies));
}

std::unique_ptr<fleet::MissionRun> make_run(const std::shared_ptr<const mission::Mission>& mission,
                                            const robot::ProgramSources& sources,
                                            const fleet::RunSettings& settings, text::Diagnostics& sink) {
  std::shared_ptr<const fleet::Crew> crew = fleet::check_crew(mission, sources, sink);
  return crew ? make_run(std::move(crew), settings) : nullptr;
}

}  // namespace mlab::simulated
