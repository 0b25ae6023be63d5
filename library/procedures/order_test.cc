#include <gtest/gtest.h>

#include "../testing/library_probe.h"

namespace mlab::library_test {
namespace {

using geom::Vector;
using percept::FormationReference;
using percept::Task;

TEST(Order, IsReadAsItStands) {
  percept::Percepts percepts;
  percepts.order.goal = {3.0, 4.0};
  percepts.order.task = Task::kOccupy;
  percepts.order.formation = percept::Formation::kWedge;
  flow::BehaviorProbe goal = probe("GetOrderGoal");
  flow::BehaviorProbe task = probe("GetOrderTask");
  flow::BehaviorProbe formation = probe("GetOrderFormation");
  for (flow::BehaviorProbe* p : {&goal, &task, &formation}) {
    p->percepts = percepts;
    p->step();
  }
  EXPECT_EQ(goal.output<geom::Point>(), (geom::Point{3.0, 4.0}));
  EXPECT_EQ(task.output<Task>(), Task::kOccupy);
  EXPECT_EQ(formation.output<percept::Formation>(), percept::Formation::kWedge);
}

TEST(GetActiveTask, IsNoneWhileTheUnitIsHalted) {
  flow::BehaviorProbe p = probe("GetActiveTask");
  p.percepts.order.task = Task::kMoveTo;
  p.step();
  EXPECT_EQ(p.output<Task>(), Task::kMoveTo);
  p.percepts.order.halted = true;
  p.step();
  EXPECT_EQ(p.output<Task>(), Task::kNone);
}

TEST(GetOrderReference, PrefersTheCommandToThePreset) {
  flow::BehaviorProbe p = probe("GetOrderReference");
  p.set("preset", FormationReference::kNeighbor).step();
  EXPECT_EQ(p.output<FormationReference>(), FormationReference::kNeighbor);
  p.percepts.order.reference = FormationReference::kLeader;
  p.step();
  EXPECT_EQ(p.output<FormationReference>(), FormationReference::kLeader);
}

TEST(GetSearchTolerance, ShrinksWithTheSwath) {
  flow::BehaviorProbe p = probe("GetSearchTolerance");
  p.set("most", 0.15).step();
  EXPECT_EQ(p.output<double>(), 0.15);
  p.percepts.order.swath = 1.0;
  p.step();
  EXPECT_DOUBLE_EQ(p.output<double>(), 0.05);
  p.percepts.order.swath = 20.0;
  p.step();
  EXPECT_EQ(p.output<double>(), 0.15);
}

TEST(GetSearchLookahead, ShrinksWithTheSwath) {
  flow::BehaviorProbe p = probe("GetSearchLookahead");
  p.set("most", 2.0).step();
  EXPECT_EQ(p.output<double>(), 2.0);
  for (const auto& [swath, lookahead] : {std::pair{1.0, 0.5}, {5.0, 1.0}, {20.0, 2.0}}) {
    p.percepts.order.swath = swath;
    p.step();
    EXPECT_DOUBLE_EQ(p.output<double>(), lookahead) << swath;
  }
}

TEST(GetOrderMargin, IsThatOfTheWayOfASearch) {
  flow::BehaviorProbe p = probe("GetOrderMargin");
  p.percepts.order.margin = 2.5;
  p.percepts.order.task = Task::kVisit;
  p.set("most", 5.0).step();
  EXPECT_EQ(p.output<double>(), 5.0);
  p.percepts.order.task = Task::kSearch;
  p.step();
  EXPECT_EQ(p.output<double>(), 2.5);
  p.set("most", 1.0).step();
  EXPECT_EQ(p.output<double>(), 1.0);
}

TEST(GetBaseVelocity, MakesTheGoalAlonePullAtTheCruiseSpeed) {
  flow::BehaviorProbe p = probe("GetBaseVelocity");
  p.set("base_velocity", 5.0).set("max_velocity", 7.0).set("goal_gain", 0.8);
  const auto at = [&](double speed) {
    p.percepts.order.speed = speed;
    p.step();
    return p.output<double>();
  };
  EXPECT_DOUBLE_EQ(at(0.0), 5.0);
  EXPECT_DOUBLE_EQ(at(2.0) * 0.8, 2.0);
  EXPECT_DOUBLE_EQ(at(99.0) * 0.8, 7.0);
  p.set("goal_gain", 0.0);
  EXPECT_DOUBLE_EQ(at(2.0), 2.0);
}

TEST(Executive, LetsTheBehaviorOfTheCommandThrough) {
  flow::BehaviorProbe p = probe("EXECUTIVE");
  p.set("move_to", Vector{1.0, 0.0})
      .set("follow", Vector{2.0, 0.0})
      .set("occupy", Vector{3.0, 0.0})
      .set("teleoperate", Vector{4.0, 0.0});
  const auto at = [&](Task task) {
    p.percepts.order.task = task;
    p.step();
    return p.output<Vector>().x;
  };
  EXPECT_EQ(at(Task::kNone), 0.0);
  EXPECT_EQ(at(Task::kStart), 0.0);
  EXPECT_EQ(at(Task::kMoveTo), 1.0);
  EXPECT_EQ(at(Task::kSweepTo), 1.0);
  EXPECT_EQ(at(Task::kFollow), 2.0);
  EXPECT_EQ(at(Task::kOccupy), 3.0);
  EXPECT_EQ(at(Task::kTeleoperate), 4.0);
  EXPECT_EQ(at(Task::kStop), 0.0);
  p.percepts.order.halted = true;
  EXPECT_EQ(at(Task::kMoveTo), 0.0);
}

TEST(IsHalted, SaysSo) {
  flow::BehaviorProbe p = probe("IsHalted");
  p.percepts.order.halted = true;
  p.step();
  EXPECT_TRUE(p.output<bool>());
}

}  // namespace
}  // namespace mlab::library_test
