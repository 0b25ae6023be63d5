#include "mlab/simulated/run.h"

#include <utility>

#include "mlab/sim/simulated_binding.h"
#include "mlab/sim/world.h"
#include "mlab/simulated/breakdowns.h"

namespace mlab::simulated {

std::unique_ptr<binding::Binding> make_bodies(const mission::Mission& mission,
                                              const run::RunSettings& settings) {
  sim::SimulatorSettings around{settings.seed, settings.threads, {}};
  for (const Breakdown& one : breakdowns_of(mission, settings.seed))
    around.breakdowns.push_back({one.robot, one.after});
  auto out = std::make_unique<sim::SimulatedBinding>(sim::world_of(mission.overlay), std::move(around));
  return settings.vehicles ? settings.vehicles(mission, std::move(out)) : std::move(out);
}

std::unique_ptr<run::MissionRun> make_run(std::shared_ptr<const run::Crew> crew,
                                          const run::RunSettings& settings) {
  auto bodies = make_bodies(*crew->mission, settings);
  return std::make_unique<run::MissionRun>(std::move(crew), settings, std::move(bodies));
}

std::unique_ptr<run::MissionRun> make_run(const std::shared_ptr<const mission::Mission>& mission,
                                          const robot::ProgramSources& sources,
                                          const run::RunSettings& settings, text::Diagnostics& sink) {
  std::shared_ptr<const run::Crew> crew = run::check_crew(mission, sources, sink);
  return crew ? make_run(std::move(crew), settings) : nullptr;
}

}  // namespace mlab::simulated
