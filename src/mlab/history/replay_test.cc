#include "mlab/history/replay.h"

#include <limits>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "mlab/cell/testing/permission.h"
#include "mlab/history/testing/meddler.h"
#include "mlab/history/testing/written_run.h"

namespace mlab::history {
namespace {

using testing::all_of;
using testing::Meddler;
using testing::WrittenRun;
namespace event = mission::event;

ReplayTools tools() {
  return {cell::testing::code_permitted()};
}

// Computes the run again; each robot holds the same after each cycle.
void expect_same(const WrittenRun& written) {
  text::Diagnostics sink;
  const auto replay = Replay::make(written.history(), tools(), sink);
  ASSERT_NE(replay, nullptr) << text::render(sink);
  std::size_t cycles = 0;
  while (replay->step()) {
    ASSERT_LT(cycles, written.values().size());
    ASSERT_EQ(all_of(replay->run()), written.values()[cycles]) << "cycle " << replay->run().cycle();
    ++cycles;
  }
  ASSERT_FALSE(replay->divergence()) << replay->divergence()->cycle << ": " << replay->divergence()->why;
  EXPECT_EQ(cycles, written.values().size());
  EXPECT_TRUE(replay->is_at_end());
  EXPECT_GT(replay->equal_marks(), 0U);
}

TEST(Replay, IsTheRunWhateverPeopleDid) {
  for (std::uint32_t seed = std::random_device{}() % 100'000, last = seed + 6; seed < last; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    WrittenRun written("demo_c/demo_c.mdl", seed);
    written.run().post(event::Execute{});
    Meddler meddler(written, seed);
    for (int i = 0; i < 200; ++i) {
      meddler.meddle();
      for (int cycles = meddler.below(30); cycles > 0; --cycles) written.step();
    }
    written.end();
    ASSERT_GT(written.history()->inputs().size(), 20U);
    expect_same(written);
    if (HasFatalFailure()) return;
  }
}

TEST(Replay, AnswersQuestionsThatWereAskedWhileNoTimePassed) {
  WrittenRun written("demo_c/demo_c.mdl", 2);
  run::MissionRun& run = written.run();
  run.post(event::Execute{});
  int answered = 0;
  for (int i = 0; i < 3000 && !run.is_over(); ++i) {
    if (written.step() || run.state().questions.empty()) continue;
    // Somebody does something else first.
    run.post(event::Pause{});
    written.step();
    run.post(event::Answer{run.state().questions.front().id, true});
    run.post(event::Resume{});
    ++answered;
  }
  written.end();
  ASSERT_GT(answered, 1);
  expect_same(written);
}

// What was told and where robots were is there, whatever else of it means something else by now.
TEST(Replay, OfAnotherFormatIsNotComputedButRead) {
  WrittenRun written("demo_c/demo_c.mdl", 2, true);
  written.run().post(event::Execute{});
  for (int i = 0; i < 50; ++i) written.step();
  written.end();
  const auto history = std::make_shared<History>();
  for (wire::HistoryEntry entry : written.entries()) {
    if (entry.has_beginning()) {
      entry.mutable_beginning()->set_format(History::kFormat + 1);
      entry.mutable_beginning()->mutable_mission()->clear_texts();
    }
    const auto problem = history->add(entry);
    ASSERT_FALSE(problem) << *problem;
  }
  EXPECT_EQ(history->poses().size(), written.history()->poses().size());
  EXPECT_EQ(history->events().size(), written.history()->events().size());
  text::Diagnostics sink;
  EXPECT_EQ(Replay::make(history, tools(), sink), nullptr);
  ASSERT_TRUE(sink.has_errors());
  EXPECT_NE(sink.items().front().message.find("it is of format 2"), std::string::npos)
      << sink.items().front().message;
}

TEST(Replay, ComputesProceduresAndWhatPeopleMadeOfThem) {
  WrittenRun written("forage/forage.mdl", 3);
  run::MissionRun& run = written.run();
  run.post(event::Execute{});
  for (int i = 0; i < 100; ++i) written.step();
  const auto* robot = run.fleet().find({2});
  const flow::Program& program = *robot->workings().program;
  const std::string sequence(program.sequence_name(0));
  EXPECT_FALSE(run.force_state({2}, sequence, "Returning"));
  for (int i = 0; i < 50; ++i) written.step();
  EXPECT_FALSE(run.hold_value({1}, "movement", "0.5, 0.5, 0"));
  for (int i = 0; i < 50; ++i) written.step();
  EXPECT_FALSE(run.release_value({1}, ""));
  for (int i = 0; i < 50; ++i) written.step();
  written.end();
  expect_same(written);
}

TEST(Replay, SaysWhereTheRunAndItsHistoryPart) {
  WrittenRun written("demo_c/demo_c.mdl", 1, true);
  written.run().post(event::Execute{});
  for (int i = 0; i < 350; ++i) written.step();
  written.end();
  // Somebody has changed a mark.
  auto changed = std::make_shared<History>();
  for (wire::HistoryEntry entry : written.entries()) {
    if (entry.has_mark() && entry.cycle() > 200) entry.mutable_mark()->set_digest(7);
    ASSERT_FALSE(changed->add(entry));
  }
  text::Diagnostics sink;
  const auto replay = Replay::make(changed, tools(), sink);
  ASSERT_NE(replay, nullptr) << text::render(sink);
  while (replay->step()) {
  }
  ASSERT_TRUE(replay->divergence());
  EXPECT_GT(replay->divergence()->cycle, 200U);
  EXPECT_LE(replay->divergence()->cycle, 301U);
  EXPECT_FALSE(replay->is_at_end());
}

TEST(Replay, GoesOnWithARunThatGoesOn) {
  WrittenRun written("demo_c/demo_c.mdl", 1, true);
  written.run().post(event::Execute{});
  for (int i = 0; i < 150; ++i) written.step();
  text::Diagnostics sink;
  const auto replay = Replay::make(written.history(), tools(), sink);
  ASSERT_NE(replay, nullptr) << text::render(sink);
  while (replay->step()) {
  }
  const std::uint64_t first = replay->run().cycle();
  EXPECT_GT(first, 100U);
  for (int i = 0; i < 150; ++i) written.step();
  while (replay->step()) {
  }
  EXPECT_GT(replay->run().cycle(), first);
  EXPECT_EQ(all_of(replay->run()), written.values()[replay->run().cycle() - 1]);
}

TEST(History, RefusesWhatNoRunCanHaveWritten) {
  WrittenRun written("demo_c/demo_c.mdl", 1, true);
  written.run().post(event::Execute{});
  for (int i = 0; i < 150; ++i) written.step();
  written.end();
  const std::vector<wire::HistoryEntry>& entries = written.entries();
  History whole;
  for (const wire::HistoryEntry& entry : entries) ASSERT_FALSE(whole.add(entry));
  EXPECT_EQ(whole.add(entries.back()), "something comes after the end of the run");

  History headless;
  EXPECT_EQ(headless.add(entries.back()), "something happens before the run has begun");
  for (const wire::HistoryEntry& entry : entries) {
    if (!entry.has_beginning()) continue;
    EXPECT_EQ(headless.add(entry), "text 1 is missing") << "its texts were left out";
    break;
  }
  History backwards;
  for (const wire::HistoryEntry& entry : entries) {
    if (entry.has_end()) break;
    ASSERT_FALSE(backwards.add(entry));
  }
  EXPECT_NE(backwards.add(entries.front()).value_or(""), "");
}

TEST(History, RefusesClocksThatShowNoTime) {
  WrittenRun written("demo_c/demo_c.mdl", 1);
  written.end();
  const auto problem_where = [&](auto change) {
    History history;
    for (wire::HistoryEntry entry : written.entries()) {
      if (entry.has_beginning()) change(*entry.mutable_beginning());
      if (auto problem = history.add(entry)) return *problem;
    }
    return std::string("none");
  };
  using Beginning = wire::HistoryBeginning;
  const std::string no_time = "it begins at a time that no clock shows";
  EXPECT_EQ(problem_where([](Beginning&) {}), "none");
  for (const double strange : {1e300, -1e300, 1e12, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(problem_where([&](Beginning& begun) { begun.set_started_at(strange); }), no_time);
    EXPECT_EQ(problem_where([&](Beginning& begun) { begun.mutable_executive()->set_epoch_seconds(strange); }),
              no_time);
    EXPECT_EQ(problem_where([&](Beginning& begun) { begun.mutable_executive()->set_zone_offset(strange); }),
              no_time);
  }
}

}  // namespace
}  // namespace mlab::history
