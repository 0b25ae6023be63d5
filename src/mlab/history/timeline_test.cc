#include "mlab/history/timeline.h"

#include <limits>
#include <memory>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/cell/testing/permission.h"
#include "mlab/history/testing/meddler.h"
#include "mlab/history/testing/written_run.h"

namespace mlab::history {
namespace {

using testing::all_of;
using testing::Meddler;
using testing::WrittenRun;
namespace event = mission::event;

std::unique_ptr<Timeline> line_of(const WrittenRun& written, const Timeline::Settings& settings = {}) {
  text::Diagnostics sink;
  auto out = Timeline::make(
      written.history(), {cell::testing::code_permitted(), base::source_folder() + "/src"}, settings, sink);
  EXPECT_NE(out, nullptr) << text::render(sink);
  return out;
}

// Cycle 0 was not noted.
void expect_at(Timeline& line, const WrittenRun& written, std::uint64_t cycle) {
  const auto problem = line.go_to(cycle);
  ASSERT_FALSE(problem) << *problem;
  ASSERT_EQ(line.run().cycle(), cycle);
  ASSERT_EQ(all_of(line.run()), written.values()[cycle - 1]) << "cycle " << cycle;
}

TEST(Timeline, GoesToAnyMomentWhateverPeopleDid) {
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    WrittenRun written("demo_c/demo_c.mdl", seed);
    written.run().post(event::Execute{});
    Meddler meddler(written, seed);
    for (int i = 0; i < 150; ++i) {
      meddler.meddle();
      for (int cycles = meddler.below(30); cycles > 0; --cycles) written.step();
    }
    written.end();
    const auto cycles = static_cast<int>(written.history()->last_cycle());
    ASSERT_GT(cycles, 200);
    // So many checkpoints that some have to go: one in each cycle, however long it takes to make one.
    constexpr double kAny = std::numeric_limits<double>::infinity();
    const auto line = line_of(written, {.most_bytes = 1 << 20, .spacing = 0.0, .most_share = kAny});
    for (int i = 0; i < 60; ++i) {
      expect_at(*line, written, 1 + static_cast<std::uint64_t>(meddler.below(cycles)));
      if (HasFatalFailure()) return;
    }
    ASSERT_FALSE(line->go_to_end());
    EXPECT_EQ(all_of(line->run()), all_of(written.run()));
    expect_at(*line, written, static_cast<std::uint64_t>(cycles));
    EXPECT_FALSE(line->divergence());
    EXPECT_LE(line->checkpoints().bytes(), std::size_t{1} << 20);
    EXPECT_GT(line->checkpoints().size(), 2U);
    EXPECT_LT(line->checkpoints().size(), static_cast<std::size_t>(cycles) / 4);
  }
}

TEST(Timeline, StepsBackOneByOneFromCheckpointsNearby) {
  WrittenRun written("demo_c/demo_c.mdl", 1, true);
  written.run().post(event::Execute{});
  for (int i = 0; i < 900; ++i) written.step();
  const auto line = line_of(written, {.spacing = 1000.0});
  for (std::uint64_t cycle = 800; cycle > 700; --cycle) {
    expect_at(*line, written, cycle);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(line->checkpoints().size(), 5U);
  EXPECT_LT(line->checkpoints().size(), 100U);
}

TEST(Timeline, GrowsWithARunThatGoesOn) {
  WrittenRun written("demo_c/demo_c.mdl", 1, true);
  written.run().post(event::Execute{});
  const auto line = line_of(written);
  std::mt19937 random(3);
  for (int round = 0; round < 20; ++round) {
    for (int i = 0; i < 40; ++i) written.step();
    while (line->advance(0.001)) {
    }
    EXPECT_EQ(line->known_to(), written.history()->last_cycle());
    ASSERT_FALSE(line->go_to_end());
    expect_at(*line, written, 1 + random() % written.history()->last_cycle());
    if (HasFatalFailure()) return;
    if (round == 10) written.run().post(event::Pause{});
    if (round == 12) written.run().post(event::Resume{});
  }
}

TEST(Timeline, GoesToAnyMomentOfProceduresInACell) {
  WrittenRun written("../examples/14_behavior/pond.mdl", 2, true);
  written.run().post(event::Execute{});
  for (int i = 0; i < 300; ++i) written.step();
  written.end();
  const auto line = line_of(written, {.most_bytes = 100'000, .spacing = 0.0});
  std::mt19937 random(3);
  for (int i = 0; i < 30; ++i) {
    expect_at(*line, written, 1 + random() % written.history()->last_cycle());
    if (HasFatalFailure()) return;
  }
  EXPECT_EQ(line->why_slow(), "");
}

TEST(Timeline, SaysWhereItEnds) {
  WrittenRun written("demo_c/demo_c.mdl", 1, true);
  written.run().post(event::Execute{});
  for (int i = 0; i < 350; ++i) written.step();
  auto changed = std::make_shared<History>();
  for (wire::HistoryEntry entry : written.entries()) {
    if (entry.has_mark() && entry.cycle() > 200) entry.mutable_mark()->set_digest(7);
    ASSERT_FALSE(changed->add(entry));
  }
  text::Diagnostics sink;
  const auto line = Timeline::make(changed, {cell::testing::code_permitted()}, {}, sink);
  ASSERT_NE(line, nullptr) << text::render(sink);
  ASSERT_FALSE(line->go_to(150));
  const auto problem = line->go_to(changed->last_cycle());
  ASSERT_TRUE(problem);
  EXPECT_EQ(problem->find("the run can't be computed beyond cycle"), 0U) << *problem;
  EXPECT_EQ(line->run().cycle(), 150U);
  EXPECT_EQ(all_of(line->run()), written.values()[149]);
  EXPECT_TRUE(line->divergence());
}

}  // namespace
}  // namespace mlab::history
