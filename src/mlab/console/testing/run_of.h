#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "mlab/lang/mdl/mdl.h"
#include "mlab/run/mission_run.h"
#include "mlab/simulated/run.h"

namespace mlab::console::testing {

/// A run of a mission that is given as text.
inline std::unique_ptr<run::MissionRun> run_of(
    const std::string& text, std::uint64_t seed = 1,
    const std::function<void(run::RunSettings&)>& set = [](run::RunSettings& /*settings*/) {}) {
  text::Diagnostics sink;
  const auto source = std::make_shared<const text::Source>("test.mdl", text);
  const auto mission = mdl::check_mission(source, "", sink);
  EXPECT_NE(mission, nullptr) << text::render(sink);
  if (!mission) return nullptr;
  run::RunSettings settings;
  settings.seed = seed;
  set(settings);
  auto run = simulated::make_run(mission, {}, settings, sink);
  EXPECT_NE(run, nullptr) << text::render(sink);
  return run;
}

/// Two robots that travel 600 m to the east, and two that are never started.
inline constexpr const char* kTravel =
    "MISSION-AREA 1000 1000\n"
    "UNIT <pair> ROBOT ROBOT\n"
    "UNIT <rest> ROBOT ROBOT\n"
    "COMMAND LIST:\n"
    "0. UNIT pair START 100 100 0 40\n"
    "1. UNIT pair MOVETO 700 120 FORMATION Line\n";

inline void step(run::MissionRun& run, int cycles) {
  for (int i = 0; i < cycles; ++i) run.step();
}

}  // namespace mlab::console::testing
