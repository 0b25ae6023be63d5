#include "mlab/schema/signal.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace mlab::schema {
namespace {

using geom::Point;
using geom::Vector;
using percept::RadioContact;

constexpr double kWanted = 50.0;

// Of a radio that reaches 100 m.
double strength_at(double distance) {
  return distance < 100.0 ? 100.0 * (1.0 - std::log(std::max(distance, 1.0)) / std::log(100.0)) : 0.0;
}

// A robot that looks east, and a base somewhere whose radio reaches 100 m.
struct Walker {
  SignalMemory memory;
  percept::Percepts percepts;
  std::vector<RadioContact> contacts;
  Point base{};

  explicit Walker(Point begin) { percepts.pose.position = begin; }
  void note() {
    contacts.clear();
    const Vector to_base = percepts.pose.to_robot(base);
    const double strength = strength_at(length(to_base));
    if (strength > 0.0) contacts.push_back({{9}, to_base, strength, false});
    percepts.radio = contacts;
    memory.note(percepts, kWanted, Heard::kAnybody);
  }
  void go(Vector step) {
    percepts.pose.position = percepts.pose.point_at(step);
    note();
  }
  SignalMemory::Advice advice(SignalMethod method) const {
    return memory.advice(percepts.pose, method, kWanted);
  }
  double strength() const { return signal_strength(percepts, Heard::kAnybody); }
};

TEST(SignalStrength, IsOfWhoIsHeardBestOfThoseWhoCount) {
  const std::vector<RadioContact> contacts = {{{2}, {1, 0}, 80.0, false}, {{3}, {2, 0}, 40.0, true}};
  percept::Percepts percepts;
  EXPECT_EQ(signal_strength(percepts, Heard::kAnybody), 0.0);
  percepts.radio = contacts;
  EXPECT_EQ(signal_strength(percepts, Heard::kAnybody), 80.0);
  EXPECT_EQ(signal_strength(percepts, Heard::kMates), 40.0);
  EXPECT_EQ(signal_strength(percepts, Heard::kOthers), 80.0);
}

TEST(SignalMemory, AdvisesNothingWhereTheSignalIsStrong) {
  Walker walker({5, 0});
  walker.note();
  for (const SignalMethod method : {SignalMethod::kRecovery, SignalMethod::kPreservation, SignalMethod::kPlan,
                                    SignalMethod::kAverage, SignalMethod::kGreedy}) {
    EXPECT_EQ(walker.advice(method).direction, Vector{});
    EXPECT_EQ(walker.advice(method).confidence, 1.0);
  }
}

// Round a corner, where the straight way back would be another one.
TEST(SignalMemory, RecoveryGoesBackTheWayThatItCame) {
  Walker walker({5, 0});
  walker.note();
  for (int i = 0; i < 600; ++i) walker.go({0.0, 0.5, 0.0});
  for (int i = 0; i < 300; ++i) walker.go({0.5, 0.0, 0.0});
  EXPECT_EQ(walker.strength(), 0.0);
  double highest_x_in_the_first_leg = 0.0;
  for (int i = 0; i < 2000 && walker.strength() < kWanted; ++i) {
    const auto [direction, confidence] = walker.advice(SignalMethod::kRecovery);
    if (walker.strength() == 0.0) {
      EXPECT_EQ(confidence, 0.75);
    }
    ASSERT_NEAR(length(direction), 1.0, 1e-9);
    walker.go(direction * 0.5);
    const Point at = walker.percepts.pose.position;
    if (at.y < 280.0) highest_x_in_the_first_leg = std::max(highest_x_in_the_first_leg, at.x);
  }
  EXPECT_GE(walker.strength(), kWanted);
  EXPECT_LT(highest_x_in_the_first_leg, 12.0)
      << "it cut no corner by more than the places it remembers lie apart";
}

// Out, aside and back again beside the way out, so that who cuts through is far from it.
TEST(SignalMemory, RecoveryKnowsALongWayEvenly) {
  Walker walker({5, 0});
  walker.note();
  std::vector<Point> way;
  const auto go = [&](double meters, Vector step) {
    for (double gone = 0.0; gone < meters; gone += 0.5) {
      walker.go(step * 0.5);
      way.push_back(walker.percepts.pose.position);
    }
  };
  go(400.0, {0.0, 1.0, 0.0});
  go(150.0, {1.0, 0.0, 0.0});
  go(250.0, {0.0, -1.0, 0.0});
  go(200.0, {1.0, 0.0, 0.0});
  double farthest = 0.0;  // from the way that it came
  for (int i = 0; i < 4000 && walker.strength() < kWanted; ++i) {
    walker.go(walker.advice(SignalMethod::kRecovery).direction * 0.5);
    double nearest = 1e9;
    for (const Point point : way)
      nearest = std::min(nearest, geom::distance(point, walker.percepts.pose.position));
    farthest = std::max(farthest, nearest);
  }
  EXPECT_GE(walker.strength(), kWanted);
  EXPECT_LT(farthest, 25.0) << "of a way of 1 km a place stands every 16 to 32 m";
}

TEST(SignalMemory, RecoveryThenGoesToWhereSomebodyWasHeardLast) {
  Walker walker({5, 0});
  walker.note();
  for (int i = 0; i < 400; ++i) walker.go({0.5, 0.0, 0.0});
  walker.base = {0, -3000};  // it went away meanwhile
  walker.note();
  for (int i = 0; i < 1000 && walker.advice(SignalMethod::kRecovery).direction != Vector{}; ++i)
    walker.go(walker.advice(SignalMethod::kRecovery).direction * 0.5);
  EXPECT_LT(geom::distance(walker.percepts.pose.position, {0, 0}), 1.0) << "where the base was";
  EXPECT_EQ(walker.advice(SignalMethod::kRecovery).confidence, 0.0) << "there is nothing else that it knows";
}

TEST(SignalMemory, RecoveryGoesBackToWhereItBeganWhereTheSignalWasNeverStrong) {
  Walker walker({20, 0});
  walker.note();
  ASSERT_LT(walker.strength(), kWanted);
  EXPECT_NEAR(walker.advice(SignalMethod::kRecovery).direction.x, -1.0, 1e-9)
      << "there it goes to who is heard";
  for (int i = 0; i < 200; ++i) walker.go({0.0, 0.5, 0.0});
  for (int i = 0; i < 1000 && walker.strength() < kWanted; ++i)
    walker.go(walker.advice(SignalMethod::kRecovery).direction * 0.5);
  EXPECT_GE(walker.strength(), kWanted) << "from there on, too";
}

TEST(SignalMemory, RecoveryKnowsNothingWhereNobodyWasEverHeard) {
  Walker walker({500, 0});
  walker.note();
  EXPECT_EQ(walker.advice(SignalMethod::kRecovery).direction, Vector{});
  EXPECT_EQ(walker.advice(SignalMethod::kRecovery).confidence, 0.0);
}

TEST(SignalMemory, PreservationDrawsMoreTheWeakerTheSignal) {
  Walker walker({20, 0});
  walker.note();
  const Vector near = walker.advice(SignalMethod::kPreservation).direction;
  walker.go({40.0, 0.0, 0.0});
  const Vector far = walker.advice(SignalMethod::kPreservation).direction;
  EXPECT_LT(near.x, 0.0);
  EXPECT_LT(far.x, near.x);
  EXPECT_NEAR(near.x, -(1.0 - strength_at(20.0) / kWanted), 1e-9);
  walker.go({60.0, 0.0, 0.0});
  EXPECT_EQ(walker.advice(SignalMethod::kPreservation).direction, Vector{}) << "nobody is heard";
  EXPECT_EQ(walker.advice(SignalMethod::kPreservation).confidence, 0.0);
}

TEST(SignalMemory, ThePlanIsToMeetWhereItBegan) {
  Walker walker({500, 100});
  walker.note();
  walker.go({0.0, 30.0, 0.0});
  EXPECT_NEAR(walker.advice(SignalMethod::kPlan).direction.y, -1.0, 1e-9);
  walker.go({0.0, -29.5, 0.0});
  EXPECT_EQ(walker.advice(SignalMethod::kPlan).direction, Vector{}) << "it is there";
}

TEST(SignalMemory, TheMostConfidentCountsAloneOrAllByTheirConfidence) {
  Walker walker({500, 0});
  walker.note();
  walker.go({0.0, 30.0, 0.0});
  EXPECT_EQ(walker.advice(SignalMethod::kGreedy).direction, walker.advice(SignalMethod::kPlan).direction);
  walker.base = {440, 30};  // heard, 60 m to the west
  walker.note();
  const auto preservation = walker.advice(SignalMethod::kPreservation);
  const auto recovery = walker.advice(SignalMethod::kRecovery);
  const auto plan = walker.advice(SignalMethod::kPlan);
  const auto mean = walker.advice(SignalMethod::kAverage);
  EXPECT_EQ(recovery.confidence, 0.5) << "it is where somebody was heard last";
  const Vector sum =
      preservation.direction * preservation.confidence + recovery.direction * 0.5 + plan.direction * 0.25;
  const double weights = preservation.confidence + 0.75;
  EXPECT_NEAR(mean.direction.x, sum.x / weights, 1e-9);
  EXPECT_NEAR(mean.direction.y, sum.y / weights, 1e-9);
  EXPECT_NEAR(mean.confidence, weights / 3.0, 1e-9);
  walker.base = {480, 30};
  walker.note();
  EXPECT_EQ(walker.advice(SignalMethod::kGreedy).direction,
            walker.advice(SignalMethod::kPreservation).direction);
}

}  // namespace
}  // namespace mlab::schema
