#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/mission/mission.h"
#include "mlab/run/mission_run.h"
#include "mlab/simulated/run.h"
#include "mlab/text/diagnostic.h"

namespace mlab {

/// A run of a mission that has been told to execute; null, and the test fails, where there is none.
/// @param patience  as of `mlab run` [s]
/// @param told      gets what is told in the run, a line each; outlives it
/// @param events    what happens in the world
inline std::unique_ptr<run::MissionRun> begun_run(const std::shared_ptr<const mission::Mission>& mission,
                                                  double patience, std::string& told,
                                                  std::vector<overlay::EnvironmentEvent> events = {}) {
  text::Diagnostics sink;
  run::RunSettings settings;
  settings.environment.events = std::move(events);
  settings.executive.patience = patience;
  settings.executive.proceed_all = true;
  auto out = simulated::make_run(mission, {}, settings, sink);
  if (!out) {
    ADD_FAILURE() << text::render(sink);
    return nullptr;
  }
  out->set_observer([&told](const mission::Effect& effect) {
    if (const auto* one = std::get_if<mission::effect::Tell>(&effect)) told += one->text + "\n";
  });
  out->post(mission::event::Execute{});
  return out;
}

}  // namespace mlab
