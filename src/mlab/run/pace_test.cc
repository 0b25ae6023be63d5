#include "mlab/run/pace.h"

#include <gtest/gtest.h>

namespace mlab::run {
namespace {

TEST(Pace, ACycleIsDueWhenAsMuchTimeHasPassedAsTheSpeedWants) {
  Pace pace(10.0);
  pace.start(100.0, 5.0);
  EXPECT_DOUBLE_EQ(pace.due(5.0), 100.0);
  EXPECT_DOUBLE_EQ(pace.due(6.0), 100.1);
}

TEST(Pace, AtFullSpeedEveryCycleIsDueAndNoneIsLate) {
  Pace pace(0.0);
  pace.start(100.0, 5.0);
  EXPECT_LE(pace.due(1e6), 100.0);
  EXPECT_EQ(pace.behind(200.0, 5.0), 0.0);
}

TEST(Pace, SpeedsOutOfRangeAreBroughtIntoIt) {
  EXPECT_EQ(Pace(1e9).speed(), Pace::kFastest);
  EXPECT_EQ(Pace(1e-9).speed(), Pace::kSlowest);
  EXPECT_EQ(Pace(-1.0).speed(), 0.0);
}

TEST(Pace, WhatItIsLateDoesNotPileUp) {
  Pace pace(1.0);
  pace.start(0.0, 0.0);
  EXPECT_DOUBLE_EQ(pace.behind(10.0, 2.0), 8.0);
  pace.forgive(10.0, 2.0);
  EXPECT_DOUBLE_EQ(pace.behind(10.0, 2.0), Pace::kMostBehind);
  EXPECT_DOUBLE_EQ(pace.due(3.0), 10.0 - Pace::kMostBehind + 1.0);
}

TEST(Pace, NothingIsMadeUpForWhereNobodyCouldFollow) {
  Pace pace(1.0);
  pace.start(0.0, 0.0);
  pace.forgive_all(2.05, 2.0, 0.1);
  EXPECT_NEAR(pace.behind(2.05, 2.0), 0.05, 1e-12);
  pace.forgive_all(2.3, 2.0, 0.1);
  EXPECT_EQ(pace.behind(2.3, 2.0), 0.0);
}

TEST(Pace, ASmallDelayIsMadeUpFor) {
  Pace pace(1.0);
  pace.start(0.0, 0.0);
  pace.forgive(2.3, 2.0);
  EXPECT_NEAR(pace.behind(2.3, 2.0), 0.3, 1e-12);
}

}  // namespace
}  // namespace mlab::run
