#include "mlab/fleet/what_if.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "mlab/fleet/testing/failsafe_row.h"

namespace mlab::fleet {
namespace {

using mission::Failsafe;
using mission::FailsafeAction;
using mission::FailsafeCondition;
using testing::lasting;
using testing::row;
using State = RowStanding::State;
using What = WhatIfEvent::What;

constexpr double kTenth = 0.1;

// A robot at (50, 30) that came from (20, 30).
struct Tried {
  Failsafes failsafes;
  binding::Kinematics kinematics;
  Situation situation;

  explicit Tried(const std::vector<Failsafe>& rows) : failsafes(rows) {
    situation.motion.pose.position = {50, 30};
    situation.home = {20, 30};
    situation.radius = 0.2;
  }
  std::expected<WhatIfOutcome, std::string> asked(const WhatIf& conditions, double dt = kTenth) {
    situation.kinematics = &kinematics;
    return what_if(failsafes, situation, conditions, dt);
  }
  WhatIfOutcome of(const WhatIf& conditions) {
    const auto out = asked(conditions);
    EXPECT_TRUE(out.has_value()) << (out ? "" : out.error());
    return out.value_or(WhatIfOutcome{});
  }
};

// When it happens [s]; less than 0: never.
double when(const WhatIfOutcome& outcome, std::size_t row, What what) {
  for (const WhatIfEvent& event : outcome.events) {
    if (event.row == row && event.what == what) return event.time;
  }
  return -1.0;
}

TEST(WhatIf, AnEmptyBatteryMeetsEveryRowOfBatteriesAfterItsTime) {
  Failsafe warns = row(FailsafeCondition::kBattery, FailsafeAction::kContinue, 0.0);
  warns.share = 0.5;
  Failsafe holds = row(FailsafeCondition::kBattery, FailsafeAction::kHold, 2.0);
  holds.share = 0.2;
  Tried robot({holds, warns});
  const WhatIfOutcome outcome = robot.of({.lasting = lasting({{FailsafeCondition::kBattery, 3.0}})});
  EXPECT_NEAR(when(outcome, 1, What::kActs), kTenth, 1e-9);
  EXPECT_NEAR(when(outcome, 0, What::kActs), 2.0, 2.0 * kTenth);
  EXPECT_GT(when(outcome, 0, What::kIsOver), 3.0);
}

TEST(WhatIf, WhereNothingIsWrongNothingHappens) {
  Tried robot({row(FailsafeCondition::kInContact, FailsafeAction::kHold, 0.5),
               row(FailsafeCondition::kStuck, FailsafeAction::kStop, 30.0)});
  const WhatIfOutcome outcome = robot.of({});
  EXPECT_TRUE(outcome.events.empty());
  EXPECT_EQ(outcome.rows[0].state, State::kArmed);
  EXPECT_FALSE(outcome.stood);
}

TEST(WhatIf, WhoIsHeldAtAFenceAndWantsToGoOnIsStuckThereInTime) {
  Tried robot({row(FailsafeCondition::kStuck, FailsafeAction::kHold, 5.0),
               row(FailsafeCondition::kOutside, FailsafeAction::kContinue)});
  const WhatIfOutcome inside = robot.of({.fence = WhatIf::AtFence{.row = 1, .depth = 5.0}});
  ASSERT_TRUE(inside.stood);
  EXPECT_NEAR(when(inside, 0, What::kActs), *inside.stood + 5.0, 0.5);
  EXPECT_EQ(inside.rows[0].state, State::kActive);
  EXPECT_EQ(inside.rows[1].state, State::kWaiting);
  const WhatIfOutcome outside =
      robot.of({.fence = WhatIf::AtFence{.row = 1, .depth = -5.0, .begins_there = true}});
  EXPECT_GT(when(outside, 0, What::kActs), 4.9);
}

TEST(WhatIf, WhoBeginsOnTheLineOrComesToItFromOutsideIsLetIn) {
  Tried robot({row(FailsafeCondition::kOutside, FailsafeAction::kHold)});
  for (const auto& [depth, speed] : {std::pair{0.0, 1.0}, {-10.0, 10.0}, {-5.0, 5.0}, {-10.0, 50.0}}) {
    const WhatIfOutcome out =
        robot.of({.speed = speed,
                  .fence = WhatIf::AtFence{
                      .row = 0, .depth = depth, .bearing = std::numbers::pi, .begins_there = true}});
    EXPECT_GT(geom::distance(out.from.position, out.to.position), 20.0) << depth << ' ' << speed;
    EXPECT_GT(out.last_room, -1e-6) << depth << ' ' << speed;
  }
}

TEST(WhatIf, ARowIsMetWhenItsConditionLastsForAsLongAsItSays) {
  for (const double seconds : {0.3, 0.7, 1.0, 5.0}) {
    Tried robot({row(FailsafeCondition::kInContact, FailsafeAction::kHold, seconds),
                 row(FailsafeCondition::kLinkLost, FailsafeAction::kContinue, std::max(seconds, 0.6)),
                 row(FailsafeCondition::kStuck, FailsafeAction::kContinue, seconds)});
    EXPECT_NEAR(
        when(robot.of({.lasting = lasting({{FailsafeCondition::kInContact, seconds}})}), 0, What::kMet),
        seconds, 0.11)
        << seconds;
    EXPECT_NEAR(when(robot.of({.lasting = lasting({{FailsafeCondition::kLinkLost, std::max(seconds, 0.6)}})}),
                     1, What::kMet),
                std::max(seconds, 0.6), 0.11);
    EXPECT_NEAR(when(robot.of({.lasting = lasting({{FailsafeCondition::kStuck, seconds}})}), 2, What::kMet),
                seconds, 0.21)
        << seconds;
  }
}

TEST(WhatIf, WhatDoesNotLastForLongEnoughIsTold) {
  Tried robot({row(FailsafeCondition::kInContact, FailsafeAction::kHold, 2.0)});
  const WhatIfOutcome outcome = robot.of({.lasting = lasting({{FailsafeCondition::kInContact, 1.0}})});
  EXPECT_LT(when(outcome, 0, What::kMet), 0.0);
  EXPECT_NEAR(outcome.most_used[0], 0.55, 0.051);
}

TEST(WhatIf, OfSeveralTheHighestRankActsAndTheOtherGivesWay) {
  Tried robot({row(FailsafeCondition::kLinkLost, FailsafeAction::kReturn, 5.0),
               row(FailsafeCondition::kInContact, FailsafeAction::kHold, 0.5)});
  const WhatIfOutcome outcome = robot.of(
      {.lasting = lasting({{FailsafeCondition::kLinkLost, 8.0}, {FailsafeCondition::kInContact, 8.0}})});
  EXPECT_NEAR(when(outcome, 1, What::kActs), 0.5, 0.01);
  EXPECT_NEAR(when(outcome, 0, What::kActs), 5.0, 0.01);
  EXPECT_NEAR(when(outcome, 1, What::kGivesWay), 5.0, 0.01);
  EXPECT_NEAR(geom::distance(outcome.to.position, {20, 30}), 0.5, 0.2) << "home";
  EXPECT_TRUE(outcome.stood);
  EXPECT_EQ(outcome.rows[0].state, State::kActive) << "it stands there until it is given another order";
}

TEST(WhatIf, ARobotWhoseLinkIsLostStandsByItself) {
  Tried robot({row(FailsafeCondition::kLinkLost, FailsafeAction::kReturn, 5.0)});
  const WhatIfOutcome outcome = robot.of({.lasting = lasting({{FailsafeCondition::kLinkLost, 3.0}})});
  EXPECT_LT(when(outcome, 0, What::kMet), 0.0);
  EXPECT_NEAR(outcome.to.position.x, 51.6, 0.2) << "after half a second, until it is heard again";
}

TEST(WhatIf, ARobotThatActsOnOldPerceptsIsHeldWhenTheyAreTooOld) {
  Tried robot({row(FailsafeCondition::kPerceptsStale, FailsafeAction::kHold, 2.0)});
  const WhatIfOutcome outcome = robot.of({.lasting = lasting({{FailsafeCondition::kPerceptsStale, 3.0}})});
  EXPECT_NEAR(when(outcome, 0, What::kActs), 2.0, 0.11);
  EXPECT_NEAR(outcome.events.front().time, outcome.stood.value_or(2.0), 0.2);
  EXPECT_NEAR(when(outcome, 0, What::kIsOver), 3.1, 0.11);
}

TEST(WhatIf, ARobotWhoseOperatorIsGoneGoesHomeUntilHeIsBack) {
  Tried robot({row(FailsafeCondition::kOperatorAbsent, FailsafeAction::kReturn, 2.0)});
  const WhatIfOutcome outcome = robot.of({.lasting = lasting({{FailsafeCondition::kOperatorAbsent, 6.0}})});
  EXPECT_NEAR(when(outcome, 0, What::kActs), 2.0, 0.11);
  EXPECT_NEAR(when(outcome, 0, What::kIsOver), 6.2, 0.11) << "somebody steers it";
  const WhatIfOutcome brief = robot.of({.lasting = lasting({{FailsafeCondition::kOperatorAbsent, 1.0}})});
  EXPECT_LT(when(brief, 0, What::kMet), 0.0);
}

TEST(WhatIf, AHeldRobotGoesOnWhenWhatWasWrongIsOver) {
  Tried robot({row(FailsafeCondition::kInContact, FailsafeAction::kHold)});
  const WhatIfOutcome outcome = robot.of({.lasting = lasting({{FailsafeCondition::kInContact, 2.0}})});
  EXPECT_NEAR(when(outcome, 0, What::kActs), 0.1, 0.01);
  EXPECT_NEAR(when(outcome, 0, What::kIsOver), 2.2, 0.11);
}

TEST(WhatIf, AStoppedRobotBrakesAndNothingGuardsItAnyMore) {
  Tried robot({row(FailsafeCondition::kInContact, FailsafeAction::kStop)});
  robot.kinematics.max_acceleration = 1.0;
  const WhatIfOutcome outcome =
      robot.of({.lasting = lasting({{FailsafeCondition::kInContact, 5.0}}), .speed = 2.0});
  EXPECT_TRUE(outcome.has_stopped);
  EXPECT_NEAR(outcome.to.position.x, 52.0, 0.3) << "v^2 / 2a";
  EXPECT_NEAR(outcome.stood.value_or(0.0), 2.0, 0.2);
}

TEST(WhatIf, AFenceIsNotCrossedFromAnySpeedUnderAnyHeading) {
  for (const double speed : {0.5, 1.0, 4.0, 12.0}) {
    for (const double bearing : {0.0, 0.5, -1.2}) {
      Tried robot({row(FailsafeCondition::kOutside, FailsafeAction::kHold)});
      robot.kinematics.max_acceleration = 3.0;
      const WhatIfOutcome outcome =
          robot.of({.speed = speed, .fence = WhatIf::AtFence{.depth = 28.0, .bearing = bearing}});
      EXPECT_GE(outcome.least_room, -1e-6) << speed << ' ' << bearing;
      EXPECT_EQ(outcome.rows[0].state, State::kActive);
      EXPECT_TRUE(outcome.stood);
      if (bearing == 0.0) {
        EXPECT_LT(outcome.last_room, 0.1 * speed + 0.2);
      }
    }
  }
}

TEST(WhatIf, WhoIsOutsideIsHeldAndWhoBeginsThereIsLetIn) {
  Tried robot({row(FailsafeCondition::kOutside, FailsafeAction::kHold)});
  const double kIn = std::numbers::pi;
  const WhatIfOutcome held = robot.of({.fence = WhatIf::AtFence{.depth = -2.0, .bearing = kIn}});
  EXPECT_GE(when(held, 0, What::kActs), 0.0);
  EXPECT_LT(held.last_room, -2.0);
  const WhatIfOutcome let_in =
      robot.of({.fence = WhatIf::AtFence{.depth = -2.0, .bearing = kIn, .begins_there = true}});
  EXPECT_GE(when(let_in, 0, What::kLetsIn), 0.0);
  EXPECT_GT(when(let_in, 0, What::kNotMet), 2.0) << "it has come in";
  EXPECT_GT(when(let_in, 0, What::kActs), 50.0) << "at the other side";
  EXPECT_NEAR(let_in.last_room, 0.0, 1e-6);
}

TEST(WhatIf, ReversingInsideEndsThreeMetresFromTheLine) {
  Tried robot({row(FailsafeCondition::kOutside, FailsafeAction::kReverseInside)});
  robot.kinematics.drive = binding::Drive::kCar;
  const WhatIfOutcome outcome = robot.of({.fence = WhatIf::AtFence{.depth = 5.0}});
  EXPECT_NEAR(outcome.last_room, 3.0, 0.1);
  EXPECT_NEAR(outcome.least_room, 0.0, 0.2);
}

TEST(WhatIf, WhatCantBeTriedIsRefusedWithWhatIsExpected) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  Tried robot({row(FailsafeCondition::kOutside, FailsafeAction::kHold),
               row(FailsafeCondition::kStuck, FailsafeAction::kHold, 2.0)});
  const auto error = [&](const WhatIf& asked) {
    const auto out = robot.asked(asked);
    return out ? std::string() : out.error();
  };
  EXPECT_EQ(error({.lasting = lasting({{FailsafeCondition::kLinkLost, kNaN}})}),
            "LINK-LOST lasts from 0 to 600 s");
  EXPECT_EQ(error({.lasting = lasting({{FailsafeCondition::kInContact, -1.0}})}),
            "IN-CONTACT lasts from 0 to 600 s");
  EXPECT_EQ(error({.lasting = lasting({{FailsafeCondition::kStuck, 601.0}})}), "STUCK lasts from 0 to 600 s");
  EXPECT_EQ(error({.lasting = lasting({{FailsafeCondition::kOutside, 1.0}})}),
            "OUTSIDE does not last: it is tried at a line");
  EXPECT_EQ(error({.speed = std::numeric_limits<double>::infinity()}),
            "the speed is a number from 0 to 50 m/s");
  EXPECT_EQ(error({.fence = WhatIf::AtFence{.row = 1}}), "row 2 of the table is no OUTSIDE");
  EXPECT_EQ(error({.fence = WhatIf::AtFence{.row = 7}}), "row 8 of the table is no OUTSIDE");
  EXPECT_EQ(error({.fence = WhatIf::AtFence{.depth = kNaN}}),
            "the distance from the line is a number from -1000 to 1000 m");
  EXPECT_EQ(error({.fence = WhatIf::AtFence{.bearing = 7.0}}),
            "the heading is an angle of at most a full turn");
  EXPECT_EQ(error({.fence = WhatIf::AtFence{.depth = 31.0}}),
            "`Field` has no place that is 31 m within its line: come nearer to it");
  robot.situation.rows = 0b10;
  EXPECT_EQ(error({.fence = WhatIf::AtFence{}}), "row 1 of the table is not this robot's");
}

TEST(WhatIf, WhatWouldBeTooMuchWorkIsCut) {
  Failsafe fence = row(FailsafeCondition::kOutside, FailsafeAction::kContinue);
  fence.fence.clear();
  for (int i = 0; i < 20'000; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 20'000;
    fence.fence.push_back({50 + 40 * std::cos(angle), 30 + 40 * std::sin(angle)});
  }
  Tried robot({fence});
  const WhatIfOutcome many_sides = robot.of(
      {.lasting = lasting({{FailsafeCondition::kLinkLost, 600.0}}), .fence = WhatIf::AtFence{.depth = 1.0}});
  EXPECT_TRUE(many_sides.is_cut);
  EXPECT_LT(many_sides.seconds, 600.0);
  Tried hardly_brakes(std::vector(16, row(FailsafeCondition::kOutside, FailsafeAction::kReverseInside)));
  hardly_brakes.kinematics = {
      .drive = binding::Drive::kCar, .max_acceleration = 5e-4, .max_turn_acceleration = 0.01};
  const auto small_steps = hardly_brakes.asked({.lasting = lasting({{FailsafeCondition::kLinkLost, 600.0}}),
                                                .speed = 0.5,
                                                .fence = WhatIf::AtFence{.depth = 1.0, .bearing = 1.5}},
                                               0.001);
  ASSERT_TRUE(small_steps);
  EXPECT_TRUE(small_steps->is_cut);
  EXPECT_LT(small_steps->seconds, 1.0);
  Tried quick({row(FailsafeCondition::kStuck, FailsafeAction::kHold, 2.0)});
  const auto short_cycles = quick.asked({.lasting = lasting({{FailsafeCondition::kStuck, 600.0}})}, 0.001);
  ASSERT_TRUE(short_cycles);
  EXPECT_TRUE(short_cycles->is_cut);
  EXPECT_NEAR(short_cycles->seconds, 20.0, 1e-6);
}

RC_GTEST_PROP(WhatIf, EndsInFiniteNumbersWhateverIsAsked, (const std::vector<int>& bits)) {
  const auto some = [&](std::size_t i, double most) {
    return bits.size() > i ? std::abs(bits[i] % 1000) / 1000.0 * most : 0.0;
  };
  Tried robot({row(FailsafeCondition::kOutside, FailsafeAction::kReverseInside),
               row(FailsafeCondition::kLinkLost, FailsafeAction::kReturn, some(8, 10.0)),
               row(FailsafeCondition::kInContact, FailsafeAction::kContinue, some(9, 10.0)),
               row(FailsafeCondition::kStuck, FailsafeAction::kHold, some(10, 10.0))});
  robot.kinematics.drive = static_cast<binding::Drive>(bits.size() % 4);
  robot.kinematics.axle = 0.4;
  robot.kinematics.max_acceleration = some(0, 4.0);
  WhatIf asked = {.lasting = lasting({{FailsafeCondition::kLinkLost, some(1, 20.0)},
                                      {FailsafeCondition::kInContact, some(2, 20.0)},
                                      {FailsafeCondition::kStuck, some(3, 20.0)}}),
                  .speed = some(4, 50.0)};
  if (bits.size() > 5)
    asked.fence = WhatIf::AtFence{
        .depth = some(5, 60.0) - 31.0, .bearing = some(6, 6.0), .begins_there = some(7, 1.0) > 0.5};
  const auto outcome = robot.asked(asked);
  if (!outcome) return;
  RC_ASSERT(std::isfinite(outcome->to.position.x) && std::isfinite(outcome->to.position.y));
  RC_ASSERT(outcome->rows.size() == 4U);
  RC_ASSERT(outcome->seconds <= 20.0 + WhatIf::kMostSettling + WhatIf::kMostSeconds + 2.0);
  for (const double used : outcome->most_used) RC_ASSERT(used >= 0.0 && used <= 1.0);
}

}  // namespace
}  // namespace mlab::fleet
