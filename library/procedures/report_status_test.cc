#include <utility>

#include <gtest/gtest.h>

#include "../testing/library_probe.h"

namespace mlab::library_test {
namespace {

using geom::Vector;
using percept::Task;

flow::BehaviorProbe reporter(Task task) {
  flow::BehaviorProbe p = probe("ReportStatus");
  p.percepts.order.task = task;
  p.percepts.order.sequence = 3;
  return p;
}

TEST(ReportStatus, TellsHowFarAMoveToIs) {
  flow::BehaviorProbe p = reporter(Task::kMoveTo);
  p.set("unit_goal", Vector{30.0, 40.0}).set("offset", Vector{99.0, 0.0}).step();
  EXPECT_EQ(p.action.status.sequence, 3U);
  EXPECT_FALSE(p.action.status.done);
  EXPECT_DOUBLE_EQ(p.action.status.remaining, 40.0);
  p.set("unit_goal", Vector{6.0, 8.0}).step();
  EXPECT_TRUE(p.action.status.done);
  EXPECT_DOUBLE_EQ(p.action.status.remaining, 0.0);
}

TEST(ReportStatus, StaysDoneThoughTheRobotDriftsAway) {
  flow::BehaviorProbe p = reporter(Task::kMoveTo);
  p.set("unit_goal", Vector{}).step();
  p.set("unit_goal", Vector{500.0, 0.0}).step();
  EXPECT_TRUE(p.action.status.done);
  EXPECT_DOUBLE_EQ(p.action.status.remaining, 0.0);
}

TEST(ReportStatus, BeginsAnewWithTheNextCommand) {
  flow::BehaviorProbe p = reporter(Task::kMoveTo);
  p.set("unit_goal", Vector{}).step();
  p.percepts.order.sequence = 4;
  p.set("unit_goal", Vector{500.0, 0.0}).step();
  EXPECT_EQ(p.action.status.sequence, 4U);
  EXPECT_FALSE(p.action.status.done);
}

TEST(ReportStatus, WantsTheStationOfAnOccupy) {
  flow::BehaviorProbe p = reporter(Task::kOccupy);
  p.set("offset", Vector{0.0, 12.0}).step();
  EXPECT_FALSE(p.action.status.done);
  EXPECT_DOUBLE_EQ(p.action.status.remaining, 2.0);
  p.set("offset", Vector{0.0, 10.0}).step();
  EXPECT_TRUE(p.action.status.done);
}

TEST(ReportStatus, IsDoneWithATeleoperationWhenTheOperatorSaysSo) {
  flow::BehaviorProbe p = reporter(Task::kTeleoperate);
  p.step();
  EXPECT_FALSE(p.action.status.done);
  p.set("teleoperation_complete", true).step();
  EXPECT_TRUE(p.action.status.done);
}

TEST(ReportStatus, HasNothingToTellWithoutACommand) {
  flow::BehaviorProbe p = reporter(Task::kNone);
  p.percepts.order.sequence = 0;
  p.step();
  EXPECT_EQ(p.action.status.sequence, 0U);
  EXPECT_FALSE(p.action.status.done);
}

TEST(ReportArrival, IsDoneWithinTheRadiusOfTheGoalAndStaysDone) {
  flow::BehaviorProbe p = probe("ReportArrival");
  p.percepts.order.task = Task::kMoveTo;
  p.percepts.order.sequence = 3;
  p.set("goal", Vector{3.0, 4.0}).set("success_radius", 2.0).step();
  EXPECT_EQ(p.action.status.sequence, 3U);
  EXPECT_FALSE(p.action.status.done);
  EXPECT_DOUBLE_EQ(p.action.status.remaining, 3.0);
  p.set("goal", Vector{1.0, 0.0}).step();
  EXPECT_TRUE(p.action.status.done);
  p.set("goal", Vector{9.0, 0.0}).step();
  EXPECT_TRUE(p.action.status.done) << "once done";
  p.percepts.order.sequence = 4;
  p.step();
  EXPECT_FALSE(p.action.status.done) << "another command";
}

TEST(ReportArrival, TakesTheRestOfTheRouteForFollowAndTheOperatorForTeleoperate) {
  flow::BehaviorProbe p = probe("ReportArrival");
  p.percepts.order.task = Task::kFollow;
  p.percepts.order.sequence = 1;
  p.set("goal", Vector{}).set("route_remaining", 40.0).step();
  EXPECT_FALSE(p.action.status.done);
  p.set("route_remaining", 0.5).step();
  EXPECT_TRUE(p.action.status.done);
  p.percepts.order.task = Task::kTeleoperate;
  p.percepts.order.sequence = 2;
  p.step();
  EXPECT_FALSE(p.action.status.done);
  p.percepts.joystick.complete = true;
  p.step();
  EXPECT_TRUE(p.action.status.done);
}

TEST(ReportFlags, TakesTheFlagOfTheCommand) {
  constexpr std::pair<Task, const char*> kFlags[] = {{Task::kMoveTo, "move_to_done"},
                                                     {Task::kSweepTo, "move_to_done"},
                                                     {Task::kFollow, "follow_done"},
                                                     {Task::kOccupy, "occupy_done"},
                                                     {Task::kTeleoperate, "teleoperate_done"}};
  for (const auto& [task, flag] : kFlags) {
    flow::BehaviorProbe p = probe("PUT_STATUS");
    p.percepts.order.sequence = 1;
    p.percepts.order.task = task;
    p.percepts.order.goal = {3.0, 4.0};
    p.step();
    EXPECT_FALSE(p.action.status.done);
    EXPECT_DOUBLE_EQ(p.action.status.remaining, 5.0);
    p.set(flag, true).step();
    EXPECT_TRUE(p.action.status.done);
    p.set(flag, false).step();
    EXPECT_TRUE(p.action.status.done);
  }
}

TEST(ReportDone, TellsThatTheCommandInForceIsDone) {
  flow::BehaviorProbe p = probe("ReportDone");
  p.percepts.order.sequence = 7;
  p.step();
  EXPECT_EQ(p.action.status.sequence, 7U);
  EXPECT_TRUE(p.action.status.done);
}

TEST(ReportStep, TellsThatLessRemainsOnceEachTimeItStarts) {
  flow::BehaviorProbe p = probe("ReportStep");
  p.percepts.order.sequence = 7;
  p.step();
  EXPECT_EQ(p.action.status.sequence, 7U);
  EXPECT_FALSE(p.action.status.done);
  const double before = p.action.status.remaining;
  EXPECT_LT(before, 0.0) << "no length that anybody would take for a distance";
  p.step();
  EXPECT_EQ(p.action.status.sequence, 0U) << "tells nothing";
  p.skip();
  p.step();
  EXPECT_LT(p.action.status.remaining, before);
}

}  // namespace
}  // namespace mlab::library_test
