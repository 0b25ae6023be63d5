// What becomes of goals, by what a navigator tells of them; where they lie is in ros2_device_test.cc.

#include "mlab/ros2/goals.h"

#include <chrono>

#include <gtest/gtest.h>

namespace mlab::ros2 {
namespace {

using std::chrono::milliseconds;

GoalId somebody_elses(std::uint8_t number) {
  GoalId out;
  out.bytes[0] = number;
  return out;
}

class GoalsTest : public ::testing::Test {
 protected:
  std::optional<Goal> ask(int after_millis) {
    now += milliseconds(after_millis);
    return goals.next({0.5, 0.0}, {}, "odom", {}, now);
  }
  void tell(const std::vector<GoalStatus>& states) {
    Heard heard;
    heard.goals = states;
    goals.take(heard, now);
  }
  void pass(int millis) {
    now += milliseconds(millis);
    goals.take(Heard{}, now);
  }

  Goals goals{1.0, 0.5, 1};
  vehicle::Clock::time_point now{std::chrono::hours(1)};
};

TEST_F(GoalsTest, AreSentAnewOnceTheyHaveEnded) {
  const auto first = ask(0);
  ASSERT_TRUE(first);
  EXPECT_FALSE(ask(600)) << "it has not moved";
  tell({{GoalId{}, GoalState::kAborted}});
  EXPECT_FALSE(ask(0)) << "that was somebody else's";
  tell({{first->id, GoalState::kAborted}});
  EXPECT_EQ(goals.problem(), "finds no way to where it is to go");
  const auto second = ask(0);
  ASSERT_TRUE(second);
  EXPECT_NE(second->id, first->id);
  EXPECT_NE(Goals(1.0, 0.5, 2).next({0.5, 0.0}, {}, "odom", {}, now)->id, first->id);
}

TEST_F(GoalsTest, AreNotTakenWhereTheNavigatorTellsOfNoneForTwoSeconds) {
  const auto first = ask(0);
  tell({{somebody_elses(7), GoalState::kSucceeded}});
  pass(1900);
  EXPECT_EQ(goals.problem(), "");
  EXPECT_FALSE(ask(0));
  pass(200);
  EXPECT_EQ(goals.problem(), "does not take the goals that it is given");
  const auto second = ask(0);
  ASSERT_TRUE(second) << "it is tried again";
  tell({{second->id, GoalState::kAccepted}});
  EXPECT_EQ(goals.problem(), "");
}

TEST_F(GoalsTest, AreKnownByFeedbackToo) {
  const auto first = ask(0);
  Heard heard;
  heard.feedback = {{first->id, 1}};
  goals.take(heard, now);
  EXPECT_EQ(goals.problem(), "is held up on its way, and tries to get free");
  heard.feedback = {{first->id, 0}, {somebody_elses(1), 4}};
  goals.take(heard, now);
  EXPECT_EQ(goals.problem(), "");
}

TEST_F(GoalsTest, AreTakenBackUntilTheNavigatorSaysThatTheyAreOver) {
  const auto first = ask(0);
  goals.drop();
  EXPECT_EQ(goals.to_take_back(now), std::vector{first->id}) << "it may be on its way";
  tell({{first->id, GoalState::kExecuting}});
  now += milliseconds(5000);
  EXPECT_EQ(goals.to_take_back(now), std::vector{first->id});
  tell({{first->id, GoalState::kCanceling}});
  EXPECT_TRUE(goals.to_take_back(now).empty());
  const auto lost = ask(600);
  goals.drop();
  now += milliseconds(2100);
  EXPECT_TRUE(goals.to_take_back(now).empty()) << "it was not taken";
  tell({{lost->id, GoalState::kAccepted}});
  EXPECT_EQ(goals.to_take_back(now), std::vector{lost->id}) << "it was, late";
}

TEST_F(GoalsTest, OfAProcessBeforeThisOneAreTakenBackAndNobodyElses) {
  Goals before(1.0, 0.5, 99);
  const GoalId left = before.next({0.5, 0.0}, {}, "odom", {}, now)->id;
  tell({{left, GoalState::kExecuting}, {somebody_elses(3), GoalState::kExecuting}});
  EXPECT_EQ(goals.to_take_back(now), std::vector{left});
}

TEST_F(GoalsTest, OfSomebodyElseTakeItUntilAPersonTakesItBack) {
  const auto own = ask(0);
  tell({{own->id, GoalState::kExecuting}});
  EXPECT_FALSE(goals.is_taken());
  tell({{own->id, GoalState::kAborted}, {somebody_elses(1), GoalState::kExecuting}});
  EXPECT_TRUE(goals.is_taken());
  EXPECT_EQ(goals.problem(), "") << "it had to make room";
  goals.engage();
  EXPECT_FALSE(goals.is_taken());
  tell({{somebody_elses(1), GoalState::kExecuting}, {somebody_elses(2), GoalState::kAccepted}});
  EXPECT_TRUE(goals.is_taken()) << "that one came later";
  tell({{somebody_elses(1), GoalState::kAborted}, {somebody_elses(2), GoalState::kSucceeded}});
  EXPECT_FALSE(goals.is_taken());
  tell({{somebody_elses(1), GoalState::kExecuting}});
  EXPECT_TRUE(goals.is_taken()) << "a word is for what was there";
}

TEST_F(GoalsTest, AreGivenAnewToAnotherNavigator) {
  const auto first = ask(0);
  tell({{first->id, GoalState::kExecuting}, {somebody_elses(1), GoalState::kExecuting}});
  EXPECT_FALSE(ask(600));
  goals.forget();
  EXPECT_TRUE(goals.is_taken()) << "it may have said so already";
  tell({{first->id, GoalState::kExecuting}});
  EXPECT_FALSE(goals.is_taken());
  const auto second = ask(0);
  ASSERT_TRUE(second);
  EXPECT_FALSE(ask(600)) << "the newest was not told of yet";
}

TEST_F(GoalsTest, ThatTheNavigatorForgetsAreGivenAnew) {
  const auto first = ask(0);
  tell({{first->id, GoalState::kExecuting}});
  EXPECT_FALSE(ask(600));
  tell({});
  EXPECT_TRUE(ask(0));
}

TEST_F(GoalsTest, AreKeptAndTakenBackInBounds) {
  Goals before(1.0, 0.5, 99);
  std::vector<GoalStatus> many;
  for (int i = 0; i < 1000; ++i) {
    now += milliseconds(600);
    before.forget();
    many.push_back({before.next({0.5, 0.0}, {}, "odom", {}, now)->id, GoalState::kExecuting});
  }
  tell(many);
  EXPECT_EQ(goals.to_take_back(now).size(), 8U);
}

TEST_F(GoalsTest, LieTwoSecondsAheadAndNotTooNear) {
  EXPECT_EQ(look_ahead_for(1.0), 2.0);
  EXPECT_EQ(look_ahead_for(0.5), 1.0);
  EXPECT_EQ(look_ahead_for(0.1), 0.8);
}

}  // namespace
}  // namespace mlab::ros2
