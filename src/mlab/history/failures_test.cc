// Runs in lock-step in which programs failed whom nobody can ask why: machines were lost, processes were
// killed.

#include <algorithm>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/cell/testing/permission.h"
#include "mlab/history/branch.h"
#include "mlab/history/replay.h"
#include "mlab/history/testing/losing_runner.h"
#include "mlab/history/testing/meddler.h"
#include "mlab/history/testing/written_run.h"
#include "mlab/history/timeline.h"

namespace mlab::history {
namespace {

using testing::all_outside_of_programs;
using testing::LosingRunner;
using testing::Meddler;
using testing::WrittenRun;
namespace event = mission::event;

ReplayTools permitted_tools() {
  return {cell::testing::code_permitted()};
}

// A run of Demo C whose robots are lost now and then, while people meddle with it and replace them.
class Failures : public ::testing::Test {
 protected:
  void carry_out(std::uint32_t seed, int times) {
    auto runner = std::make_unique<LosingRunner>(seed, LosingRunner::Odds{});
    runner_ = runner.get();
    written_ = std::make_unique<WrittenRun>("demo_c/demo_c.mdl", seed, false, false, std::move(runner));
    written_->run().post(event::Execute{});
    Meddler meddler(*written_, seed);
    for (int i = 0; i < times; ++i) {
      meddler.meddle();
      for (int cycles = meddler.below(30); cycles > 0; --cycles) step();
      written_->run().replace_robot({static_cast<std::uint32_t>(1 + meddler.below(4))});
    }
  }
  void step() {
    if (written_->step()) outside_.push_back(all_outside_of_programs(written_->run()));
  }
  // @return  cycles that were computed, all as they were
  std::size_t computed(const std::shared_ptr<const History>& history) const {
    text::Diagnostics sink;
    const auto replay = Replay::make(history, permitted_tools(), sink);
    if (!replay) {
      ADD_FAILURE() << text::render(sink);
      return 0;
    }
    std::size_t cycles = 0;
    while (!HasFailure() && replay->step()) {
      EXPECT_EQ(all_outside_of_programs(replay->run()), outside_.at(cycles)) << "cycle " << cycles + 1;
      ++cycles;
    }
    EXPECT_FALSE(replay->divergence()) << replay->divergence()->why;
    return cycles;
  }

  LosingRunner* runner_ = nullptr;
  std::unique_ptr<WrittenRun> written_;
  std::vector<std::uint64_t> outside_;  // after each cycle
};

TEST_F(Failures, AreThoseOfTheRunWhereItIsComputedAgain) {
  int lost = 0;
  for (std::uint32_t seed = std::random_device{}() % 100'000, last = seed + 4; seed < last; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    outside_.clear();
    carry_out(seed, 100);
    written_->end();
    lost += runner_->lost();
    EXPECT_EQ(computed(written_->history()), outside_.size());
    if (HasFailure()) return;
  }
  EXPECT_GT(lost, 0);
}

TEST_F(Failures, AreKnownHoweverSoonTheRunWasCutOff) {
  const std::uint32_t seed = std::random_device{}() % 100'000;
  SCOPED_TRACE("seed " + std::to_string(seed));
  carry_out(seed, 40);
  const std::vector<wire::HistoryEntry>& entries = written_->entries();
  std::size_t begun = 0;
  while (!entries[begun].has_beginning()) ++begun;
  std::mt19937 random(seed);
  for (int cut = 0; cut < 12; ++cut) {
    const std::size_t count = std::uniform_int_distribution<std::size_t>(begun + 1, entries.size())(random);
    auto history = std::make_shared<History>();
    for (std::size_t i = 0; i < count; ++i) ASSERT_FALSE(history->add(entries[i]));
    EXPECT_EQ(computed(history), history->last_cycle()) << count << " of " << entries.size();
  }
}

TEST_F(Failures, AreThereAtAnyMoment) {
  const std::uint32_t seed = std::random_device{}() % 100'000;
  SCOPED_TRACE("seed " + std::to_string(seed));
  carry_out(seed, 40);
  written_->end();
  text::Diagnostics sink;
  const auto timeline = Timeline::make(written_->history(), permitted_tools(), {}, sink);
  ASSERT_NE(timeline, nullptr) << text::render(sink);
  std::mt19937 random(seed);
  for (int i = 0; i < 60; ++i) {
    const auto cycle =
        std::uniform_int_distribution<std::uint64_t>(1, written_->history()->last_cycle())(random);
    const auto problem = timeline->go_to(cycle);
    ASSERT_FALSE(problem) << *problem;
    ASSERT_EQ(all_outside_of_programs(timeline->run()), outside_[cycle - 1]) << cycle;
  }
}

TEST_F(Failures, AreThoseOfAnotherFutureAsWell) {
  const std::uint32_t seed = std::random_device{}() % 100'000;
  SCOPED_TRACE("seed " + std::to_string(seed));
  carry_out(seed, 40);
  const History& history = *written_->history();
  for (const std::uint64_t cycle : {std::uint64_t{0}, history.last_cycle() / 2, history.last_cycle()}) {
    const auto made = branch(history, {cycle, 0.0, {}, {}, true}, written_->run().mission());
    ASSERT_TRUE(made) << made.error();
    made->history->reach(written_->run().cycle(), written_->run().time());
    EXPECT_EQ(computed(made->history), outside_.size()) << cycle;
  }
}

TEST_F(Failures, AreForgottenByWhoGoesOn) {
  std::uint32_t seed = 7;
  while (seed < 20 && (!written_ || written_->history()->not_started().empty())) {
    outside_.clear();
    carry_out(++seed, 0);
    step();
  }
  written_->end();
  text::Diagnostics sink;
  const auto replay = Replay::make(written_->history(), permitted_tools(), sink);
  ASSERT_NE(replay, nullptr) << text::render(sink);
  while (replay->step()) {
  }
  run::MissionRun& run = replay->run();
  const auto standing =
      std::ranges::find(run.fleet().robots(), fleet::RobotLife::kFaulted, &fleet::FleetRobot::life);
  ASSERT_NE(standing, run.fleet().robots().end());
  run.forget_known_failures();
  EXPECT_EQ(run.replace_robot(standing->id), std::nullopt);
}

TEST_F(Failures, OfAStrangerAreRefusedWhereNoProgramCanHaveFailedSo) {
  carry_out(3, 20);
  const auto refusal = [&](const std::function<void(wire::HistoryFailed&)>& change) -> std::string {
    History history;
    for (wire::HistoryEntry entry : written_->entries()) {
      if (entry.has_answers()) {
        for (wire::HistoryFailed& one : *entry.mutable_answers()->mutable_failed()) change(one);
      }
      if (const auto problem = history.add(entry)) return *problem;
    }
    return "";
  };
  ASSERT_FALSE(written_->history()->failed().empty());
  EXPECT_EQ(refusal([](auto&) {}), "");
  EXPECT_NE(refusal([](auto& one) { one.set_before(4'000'000'000U); }), "");
  EXPECT_NE(refusal([](auto& one) { one.clear_failure(); }), "");
  EXPECT_NE(refusal([](auto& one) { one.set_failure(std::string(1'000'000, 'x')); }), "");
  EXPECT_EQ(refusal([](auto& one) { one.set_robot(4711); }), "") << "that nobody is";
}

}  // namespace
}  // namespace mlab::history
