#include <numbers>

#include <gtest/gtest.h>

#include "../testing/library_probe.h"

namespace mlab::library_test {
namespace {

using geom::Vector;
using percept::Formation;
using percept::FormationReference;

double strength(double error, double dead_zone, double saturation) {
  flow::BehaviorProbe p = probe("MaintainFormation");
  p.set("offset", Vector{0.0, -error})
      .set("dead_zone_radius", dead_zone)
      .set("saturation_length", saturation)
      .step();
  EXPECT_DOUBLE_EQ(p.output<Vector>().x, 0.0);
  return -p.output<Vector>().y;
}

TEST(MaintainFormation, HasADeadAControlledAndABallisticZone) {
  EXPECT_DOUBLE_EQ(strength(0.0, 5.0, 20.0), 0.0);
  EXPECT_DOUBLE_EQ(strength(5.0, 5.0, 20.0), 0.0);
  EXPECT_DOUBLE_EQ(strength(15.0, 5.0, 20.0), 0.5);
  EXPECT_DOUBLE_EQ(strength(25.0, 5.0, 20.0), 1.0);
  EXPECT_DOUBLE_EQ(strength(500.0, 5.0, 20.0), 1.0);
}

TEST(MaintainFormation, IsAStepWithoutAControlledZone) {
  EXPECT_DOUBLE_EQ(strength(5.0, 5.0, 0.0), 0.0);
  EXPECT_DOUBLE_EQ(strength(5.1, 5.0, 0.0), 1.0);
}

// Balch and Arkin 1998: controlled zone of 25 m and no dead zone; break-even with the goal's .8 at 20 m.
TEST(MaintainFormation, BreaksEvenWithTheGoalAt20Metres) {
  EXPECT_DOUBLE_EQ(strength(20.0, 0.0, 25.0), 0.8);
}

TEST(InPosition, HoldsUpToTheSlop) {
  flow::BehaviorProbe p = probe("InPosition");
  p.set("slop", 10.0).set("offset", Vector{6.0, 8.0}).step();
  EXPECT_TRUE(p.output<bool>());
  p.set("offset", Vector{6.0, 8.01}).step();
  EXPECT_FALSE(p.output<bool>());
}

class FormationHeading : public testing::Test {
 protected:
  double at(Vector goal) {
    p_.set("goal", goal).step();
    return p_.output<double>();
  }
  flow::BehaviorProbe p_ = probe("DetectFormationHeading");
};

TEST_F(FormationHeading, IsTheDirectionOfAFarGoal) {
  EXPECT_NEAR(at({0.0, 100.0}), kNorth, 1e-12);
  EXPECT_NEAR(at({-500.0, 0.0}), std::numbers::pi, 1e-12);
}

TEST_F(FormationHeading, StaysInTheWorldNearTheGoalThoughTheRobotTurns) {
  at({0.0, 100.0});
  p_.percepts.pose.heading = 0.5;
  EXPECT_NEAR(at({99.0, 0.0}), kNorth - 0.5, 1e-12);
}

TEST_F(FormationHeading, StartsAsTheUnitLooks) {
  p_.percepts.unit.formation_heading = 1.0;
  p_.percepts.pose.heading = 0.25;
  EXPECT_NEAR(at({1.0, 0.0}), 0.75, 1e-12);
}

TEST_F(FormationHeading, IsThatOfTheUnitWhenTheRobotComesIntoAnother) {
  at({0.0, 100.0});
  p_.percepts.unit.size = 4;
  p_.percepts.unit.formation_heading = 1.0;
  EXPECT_NEAR(at({1.0, 0.0}), 1.0, 1e-12);
}

TEST_F(FormationHeading, FollowsADeflectedStick) {
  p_.set("stick", Vector{0.0, -1.0}).set("stick_magnitude", 0.5);
  EXPECT_NEAR(at({500.0, 0.0}), -kNorth, 1e-12);
  p_.set("stick_magnitude", 0.001);
  EXPECT_NEAR(at({1.0, 0.0}), -kNorth, 1e-12);
  EXPECT_NEAR(at({500.0, 0.0}), 0.0, 1e-12);
}

TEST_F(FormationHeading, ObeysTheHeadingOfTheCommandFirst) {
  p_.percepts.order.has_heading = true;
  p_.percepts.order.heading = 2.0;
  p_.percepts.pose.heading = 0.5;
  p_.set("stick", Vector{0.0, -1.0}).set("stick_magnitude", 0.5);
  EXPECT_NEAR(at({500.0, 0.0}), 1.5, 1e-12);
}

TEST_F(FormationHeading, HasADirectionEvenAtTheGoal) {
  p_.set("trigger", 0.0);
  EXPECT_DOUBLE_EQ(at({}), 0.0);
}

flow::BehaviorProbe member(int rank, Formation formation) {
  flow::BehaviorProbe p = probe("DetectFormationPosition");
  p.percepts.unit.size = 4;
  p.percepts.unit.rank = static_cast<std::uint16_t>(rank);
  p.set("formation", formation).set("spacing", 50.0).set("heading", 0.0);
  return p;
}

TEST(DetectFormationPosition, SumsToZeroOverATeamAroundItsCentre) {
  for (const Formation formation :
       {Formation::kLine, Formation::kColumn, Formation::kWedge, Formation::kDiamond}) {
    Vector sum;
    for (int rank = 0; rank < 4; ++rank) {
      flow::BehaviorProbe p = member(rank, formation);
      p.step();
      EXPECT_GT(geom::length(p.output<Vector>()), 1.0);
      sum += p.output<Vector>();
    }
    EXPECT_NEAR(geom::length(sum), 0.0, 1e-9);
  }
}

TEST(DetectFormationPosition, IsZeroForEveryRobotInItsPlace) {
  for (int rank = 0; rank < 4; ++rank) {
    flow::BehaviorProbe p = member(rank, Formation::kDiamond);
    const Vector place = percept::station(Formation::kDiamond, rank, 4, 50.0);
    p.percepts.pose.position = {place.x, place.y};
    p.step();
    EXPECT_NEAR(geom::length(p.output<Vector>()), 0.0, 1e-9);
  }
}

TEST(DetectFormationPosition, MeasuresFromTheLeaderWhereThatIsTheReference) {
  flow::BehaviorProbe p = member(3, Formation::kColumn);
  p.percepts.unit.leader.position = {200.0, 30.0};
  p.percepts.unit.center = {1e3, 1e3};
  p.set("reference", FormationReference::kLeader).step();
  EXPECT_NEAR(p.output<Vector>().x, 50.0, 1e-9);
  EXPECT_NEAR(p.output<Vector>().y, 30.0, 1e-9);
}

TEST(DetectFormationPosition, IsZeroWithoutAFormation) {
  flow::BehaviorProbe p = member(1, Formation::kNone);
  p.percepts.unit.center = {70.0, 0.0};
  p.step();
  EXPECT_EQ(p.output<Vector>(), Vector{});
}

TEST(ComputeFormationPosition, PredictsTheCentreFromItsLastStep) {
  flow::BehaviorProbe p = probe("ComputeFormationPosition");
  p.set("formation", Formation::kColumn).set("unit_size", 2).set("spacing", 50.0).set("heading", 0.0);
  p.set("unit_center", Vector{0.0, 0.0}).step();
  EXPECT_NEAR(p.output<Vector>().x, 25.0, 1e-9);
  p.set("unit_center", Vector{2.0, 0.0}).step();
  EXPECT_NEAR(p.output<Vector>().x, 29.0, 1e-9);
  p.step();
  EXPECT_NEAR(p.output<Vector>().x, 27.0, 1e-9);
}

}  // namespace
}  // namespace mlab::library_test
