#include "mlab/robot/program/program_runner.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/cell/testing/permission.h"
#include "mlab/robot/program/program_runners.h"

namespace mlab::robot {
namespace {

// @param built  the program of another version
RobotProgram standard_robot(const std::string& base_velocity, const RobotProgram* built = nullptr) {
  text::Diagnostics sink;
  const std::vector<Setting> settings = {{"base_velocity", base_velocity, {}, {}}};
  auto out = load_program("robot", {}, settings, {cell::testing::code_permitted()}, {}, sink, built);
  EXPECT_TRUE(out) << text::render(sink);
  return out ? std::move(*out) : RobotProgram{};
}

/// A robot on its way to somewhere, with a run's runner.
class Running : public ::testing::Test {
 protected:
  Running() { EXPECT_EQ(runner().start(member_), std::nullopt); }

  ProgramRunner& runner() { return *runner_; }
  ProgramRunner::Member member() const { return member_; }
  double number(const char* port) const {
    const Workings robot = runner_->workings(member_);
    return flow::Program::number(robot.frame, *robot.program->find(port)).value_or(-1.0);
  }
  void act(int cycles) {
    for (int i = 0; i < cycles; ++i) {
      runner().join(member_);
      runner().open();
      runner().act({&turn_, 1});
      runner().ask();
      runner().wait({});
    }
  }
  const RobotProgram& program() const { return program_; }

 private:
  RobotProgram program_ = standard_robot("0.2");
  ProgramRunners runners_{7, 1};
  ProgramRunner* runner_ = runners_.runner_of(program_);
  ProgramRunner::Member member_ = runner_->add({3}, program_);
  percept::Percepts percepts_;
  percept::Action action_;
  std::string fault_;
  std::string failure_;
  ProgramRunner::Turn turn_{member_, &percepts_, &action_, &fault_, &failure_};
};

TEST_F(Running, ARestoredRobotGoesOnExactlyFromThere) {
  act(5);
  const flow::Frame saved = runner().save(member());
  act(5);
  const flow::Frame later = runner().save(member());
  EXPECT_FALSE(later == saved);
  ASSERT_TRUE(runner().restore(member(), saved));
  EXPECT_TRUE(runner().save(member()) == saved);
  act(5);
  EXPECT_TRUE(runner().save(member()) == later);
  EXPECT_FALSE(runner().restore(member(), flow::Frame(saved.size() + 8))) << "of another program";
}

TEST_F(Running, WhatAPersonSetOutlivesANewStart) {
  EXPECT_EQ(runner().set(member(), "base_velocity", "0.7"), std::nullopt);
  EXPECT_EQ(number("base_velocity"), 0.7);
  EXPECT_EQ(runner().start(member()), std::nullopt);
  EXPECT_EQ(number("base_velocity"), 0.7);
  EXPECT_EQ(runner().set(member(), "no_such", "1"), "the program of robot 3 has no `no_such`");
}

TEST_F(Running, AnotherVersionOfItsProgramChangesWhatItSetsDifferently) {
  EXPECT_EQ(runner().set(member(), "max_velocity", "3"), std::nullopt);
  const RobotProgram faster = standard_robot("0.5", &program());
  ASSERT_TRUE(runner().take_over(member(), faster, true));
  EXPECT_EQ(number("base_velocity"), 0.5);
  EXPECT_EQ(number("max_velocity"), 3.0) << "both versions say the same, so it is the robot's own";
  EXPECT_FALSE(runner().take_over(member(), RobotProgram{}, true)) << "that is not its program";
}

TEST(ProgramRunners, HaveNoneForAProgramThatNobodyAnswersTo) {
  EXPECT_EQ(ProgramRunners(1, 1).runner_of(RobotProgram{}), nullptr);
}

}  // namespace
}  // namespace mlab::robot
