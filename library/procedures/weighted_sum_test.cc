#include <vector>

#include <gtest/gtest.h>

#include "../testing/library_probe.h"
#include "mlab/schema/constants.h"

namespace mlab::library_test {
namespace {

using geom::Vector;

Vector sum(const std::vector<Vector>& members, const std::vector<double>& gains) {
  flow::BehaviorProbe p = probe("WeightedSum");
  p.set_list("members", members).set_list("gains", gains).step();
  return p.output<Vector>();
}

TEST(WeightedSum, AddsMembersTimesGains) {
  EXPECT_EQ(sum({{1.0, 2.0, 4.0}, {1.0, 0.0}}, {0.5, -2.0}), (Vector{-1.5, 1.0, 2.0}));
}

TEST(WeightedSum, OfNothingIsZero) {
  EXPECT_EQ(sum({}, {}), Vector{});
}

TEST(WeightedSum, CountsAMemberWithoutGainOnce) {
  EXPECT_EQ(sum({{1.0, 0.0}, {0.0, 1.0}}, {3.0}), (Vector{3.0, 1.0, 0.0}));
}

TEST(WeightedSum, KeepsAbsoluteDemandsFiniteAndLetsZeroSilenceThem) {
  EXPECT_EQ(sum({{schema::kInfinity, 0.0}}, {1.5}), (Vector{1.5e12, 0.0, 0.0}));
  EXPECT_EQ(sum({{schema::kInfinity, 0.0}, {0.0, 1.0}}, {0.0, 1.0}), (Vector{0.0, 1.0, 0.0}));
}

TEST(WeightedSum, LetsTheGoalDecideWhereAbsoluteDemandsCancel) {
  EXPECT_EQ(sum({{0.0, schema::kInfinity}, {1.0, 0.0}, {0.0, -schema::kInfinity}}, {1.5, 0.8, 1.5}),
            (Vector{0.8, 0.0, 0.0}));
}

TEST(WeightedSum, HasItsHistoricNames) {
  EXPECT_EQ(behavior("COOP").name, "WeightedSum");
  EXPECT_EQ(behavior("SUM_WEIGHTED_VECTORS").name, "WeightedSum");
}

TEST(Arbiter, LetsTheMostActiveThrough) {
  flow::BehaviorProbe p = probe("Arbiter");
  p.set_list<Vector>("members", {{1.0, 0.0}, {0.0, 1.0}, {2.0, 0.0}})
      .set_list<double>("activations", {0.2, 0.9, 0.9})
      .step();
  EXPECT_EQ(p.output<Vector>(), (Vector{0.0, 1.0, 0.0}));
  p.set_list<double>("activations", {}).step();
  EXPECT_EQ(p.output<Vector>(), (Vector{2.0, 0.0, 0.0}));
  p.set_list<double>("activations", {0.0, 0.0, 0.0}).step();
  EXPECT_EQ(p.output<Vector>(), Vector{});
}

TEST(FirstActive, LetsTheMostUrgentThrough) {
  flow::BehaviorProbe p = probe("FirstActive");
  p.set_list<Vector>("members", {{0.0, 0.0}, {0.0, 1.0}, {2.0, 0.0}}).step();
  EXPECT_EQ(p.output<Vector>(), (Vector{0.0, 1.0, 0.0}));
  p.set_list<Vector>("members", {}).step();
  EXPECT_EQ(p.output<Vector>(), Vector{});
}

}  // namespace
}  // namespace mlab::library_test
