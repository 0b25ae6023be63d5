#include "mlab/console/past/condition.h"

#include <string>

#include <gtest/gtest.h>

#include "mlab/history/testing/written_run.h"

namespace mlab::console {
namespace {

using history::testing::WrittenRun;

TEST(Condition, SaysWhatIsExpectedAndWhatWasSeen) {
  const auto error_of = [](const std::string& text) {
    const auto read = Condition::parse(text);
    return read ? std::string("understood") : read.error();
  };
  EXPECT_EQ(error_of("").find("expected `robot N` or `any robot`, but saw the end of the condition"), 0U);
  EXPECT_NE(error_of("robot three in contact").find("expected a robot's number, but saw `three`"),
            std::string::npos);
  EXPECT_NE(error_of("robot 0 in contact").find("`0`"), std::string::npos);
  EXPECT_NE(error_of("robot 3 nearer than nan m to an obstacle").find("`nan`"), std::string::npos);
  EXPECT_NE(error_of("robot 3 nearer than -1 m to an obstacle").find("`-1`"), std::string::npos);
  EXPECT_NE(error_of("robot 3 nearer than 2 m from an obstacle").find("expected `to`"), std::string::npos);
  EXPECT_NE(error_of("robot 3 nearer than 2 m to").find("a place of the map"), std::string::npos);
  EXPECT_NE(error_of("any robot in").find("`contact` or `state`"), std::string::npos);
  EXPECT_NE(error_of("robot 2 speed").find("`<`"), std::string::npos);
  EXPECT_NE(error_of("robot 2 speed > fast").find("expected a number, but saw `fast`"), std::string::npos);
  EXPECT_NE(error_of("any robot in contact now").find("expected nothing more, but saw `now`"),
            std::string::npos);
  EXPECT_NE(error_of("robot 2 active_task < moveto").find("expected a number, but saw `moveto`"),
            std::string::npos);
  EXPECT_NE(error_of("robot 2 active_task =").find("a number or a word"), std::string::npos);
  EXPECT_NE(error_of("robot 2 movement goes").find("`from STATE` or `to STATE`"), std::string::npos);
  EXPECT_NE(error_of("robot 2 movement goes from").find("the name of a state"), std::string::npos);
  EXPECT_NE(error_of(std::string(5000, 'x')).find("at most"), std::string::npos);
  for (const char* good :
       {"robot 3 nearer than 2 m to an obstacle", "any robot farther than 1e2 from PP-Charlie",
        "any robot in contact", "robot 2 in state Return", "robot 2 speed >= 1.5",
        "robot 1 nearer than 3 m to robot 2", "any robot nearer than 3 m to a robot",
        "robot 1 nearer than 5 m to its goal", "any robot active_task = moveto",
        "robot 2 movement goes from Searching to Return", "any robot movement goes to Return",
        "robot 2: movement goes from any to Return"})
    EXPECT_EQ(error_of(good), "understood") << good;
}

TEST(Condition, SaysWhatCanNeverBeTrue) {
  WrittenRun written("demo_c/demo_c.mdl");
  const auto why = [&](const std::string& text) {
    return Condition::parse(text)->why_never(written.run()).value_or("");
  };
  EXPECT_EQ(why("robot 9 in contact"), "there is no robot 9");
  EXPECT_EQ(why("any robot nearer than 2 m to PP-Nowhere"), "the map has no place `PP-Nowhere`");
  EXPECT_EQ(why("robot 1 wheel > 1"), "the program has no port `wheel`");
  EXPECT_EQ(why("any robot speed > 1"), "");
  EXPECT_EQ(why("robot 1 wheel = round"), "no program of this run has `wheel`");
  EXPECT_EQ(why("robot 1 active_task = moveto"), "");
  EXPECT_EQ(why("robot 1 nothing goes to Return"),
            "no program of this run has such a transition of `nothing`");
}

TEST(Condition, SaysThatNoProgramHasTheState) {
  WrittenRun written("forage/forage.mdl");
  const auto why = [&](const std::string& text) {
    return Condition::parse(text)->why_never(written.run()).value_or("");
  };
  EXPECT_EQ(why("any robot in state Acquiring"), "");
  EXPECT_EQ(why("robot 1 in state Acquiring"), "");
  EXPECT_EQ(why("any robot in state Acquire"), "no program of this run has a state `Acquire`");
  EXPECT_EQ(why("robot 1 in state Acquire"), "the program of robot 1 has no state `Acquire`");
  EXPECT_EQ(why("robot 99 in state Acquiring"), "there is no robot 99");
}

TEST(Condition, IsMetWhenItBecomesTrueAndNotWhileItIs) {
  WrittenRun written("demo_c/demo_c.mdl", 1, true);
  written.run().post(mission::event::Execute{});
  auto condition = Condition::parse("robot 1 speed > 0.5");
  ASSERT_TRUE(condition);
  int met = 0;
  bool was_fast = false;
  int expected = 0;
  for (int i = 0; i < 1500 && written.step(); ++i) {
    const auto* const robot = written.run().fleet().find({1});
    const bool is_there = robot->life != fleet::RobotLife::kNotStarted;
    const bool is_fast = is_there && geom::length(written.run().world().body(robot->body).velocity) > 0.5;
    expected += is_fast && !was_fast ? 1 : 0;
    was_fast = is_fast;
    if (const auto found = condition->look(written.run())) {
      ++met;
      EXPECT_EQ(found->robot, 1U);
      EXPECT_NE(found->text.find("speed of robot 1 was"), std::string::npos) << found->text;
    }
  }
  EXPECT_GT(expected, 1);
  EXPECT_EQ(met, expected);
}

// Each moment that it finds of a run, and where breakpoints that ask the same halt it.
void compare(const std::string& mission, const std::string& text, const Breakpoint& same) {
  WrittenRun written(mission, 1, true);
  written.run().post(mission::event::Execute{});
  auto condition = Condition::parse(text);
  ASSERT_TRUE(condition) << condition.error();
  EXPECT_EQ(condition->why_never(written.run()).value_or(""), "");
  BreakpointTable table;
  std::string error;
  ASSERT_NE(table.set(same, error), 0U) << error;
  table.begin(&written.run());
  int met = 0;
  for (int i = 0; i < 3000 && written.step(); ++i) {
    Halted halted;
    table.look(written.run(), halted);
    const auto found = condition->look(written.run());
    ASSERT_EQ(found.has_value(), !halted.hits().empty()) << "in cycle " << written.run().cycle();
    if (!found) continue;
    ++met;
    EXPECT_EQ(found->text, halted.hits(0).text());
    if (same.has_transition()) {
      EXPECT_TRUE(Condition::parse(found->text)) << "what is told can be looked for: " << found->text;
    }
  }
  EXPECT_GT(met, 0);
}

TEST(Condition, FindsWhereABreakpointOfTheSameWouldHaltTheRun) {
  Breakpoint word;
  word.mutable_condition()->set_port("active_task");
  word.mutable_condition()->set_value("occupy");
  compare("demo_c/demo_c.mdl", "any robot active_task = occupy", word);
  Breakpoint number;
  number.add_robots(2);
  number.mutable_condition()->set_port("navigation");
  number.mutable_condition()->set_comparison(Breakpoint::Condition::GREATER);
  number.mutable_condition()->set_value("0.9");
  compare("demo_c/demo_c.mdl", "robot 2 navigation > 0.9", number);
  Breakpoint transition;
  transition.mutable_transition()->set_sequence("movement");
  transition.mutable_transition()->set_to("Acquiring");
  compare("forage/forage.mdl", "any robot movement goes to Acquiring", transition);
}

TEST(Condition, TakesHeadingsInDegrees) {
  WrittenRun written("demo_c/demo_c.mdl", 1, true);
  written.run().post(mission::event::Execute{});
  auto condition = Condition::parse("any robot heading > 60");
  bool is_found = false;
  for (int i = 0; i < 1500 && !is_found && written.step(); ++i)
    is_found = condition->look(written.run()).has_value();
  EXPECT_TRUE(is_found);
}

}  // namespace
}  // namespace mlab::console
