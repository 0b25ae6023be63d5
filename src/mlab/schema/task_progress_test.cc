#include "mlab/schema/task_progress.h"

#include <limits>

#include <gtest/gtest.h>

namespace mlab::schema {
namespace {

using percept::Task;

TaskMeasures measures(double goal, double station) {
  return {.goal_distance = goal,
          .route_remaining = 55.0,
          .station_error = station,
          .success_radius = 10.0,
          .slop = 10.0,
          .teleoperation_complete = false};
}

TEST(TaskProgress, OfMoveToAsksOnlyForTheGoal) {
  EXPECT_FALSE(task_progress(Task::kMoveTo, measures(25.0, 99.0)).done);
  EXPECT_DOUBLE_EQ(task_progress(Task::kMoveTo, measures(25.0, 99.0)).remaining, 15.0);
  EXPECT_TRUE(task_progress(Task::kMoveTo, measures(10.0, 99.0)).done);
  EXPECT_DOUBLE_EQ(task_progress(Task::kSweepTo, measures(3.0, 0.0)).remaining, 0.0);
}

TEST(TaskProgress, OfOccupyAsksForTheStationAsWell) {
  EXPECT_FALSE(task_progress(Task::kOccupy, measures(10.0, 11.0)).done);
  EXPECT_DOUBLE_EQ(task_progress(Task::kOccupy, measures(12.0, 13.0)).remaining, 5.0);
  EXPECT_TRUE(task_progress(Task::kOccupy, measures(10.0, 10.0)).done);
}

TEST(TaskProgress, OfFollowIsTheWayThatIsLeft) {
  EXPECT_DOUBLE_EQ(task_progress(Task::kFollow, measures(0.0, 0.0)).remaining, 45.0);
  EXPECT_FALSE(task_progress(Task::kFollow, measures(0.0, 0.0)).done);
}

TEST(TaskProgress, OfTeleoperationIsTheOperatorsToSay) {
  TaskMeasures m = measures(0.0, 0.0);
  EXPECT_FALSE(task_progress(Task::kTeleoperate, m).done);
  EXPECT_GT(task_progress(Task::kTeleoperate, m).remaining, 0.0);
  m.teleoperation_complete = true;
  EXPECT_TRUE(task_progress(Task::kTeleoperate, m).done);
  EXPECT_DOUBLE_EQ(task_progress(Task::kTeleoperate, m).remaining, 0.0);
}

TEST(TaskProgress, OfStartAndStopIsDoneAtOnceAndOfNoTaskNever) {
  EXPECT_TRUE(task_progress(Task::kStart, measures(99.0, 99.0)).done);
  EXPECT_TRUE(task_progress(Task::kStop, measures(99.0, 99.0)).done);
  EXPECT_FALSE(task_progress(Task::kNone, measures(0.0, 0.0)).done);
}

TEST(TaskProgress, OfWhatAUnitSharesChangesOnAWayThatLeadsNoFarther) {
  TaskMeasures now = measures(0.0, 0.0);
  now.way_remaining = 1e6 + 300.0;
  const double before = task_progress(Task::kPatrol, now).remaining;
  now.way_remaining -= 100.0;
  EXPECT_NEAR(task_progress(Task::kPatrol, now).remaining, before - 100.0, 1e-3);
}

TEST(TaskProgress, OfWhatAUnitSharesIsInfiniteForWhoCanDoNoMore) {
  TaskMeasures now = measures(0.0, 0.0);
  now.errands_left = -2.0;
  EXPECT_FALSE(task_progress(Task::kVisit, now).done);
  EXPECT_EQ(task_progress(Task::kVisit, now).remaining, std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace mlab::schema
