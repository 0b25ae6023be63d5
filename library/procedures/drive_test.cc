#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "../testing/library_probe.h"
#include "mlab/schema/constants.h"

namespace mlab::library_test {
namespace {

using geom::Vector;

TEST(Drive, MakesAVelocityOfTheVector) {
  flow::BehaviorProbe p = probe("Drive");
  p.set("base_velocity", 5.0).set("max_velocity", 7.0).set("v", Vector{0.6, 0.8}).step();
  EXPECT_TRUE(p.action.drives);
  EXPECT_FALSE(p.action.spins);
  EXPECT_EQ(p.action.velocity, (Vector{3.0, 4.0, 0.0}));
}

TEST(Drive, CutsToTheMaximumAndInCautiousModeNearABrokenMarginToLess) {
  flow::BehaviorProbe p = probe("MOVE_ROBOT");
  p.set("base_velocity", 5.0).set("max_velocity", 7.0).set("cautious_velocity", 0.5);
  const auto at = [&](double v, bool cautious) {
    p.set("v", Vector{v, 0.0}).set("cautious_mode", cautious).step();
    return p.action.velocity.x;
  };
  EXPECT_DOUBLE_EQ(at(2.0, false), 7.0);
  EXPECT_DOUBLE_EQ(at(2.0, true), 7.0);
  EXPECT_DOUBLE_EQ(at(schema::kInfinity, false), 7.0);
  EXPECT_DOUBLE_EQ(at(schema::kInfinity, true), 0.5);
}

TEST(Drive, PassesOnAVectorThatIsNoNumberSoThatTheFaultIsSeen) {
  flow::BehaviorProbe p = probe("DRIVE");
  p.set("v", Vector{std::numeric_limits<double>::quiet_NaN(), 0.0}).step();
  EXPECT_TRUE(std::isnan(p.action.velocity.x));
}

TEST(DriveAndSpin, TurnsByTheThirdComponent) {
  flow::BehaviorProbe p = probe("DRIVE_W_SPIN");
  p.set("base_velocity", 1.0).set("max_velocity", 1.0).set("v", Vector{0.5, 0.0, 0.0}).step();
  EXPECT_FALSE(p.action.spins);
  EXPECT_DOUBLE_EQ(p.action.velocity.x, 0.5);
  p.set("v", Vector{0.0, 0.0, -0.3}).step();
  EXPECT_TRUE(p.action.spins);
  EXPECT_DOUBLE_EQ(p.action.spin, -0.3);
}

TEST(Spin, IsAVectorForIt) {
  flow::BehaviorProbe p = probe("Spin");
  p.set("rate", 0.5).step();
  EXPECT_EQ(p.output<Vector>(), (Vector{0.0, 0.0, 0.5}));
}

}  // namespace
}  // namespace mlab::library_test
