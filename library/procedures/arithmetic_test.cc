#include <gtest/gtest.h>

#include "../testing/library_probe.h"

namespace mlab::library_test {
namespace {

using geom::Vector;

TEST(ScaleVector, Multiplies) {
  flow::BehaviorProbe p = probe("SCALE_VECTOR");
  p.set("v", Vector{1.0, -2.0, 3.0}).set("multiplier", 0.5).step();
  EXPECT_EQ(p.output<Vector>(), (Vector{0.5, -1.0, 1.5}));
}

TEST(SubtractVectors, TakesTheSecondAway) {
  flow::BehaviorProbe p = probe("SUBTRACT_VECTORS");
  p.set("a", Vector{5.0, 5.0}).set("b", Vector{2.0, 6.0}).step();
  EXPECT_EQ(p.output<Vector>(), (Vector{3.0, -1.0, 0.0}));
}

TEST(Sum, AddsNumbers) {
  flow::BehaviorProbe p = probe("Sum");
  p.set_list<double>("values", {1.5, 2.0, -0.5}).step();
  EXPECT_DOUBLE_EQ(p.output<double>(), 3.0);
  p.set_list<double>("values", {}).step();
  EXPECT_DOUBLE_EQ(p.output<double>(), 0.0);
}

TEST(SumIntegers, StaysWithinItsRange) {
  flow::BehaviorProbe p = probe("SumIntegers");
  p.set_list<int>("values", {1, 2, -7}).step();
  EXPECT_EQ(p.output<int>(), -4);
  p.set_list<int>("values", {2000000000, 2000000000}).step();
  EXPECT_EQ(p.output<int>(), 2147483647);
}

TEST(Length, CountsThePlaneOnly) {
  flow::BehaviorProbe p = probe("Length");
  p.set("v", Vector{3.0, 4.0, 12.0}).step();
  EXPECT_DOUBLE_EQ(p.output<double>(), 5.0);
}

TEST(IsZero, MeansExactlyZero) {
  flow::BehaviorProbe p = probe("V_IS_ZERO");
  p.set("v", Vector{}).step();
  EXPECT_TRUE(p.output<bool>());
  p.set("v", Vector{0.0, 0.0, 1e-30}).step();
  EXPECT_FALSE(p.output<bool>());
}

}  // namespace
}  // namespace mlab::library_test
