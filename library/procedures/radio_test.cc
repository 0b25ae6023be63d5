#include <vector>

#include <gtest/gtest.h>

#include "../testing/library_probe.h"

namespace mlab::library_test {
namespace {

using geom::Vector;
using percept::RadioContact;

const std::vector<RadioContact> kContacts = {{{2}, {0, 10}, 60.0, false}, {{3}, {-30, 0}, 20.0, true}};

TEST(SignalStrength, IsOfWhoIsHeardBest) {
  flow::BehaviorProbe p = probe("SignalStrength");
  p.step();
  EXPECT_EQ(p.output<double>(), 0.0);
  p.percepts.radio = kContacts;
  p.step();
  EXPECT_EQ(p.output<double>(), 60.0);
  p.set("heard", 1).step();
  EXPECT_EQ(p.output<double>(), 20.0);
  p.set("heard", 2).step();
  EXPECT_EQ(p.output<double>(), 60.0);
}

TEST(IsSignalStrong, AndIsSignalWeakAreOpposites) {
  for (const double threshold : {10.0, 20.0, 40.0, 60.0, 80.0}) {
    for (const int heard : {0, 1, 2}) {
      flow::BehaviorProbe strong = probe("IsSignalStrong");
      flow::BehaviorProbe weak = probe("IsSignalWeak");
      for (flow::BehaviorProbe* one : {&strong, &weak}) {
        one->percepts.radio = kContacts;
        one->set("threshold", threshold).set("heard", heard).step();
      }
      EXPECT_EQ(strong.output<bool>(), threshold <= (heard == 1 ? 20.0 : 60.0));
      EXPECT_NE(strong.output<bool>(), weak.output<bool>());
    }
  }
}

TEST(SeekSignal, LeadsBackAndStaysWhereItIsStrong) {
  flow::BehaviorProbe p = probe("SeekSignal");
  p.percepts.radio = kContacts;
  p.step();
  EXPECT_EQ(p.output<Vector>(), Vector{});
  p.percepts.radio = {};
  p.percepts.pose.position = {10.0, 0.0};
  p.step();
  expect_near(p.output<Vector>(), {-1.0, 0.0, 0.0});
  p.skip();
  p.step();
  EXPECT_EQ(p.output<Vector>(), Vector{}) << "it has begun anew, and remembers nothing";
}

TEST(SeekSignal, IsDrawnToWhoIsHeardByPreservation) {
  flow::BehaviorProbe p = probe("SeekSignal");
  p.percepts.radio = kContacts;
  p.set("method", 1).set("wanted", 80.0).step();
  expect_near(p.output<Vector>(), {0.0, 0.25, 0.0});
}

TEST(IsSignalAdviceSure, ComparesTheConfidenceOfTheMethod) {
  for (const auto& [method, sure] : {std::pair{0, false}, {1, false}, {2, true}, {3, false}, {4, true}}) {
    flow::BehaviorProbe p = probe("IsSignalAdviceSure");
    p.set("method", method).set("threshold", 0.2).step();
    EXPECT_EQ(p.output<bool>(), sure) << "nobody was ever heard: there is the plan alone; method " << method;
  }
  flow::BehaviorProbe p = probe("IsSignalAdviceSure");
  p.percepts.radio = kContacts;
  p.set("method", 1).set("threshold", 1.0).step();
  EXPECT_TRUE(p.output<bool>());
}

}  // namespace
}  // namespace mlab::library_test
