#include <vector>

#include <gtest/gtest.h>

#include "../testing/library_probe.h"
#include "mlab/schema/constants.h"

namespace mlab::library_test {
namespace {

using geom::Vector;
using percept::ObjectReading;

Vector avoid(const std::vector<ObjectReading>& objects) {
  flow::BehaviorProbe p = probe("AvoidObjects");
  p.percepts.objects = objects;
  p.set("objects", all<flow::Objects>(objects.size())).set("sphere", 1.0).set("safety_margin", 0.5).step();
  return p.output<Vector>();
}

TEST(AvoidObjects, MeasuresFromTheEdge) {
  EXPECT_DOUBLE_EQ(avoid({{.id = {1}, .center = {3.0, 0.0}, .radius = 2.0}}).x, -0.5);
  EXPECT_DOUBLE_EQ(avoid({{.id = {1}, .center = {3.5, 0.0}, .radius = 2.0}}).x, 0.0);
}

TEST(AvoidObjects, IsAbsoluteWithinTheMarginAndInside) {
  EXPECT_DOUBLE_EQ(avoid({{.id = {1}, .center = {2.5, 0.0}, .radius = 2.0}}).x, -schema::kInfinity);
  EXPECT_DOUBLE_EQ(avoid({{.id = {1}, .center = {0.0, 1.0}, .radius = 2.0}}).y, -schema::kInfinity);
}

TEST(AvoidObjects, BacksAwayFromAnObjectThatItStandsOn) {
  EXPECT_EQ(avoid({{.id = {1}, .center = {}, .radius = 2.0}}), (Vector{-schema::kInfinity, 0.0, 0.0}));
}

TEST(AvoidObjects, WantsNothingWithoutObjects) {
  EXPECT_EQ(avoid({}), Vector{});
}

}  // namespace
}  // namespace mlab::library_test
