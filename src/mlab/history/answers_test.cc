// Runs of which what robots answered is written: they are computed again without a program.

#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/cell/testing/permission.h"
#include "mlab/history/replay.h"
#include "mlab/history/testing/meddler.h"
#include "mlab/history/testing/written_run.h"
#include "mlab/history/timeline.h"

namespace mlab::history {
namespace {

using testing::all_outside_of_programs;
using testing::Meddler;
using testing::WrittenRun;
namespace event = mission::event;

ReplayTools with_permission() {
  return {cell::testing::code_permitted()};
}

// Somebody meddles with a run of Demo C for a while.
void carry_out(WrittenRun& written, std::uint32_t seed, int times = 100) {
  written.run().post(event::Execute{});
  Meddler meddler(written, seed);
  for (int i = 0; i < times; ++i) {
    meddler.meddle();
    for (int cycles = meddler.below(30); cycles > 0; --cycles) written.step();
  }
}

std::shared_ptr<History> history_of(const std::vector<wire::HistoryEntry>& entries, std::size_t count) {
  auto out = std::make_shared<History>();
  for (std::size_t i = 0; i < count; ++i) EXPECT_FALSE(out->add(entries[i]));
  return out;
}

// @return  cycles that were computed, all as they were
std::size_t computed(const WrittenRun& written, const std::shared_ptr<const History>& history) {
  text::Diagnostics sink;
  const auto replay = Replay::make(history, with_permission(), sink);
  if (!replay) {
    ADD_FAILURE() << text::render(sink);
    return 0;
  }
  std::size_t cycles = 0;
  while (replay->step()) {
    EXPECT_EQ(all_outside_of_programs(replay->run()), written.values().at(cycles)) << "cycle " << cycles + 1;
    ++cycles;
    if (::testing::Test::HasFailure()) break;
  }
  EXPECT_FALSE(replay->divergence()) << replay->divergence()->why;
  for (const fleet::FleetRobot& robot : replay->run().fleet().robots()) EXPECT_FALSE(robot.workings());
  return cycles;
}

TEST(Answers, MakeTheRunWhateverPeopleDid) {
  for (std::uint32_t seed = std::random_device{}() % 100'000, last = seed + 4; seed < last; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    WrittenRun written("demo_c/demo_c.mdl", seed, false, true);
    carry_out(written, seed);
    written.end();
    ASSERT_FALSE(written.history()->answers().empty());
    EXPECT_EQ(computed(written, written.history()), written.values().size());
    if (HasFailure()) return;
  }
}

TEST(Answers, AreOfRobotsThatCarryAndTellEachOtherThings) {
  WrittenRun written("forage/forage.mdl", 3, true, true);
  written.run().post(event::Execute{});
  for (int i = 0; i < 1500; ++i) written.step();
  written.end();
  EXPECT_EQ(computed(written, written.history()), written.values().size());
}

TEST(Answers, OfARunThatWasCutOffReachAsFarAsTheyAreKnown) {
  const std::uint32_t seed = std::random_device{}() % 100'000;
  SCOPED_TRACE("seed " + std::to_string(seed));
  WrittenRun written("demo_c/demo_c.mdl", seed, false, true);
  carry_out(written, seed, 30);
  std::mt19937 random(seed);
  const std::vector<wire::HistoryEntry>& entries = written.entries();
  std::size_t begun = 0;
  while (!entries[begun].has_beginning()) ++begun;
  for (int cut = 0; cut < 12; ++cut) {
    const std::size_t count = std::uniform_int_distribution<std::size_t>(begun + 1, entries.size())(random);
    const auto history = history_of(entries, count);
    EXPECT_EQ(computed(written, history), history->last_cycle()) << count << " of " << entries.size();
    EXPECT_LE(entries[count - 1].cycle(), history->last_cycle() + 11) << "a second is missing at most";
  }
}

TEST(Answers, AreThereAtAnyMoment) {
  const std::uint32_t seed = std::random_device{}() % 100'000;
  SCOPED_TRACE("seed " + std::to_string(seed));
  WrittenRun written("demo_c/demo_c.mdl", seed, false, true);
  carry_out(written, seed, 40);
  written.end();
  text::Diagnostics sink;
  const auto timeline = Timeline::make(written.history(), with_permission(), {}, sink);
  ASSERT_NE(timeline, nullptr) << text::render(sink);
  std::mt19937 random(seed);
  for (int i = 0; i < 60; ++i) {
    const auto cycle =
        std::uniform_int_distribution<std::uint64_t>(1, written.history()->last_cycle())(random);
    const auto problem = timeline->go_to(cycle);
    ASSERT_FALSE(problem) << *problem;
    // What came in after the cycle is not there yet, as it was when the run was written.
    ASSERT_EQ(all_outside_of_programs(timeline->run()), written.values()[cycle - 1]) << cycle;
  }
  EXPECT_EQ(timeline->why_slow(), "");
}

TEST(Answers, AreMissedByWhoGoesOnWithTheRun) {
  WrittenRun written("demo_c/demo_c.mdl", 4, true, true);
  written.run().post(event::Execute{});
  for (int i = 0; i < 100; ++i) written.step();
  written.end();
  EXPECT_NE(written.history()->why_not_gone_on(), "");
  text::Diagnostics sink;
  const auto replay = Replay::make(written.history(), with_permission(), sink);
  ASSERT_NE(replay, nullptr) << text::render(sink);
  while (replay->step()) {
  }
  for (int i = 0; i < 10; ++i) replay->run().step();
  const fleet::FleetRobot& robot = replay->run().fleet().robots().front();
  EXPECT_EQ(robot.life, fleet::RobotLife::kFaulted);
  EXPECT_NE(robot.failure.find("gives no answer"), std::string::npos) << robot.failure;
}

// ------------------------------------------------------------------------------------------- of a stranger

class AnswersOfAStranger : public ::testing::Test {
 protected:
  AnswersOfAStranger() : written_("demo_c/demo_c.mdl", 4, true, true) {
    written_.run().post(event::Execute{});
    for (int i = 0; i < 100; ++i) written_.step();
    written_.end();
  }
  // Of the whole history with one entry of answers changed; what was said of it.
  std::string refusal(const std::function<void(wire::HistoryAnswers&)>& change) {
    history_ = std::make_shared<History>();
    bool is_changed = false;
    for (wire::HistoryEntry entry : written_.entries()) {
      if (!is_changed && entry.has_answers() && entry.answers().answers_size() > 8) {
        change(*entry.mutable_answers());
        is_changed = true;
      }
      if (const auto problem = history_->add(entry)) return *problem;
    }
    EXPECT_TRUE(is_changed);
    return "";
  }
  // Where that history is computed again; empty: it is as it was written.
  std::string why_parted() const {
    text::Diagnostics sink;
    const auto replay = Replay::make(history_, with_permission(), sink);
    EXPECT_NE(replay, nullptr) << text::render(sink);
    if (!replay) return "";
    while (replay->step()) {
    }
    return replay->divergence() ? replay->divergence()->why : "";
  }
  WrittenRun written_;
  std::shared_ptr<History> history_;
};

TEST_F(AnswersOfAStranger, AreRefusedWhereNoRobotCanHaveGivenThem) {
  const auto refused = [&](const std::string& part, const std::function<void(wire::HistoryAnswer&)>& change) {
    const std::string said = refusal([&](wire::HistoryAnswers& all) { change(*all.mutable_answers(3)); });
    EXPECT_NE(said.find(part), std::string::npos) << said;
  };
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  refused("no number", [](auto& one) { one.mutable_action()->set_velocity_x(kNaN); });
  refused("no number",
          [](auto& one) { one.mutable_action()->set_spin(std::numeric_limits<double>::infinity()); });
  refused("an alert is too long", [](auto& one) { one.mutable_action()->set_alert(std::string(5000, 'x')); });
  refused("too many requests", [](auto& one) {
    for (int i = 0; i < 100; ++i) one.mutable_action()->add_requests();
  });
  refused("longer than", [](auto& one) { one.set_failure(std::string(1'000'000, 'x')); });
  refused("is no time", [](auto& one) { one.mutable_hearing()->set_silence(-1.0); });
  refused("comes after", [](auto& one) { one.set_before(4'000'000'000U); });
  refused("comes after", [](auto& one) { one.set_robot(0); });
}

TEST_F(AnswersOfAStranger, AreRefusedWhereThereIsNoSuchRobot) {
  ASSERT_EQ(refusal([](wire::HistoryAnswers& all) {
              wire::HistoryAnswer& last = *all.mutable_answers(all.answers_size() - 1);
              last.set_robot(4711);
            }),
            "");
  EXPECT_NE(why_parted().find("robot 4711 has answered"), std::string::npos);
}

TEST_F(AnswersOfAStranger, AreAnotherRunWhereTheyAreOthers) {
  ASSERT_EQ(refusal([](wire::HistoryAnswers& all) {
              for (wire::HistoryAnswer& one : *all.mutable_answers()) {
                one.mutable_action()->set_velocity_x(1e300);
                one.mutable_action()->set_drives(true);
                one.mutable_needs()->set_obstacles(std::numeric_limits<double>::infinity());
              }
            }),
            "");
  EXPECT_NE(why_parted().find("are not where they were"), std::string::npos);
}

TEST_F(AnswersOfAStranger, ThatAreMissingMakeItsRobotsStand) {
  ASSERT_EQ(refusal([](wire::HistoryAnswers& all) { all.clear_answers(); }), "");
  EXPECT_NE(why_parted(), "");
}

}  // namespace
}  // namespace mlab::history
