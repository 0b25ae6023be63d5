#include "mlab/mavlink/rover_device.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "mlab/mavlink/testing/drive.h"

namespace mlab::mavlink {
namespace {

using testing::Pair;
using vehicle::Readiness;

constexpr double kHalfTurn = std::numbers::pi;

RoverSettings quick() {
  RoverSettings out;
  out.limits.kinematics.max_speed = 2.0;
  out.limits.kinematics.max_turn_rate = 1.0;
  out.limits.min_speed = -1.0;
  return out;
}

bool says(const std::vector<Note>& notes, std::string_view text) {
  return std::ranges::any_of(notes,
                             [&](const Note& one) { return one.text.find(text) != std::string::npos; });
}

TEST(RoverDevice, TellsWhatItIsAndThatNothingWasHeard) {
  Pair pair;
  EXPECT_EQ(pair.device->name(), "MAVLink rover at toy");
  EXPECT_EQ(pair.report().readiness, Readiness::kSilent);
  EXPECT_EQ(pair.why(), "has not been heard yet");
  EXPECT_FALSE(pair.report().motion);
}

TEST(RoverDevice, TellsWhatIsMissingBeforeItIsDriven) {
  Pair pair;
  pair.pass(0.2);
  EXPECT_EQ(pair.report().readiness, Readiness::kNotReady);
  EXPECT_TRUE(pair.why().starts_with("has not told its parameter")) << pair.why();
  pair.pass(2.0);
  EXPECT_EQ(pair.why(), "is not armed");
  EXPECT_EQ(pair.report().readiness, Readiness::kStandby) << "to be driven makes it ready";
  EXPECT_FALSE(pair.rover.is_armed) << "it is armed only where it is to drive";
  EXPECT_EQ(pair.rover.mode, Mode::kManual);
}

TEST(RoverDevice, ArmsInGuidedModeAndDrivesInOurFrame) {
  Pair pair(quick());
  pair.rover.north = 5.0;
  pair.rover.east = 7.0;
  pair.pass(2.0);
  pair.drive(1.0, {0.0, 0.0});
  ASSERT_EQ(pair.report().readiness, Readiness::kReady) << pair.why();
  EXPECT_EQ(pair.rover.mode, Mode::kGuided);
  EXPECT_TRUE(pair.rover.is_armed);
  // It looks north: y grows.
  pair.drive(2.0, {1.0, 0.0});
  ASSERT_TRUE(pair.report().motion);
  vehicle::Motion motion = *pair.report().motion;
  EXPECT_NEAR(motion.pose.position.x, 7.0, 1e-5);
  EXPECT_NEAR(motion.pose.position.y, 7.0, 0.3);
  EXPECT_NEAR(motion.pose.heading, kHalfTurn / 2.0, 1e-5);
  EXPECT_NEAR(motion.speed, 1.0, 1e-5);
  // To the left: it looks west in the end, and x shrinks.
  pair.drive(3.0, {0.0, 0.5});
  EXPECT_NEAR(pair.report().motion->turn_rate, 0.5, 1e-5);
  EXPECT_NEAR(pair.report().motion->pose.heading, kHalfTurn / 2.0 + 1.5, 0.2);
  pair.drive(1.0, {-0.5, 0.0});
  EXPECT_NEAR(pair.report().motion->speed, -0.5, 1e-5);
  EXPECT_FALSE(pair.report().is_global);
}

TEST(RoverDevice, KeepsItsLimits) {
  Pair pair(quick());
  pair.pass(2.0);
  pair.drive(2.0, {50.0, -50.0});
  EXPECT_NEAR(pair.rover.speed, 2.0, 1e-6);
  EXPECT_NEAR(pair.rover.yaw_rate, 1.0, 1e-6) << "clockwise, as its frame has it";
  pair.drive(1.0, {-50.0, 0.0});
  EXPECT_NEAR(pair.rover.speed, -1.0, 1e-6);
  pair.drive(1.0, {std::nan(""), 0.0});
  EXPECT_EQ(pair.rover.speed, 0.0);
  EXPECT_EQ(pair.rover.mode, Mode::kHold) << "what is no number is a stop";
}

TEST(RoverDevice, SendsAtLeastTenSetPointsASecond) {
  Pair pair(quick());
  pair.pass(2.0);
  pair.drive(1.0, {1.0, 0.0});
  int seen = 0;
  auto last = pair.rover.set_point_at;
  pair.pass(2.0, [&] {
    pair.device->drive({1.0, 0.0}, pair.now);
    if (std::exchange(last, pair.rover.set_point_at) != pair.rover.set_point_at) ++seen;
  });
  EXPECT_GE(seen, 20);
}

TEST(RoverDevice, StandsWhenNobodyCommandsItAnyMore) {
  Pair pair(quick());
  pair.pass(2.0);
  pair.drive(1.0, {1.0, 0.0});
  ASSERT_NEAR(pair.rover.speed, 1.0, 1e-6);
  pair.pass(pair.device->limits().standstill);
  EXPECT_EQ(pair.rover.speed, 0.0);
}

TEST(RoverDevice, StopsByHoldAndLeavesItArmed) {
  Pair pair(quick());
  pair.pass(2.0);
  pair.drive(2.0, {1.0, 0.0});
  pair.device->stop(pair.now);
  pair.pass(0.3);
  EXPECT_EQ(pair.rover.speed, 0.0);
  EXPECT_EQ(pair.rover.mode, Mode::kHold);
  pair.pass(5.0);
  EXPECT_TRUE(pair.rover.is_armed);
  EXPECT_EQ(pair.rover.forced_disarms, 0);
  const std::size_t commands = pair.rover.commands.size();
  pair.pass(3.0);
  const auto is_stop = [](const CommandLong& one) { return one.command != kSetMessageInterval; };
  EXPECT_EQ(std::count_if(pair.rover.commands.begin() + static_cast<std::ptrdiff_t>(commands),
                          pair.rover.commands.end(), is_stop),
            0)
      << "what is seen to stand is not told any more";
  pair.drive(2.0, {1.0, 0.0});
  EXPECT_NEAR(pair.rover.speed, 1.0, 1e-6) << "until the next drive";
}

TEST(RoverDevice, DisarmsByForceWhatGoesOnMoving) {
  Pair pair(quick());
  pair.pass(2.0);
  pair.drive(2.0, {1.0, 0.0});
  pair.rover.runs_away = true;
  pair.device->stop(pair.now);
  pair.pass(1.5);
  EXPECT_EQ(pair.rover.forced_disarms, 0) << "not at once";
  pair.pass(1.0);
  EXPECT_GE(pair.rover.forced_disarms, 1);
  EXPECT_FALSE(pair.rover.is_armed);
  EXPECT_EQ(pair.rover.speed, 0.0);
}

TEST(RoverDevice, IsToldAgainWithHowOftenUntilItIsSeen) {
  Pair pair(quick());
  pair.pass(2.0);
  pair.rover.refuses_modes = true;
  pair.rover.commands.clear();
  pair.drive(1.0, {});
  EXPECT_EQ(pair.why(), "refuses mode GUIDED: it failed");
  pair.drive(4.0, {});
  std::vector<int> confirmations;
  for (const CommandLong& one : pair.rover.commands) {
    if (one.command == kDoSetMode) confirmations.push_back(one.confirmation);
  }
  EXPECT_EQ(confirmations, (std::vector<int>{0, 1, 2}));
  pair.rover.refuses_modes = false;
  pair.drive(3.0, {});
  EXPECT_EQ(pair.report().readiness, Readiness::kReady) << pair.why();
}

TEST(RoverDevice, TakesOnlyAnswersThatAreForIt) {
  Pair pair(quick());
  pair.pass(2.0);
  CommandAck answer;
  answer.command = kDoSetMode;
  answer.result = static_cast<std::uint8_t>(Result::kDenied);
  for (const auto& [target, why] : {std::pair{17, "is not armed"}, {255, "refuses mode GUIDED: denied"}}) {
    pair.device->drive({}, pair.now);
    pair.device->work(pair.now);
    answer.target_system = static_cast<std::uint8_t>(target);
    pair.rover.send(answer, pair.now);
    pair.device->work(pair.now);
    EXPECT_EQ(pair.why(), why);
  }
}

TEST(RoverDevice, IsNotArmedWhereItsOwnChecksFail) {
  Pair pair(quick());
  pair.rover.passes_checks = false;
  pair.pass(2.0);
  pair.rover.say("PreArm: compass not healthy", pair.now);
  pair.drive(2.0, {1.0, 0.0});
  EXPECT_FALSE(pair.rover.is_armed);
  EXPECT_EQ(pair.why(), "fails its own checks before arming: PreArm: compass not healthy");
  EXPECT_TRUE(std::ranges::any_of(pair.device->checks(pair.now), [](const vehicle::Check& one) {
    return one.result == vehicle::CheckResult::kFail && one.is == "PreArm: compass not healthy";
  }));
  EXPECT_TRUE(says(pair.device->take_notes(), "says: PreArm: compass not healthy"));
  EXPECT_TRUE(pair.device->take_notes().empty());
}

TEST(RoverDevice, DoesNotFightWhoTakesItAway) {
  Pair pair(quick());
  pair.pass(2.0);
  pair.drive(2.0, {1.0, 0.0});
  pair.rover.mode = Mode::kRtl;
  pair.rover.commands.clear();
  pair.drive(5.0, {1.0, 0.0});
  EXPECT_EQ(pair.rover.mode, Mode::kRtl);
  EXPECT_EQ(pair.why(),
            "was put into mode RTL by itself or by somebody else; Replace in the console takes it back");
  EXPECT_EQ(pair.report().readiness, Readiness::kTaken);
  pair.device->stop(pair.now);
  pair.pass(1.0);
  for (const CommandLong& one : pair.rover.commands) EXPECT_EQ(one.command, kSetMessageInterval);
  EXPECT_EQ(pair.rover.mode, Mode::kRtl) << "a routine stop takes nothing from anybody";
  pair.device->engage(pair.now);
  pair.drive(2.0, {1.0, 0.0});
  EXPECT_NEAR(pair.rover.speed, 1.0, 1e-6);
}

TEST(RoverDevice, StopsWhoeverHasItInAnEmergency) {
  for (const Mode mode : {Mode::kManual, Mode::kAuto}) {
    Pair pair(quick());
    pair.pass(2.0);
    pair.drive(2.0, {1.0, 0.0});
    pair.rover.mode = mode;
    pair.drive(1.0, {1.0, 0.0});
    EXPECT_EQ(pair.report().readiness, Readiness::kTaken);
    pair.pass(1.0, [&] { pair.device->stop_in_emergency(pair.now); });
    EXPECT_EQ(pair.rover.mode, Mode::kHold);
    pair.rover.mode = mode;
    pair.pass(1.0, [&] { pair.device->stop_in_emergency(pair.now); });
    EXPECT_EQ(pair.rover.mode, Mode::kHold) << "nobody gets it away from there";
    pair.pass(0.5, [&] { pair.device->stop(pair.now); });
    pair.rover.mode = mode;
    pair.pass(1.0, [&] { pair.device->stop(pair.now); });
    EXPECT_EQ(pair.rover.mode, mode) << "the emergency is over";
  }
}

TEST(RoverDevice, DoesNotArmAgainWhatWasDisarmed) {
  Pair pair(quick());
  pair.pass(2.0);
  pair.drive(2.0, {1.0, 0.0});
  pair.rover.is_armed = false;
  pair.drive(3.0, {1.0, 0.0});
  EXPECT_FALSE(pair.rover.is_armed);
  EXPECT_TRUE(pair.why().starts_with("was disarmed")) << pair.why();
  pair.device->engage(pair.now);
  pair.drive(3.0, {1.0, 0.0});
  EXPECT_TRUE(pair.rover.is_armed) << "a person wants it driven anew";
}

TEST(RoverDevice, LeavesAPilotAlone) {
  Pair pair(quick());
  pair.rover.is_armed = true;
  pair.rover.mode = Mode::kManual;
  pair.pass(0.1);
  pair.rover.is_armed = true;
  pair.pass(2.0);
  pair.drive(2.0, {1.0, 0.0});
  pair.device->stop(pair.now);
  pair.pass(2.0);
  pair.device->engage(pair.now);
  pair.drive(2.0, {1.0, 0.0});
  EXPECT_EQ(pair.rover.mode, Mode::kManual);
  EXPECT_EQ(pair.report().readiness, Readiness::kTaken);
  EXPECT_EQ(pair.why(), "is armed and in mode MANUAL: a pilot steers it");
}

TEST(RoverDevice, IsSilentAfterTwoAndAHalfSecondsAndStandsWhenItComesBack) {
  Pair pair(quick());
  pair.pass(2.0);
  pair.drive(2.0, {1.0, 0.0});
  pair.link.is_cut = true;
  pair.drive(2.4, {1.0, 0.0});
  EXPECT_NE(pair.report().readiness, Readiness::kSilent);
  EXPECT_FALSE(pair.report().motion) << "what is old is not there any more";
  pair.drive(0.3, {1.0, 0.0});
  EXPECT_EQ(pair.report().readiness, Readiness::kSilent);
  EXPECT_TRUE(pair.why().starts_with("has said nothing for 2.")) << pair.why();
  EXPECT_EQ(pair.rover.speed, 0.0);
  EXPECT_EQ(pair.rover.mode, Mode::kHold) << "its failsafe";
  EXPECT_TRUE(says(pair.device->take_notes(), "has been silent"));
  pair.link.is_cut = false;
  pair.pass(5.0);
  EXPECT_EQ(pair.rover.speed, 0.0);
  EXPECT_EQ(pair.why(), "is in mode HOLD, not GUIDED");
  pair.drive(2.0, {1.0, 0.0});
  EXPECT_NEAR(pair.rover.speed, 1.0, 1e-6);
}

TEST(RoverDevice, StandsAlsoWhenItComesBackJustWhenItsSilenceIsNoticed) {
  Pair pair(quick());
  pair.rover.parameters["FS_TIMEOUT"] = 5;
  pair.pass(2.0);
  pair.drive(2.0, {1.0, 0.0});
  pair.link.is_cut = true;
  pair.drive(2.5, {1.0, 0.0});
  pair.now += std::chrono::milliseconds(100);
  EXPECT_EQ(pair.report().readiness, Readiness::kSilent);
  pair.link.is_cut = false;
  pair.pass(0.5);
  EXPECT_EQ(pair.rover.mode, Mode::kGuided);
  EXPECT_EQ(pair.rover.speed, 0.0);
}

TEST(RoverDevice, SaysThatItsFailsafeActs) {
  Pair pair(quick());
  pair.pass(2.0);
  pair.drive(2.0, {1.0, 0.0});
  pair.rover.parameters["SYSID_MYGCS"] = 1;  // it does not count us any more
  pair.drive(3.0, {1.0, 0.0});
  EXPECT_EQ(pair.rover.mode, Mode::kHold);
  EXPECT_EQ(pair.why(), "acts by its own failsafe, in mode HOLD");
}

TEST(RoverDevice, NoticesThatTheVehicleHasBegunAgain) {
  Pair pair(quick());
  pair.pass(10.0);
  pair.drive(2.0, {1.0, 0.0});
  pair.rover.restart(pair.now);
  pair.pass(0.3);
  pair.pass(2.5);
  EXPECT_TRUE(says(pair.device->take_notes(), "has begun again"));
  EXPECT_FALSE(pair.rover.is_armed);
  EXPECT_EQ(pair.why(), "is not armed");
  pair.drive(2.0, {1.0, 0.0});
  EXPECT_NEAR(pair.rover.speed, 1.0, 1e-6);
}

TEST(RoverDevice, StandsForASecondWhenItsPositionJumps) {
  Pair pair(quick());
  pair.pass(2.0);
  pair.drive(2.0, {1.0, 0.0});
  pair.rover.north += 30.0;
  pair.drive(0.5, {1.0, 0.0});
  EXPECT_TRUE(pair.why().starts_with("jumped by 30.")) << pair.why();
  EXPECT_EQ(pair.rover.speed, 0.0);
  EXPECT_TRUE(says(pair.device->take_notes(), "jumped by 30."));
  pair.drive(2.0, {1.0, 0.0});
  EXPECT_EQ(pair.report().readiness, Readiness::kReady) << pair.why();
  EXPECT_NEAR(pair.rover.speed, 1.0, 1e-6);
}

TEST(RoverDevice, IsNotReadyWithParametersThatAreNotSafe) {
  Pair pair(quick());
  pair.rover.parameters["FS_GCS_ENABLE"] = 0;
  pair.pass(3.0);
  EXPECT_EQ(
      pair.why(),
      "has FS_GCS_ENABLE at 0, and it has to act by itself when it hears us no more: set it to 1 to 2 with a "
      "ground station (QGroundControl, `param set FS_GCS_ENABLE 1`)");
  pair.drive(2.0, {1.0, 0.0});
  EXPECT_FALSE(pair.rover.is_armed);
}

TEST(RoverDevice, TellsBeforeAMissionWhichParametersAreNotSafe) {
  using vehicle::Check;
  using enum vehicle::CheckResult;
  Pair pair(quick());
  const auto check = [&](std::string_view name) {
    for (const Check& one : pair.device->checks(pair.now)) {
      if (one.name == name) return one;
    }
    return Check{"none", kUnknown, "", ""};
  };
  EXPECT_EQ(check("autopilot"), (Check{"autopilot", kFail, "has not been heard yet", "is heard"}));
  EXPECT_EQ(check("parameter FS_ACTION").result, kUnknown);
  EXPECT_EQ(check("parameter FS_ACTION").is, "has not told it yet");
  pair.rover.parameters["FS_GCS_ENABLE"] = 0;
  pair.rover.parameters["FS_CRASH_CHECK"] = 0;
  pair.pass(3.0);
  EXPECT_EQ(check("autopilot"), (Check{"autopilot", kPass, "is in mode MANUAL, not armed", ""}));
  EXPECT_EQ(check("parameter FS_ACTION").result, kPass);
  EXPECT_EQ(check("parameter FS_GCS_ENABLE"),
            (Check{"parameter FS_GCS_ENABLE", kFail, "is 0",
                   "1 to 2: it has to act by itself when it hears us no more"}));
  EXPECT_EQ(check("parameter FS_CRASH_CHECK").result, kWarn) << "good advice only";
  EXPECT_EQ(check("firmware").result, kPass);
  EXPECT_EQ(check("signing").result, kWarn);
}

TEST(RoverDevice, SetsParametersWhereItIsToldTo) {
  RoverSettings settings = quick();
  settings.writes_parameters = true;
  Pair pair(settings);
  pair.rover.parameters["FS_GCS_ENABLE"] = 0;
  pair.rover.parameters["GUID_TIMEOUT"] = 3;
  pair.pass(4.0);
  EXPECT_EQ(pair.rover.parameters["FS_GCS_ENABLE"], 1.0F);
  EXPECT_EQ(pair.rover.parameters["GUID_TIMEOUT"], 1.5F);
  EXPECT_EQ(pair.why(), "is not armed");
  EXPECT_TRUE(says(pair.device->take_notes(), "is told to set FS_GCS_ENABLE to 1"));
}

TEST(RoverDevice, SaysWhoElseIsThere) {
  Pair pair;
  Heartbeat copter;
  copter.type = 2;
  copter.autopilot = 3;
  pair.rover.send(copter, pair.now);
  pair.device->work(pair.now);
  EXPECT_EQ(pair.report().readiness, Readiness::kFaulty);
  EXPECT_EQ(pair.why(),
            "is no rover under ArduPilot: its type is 2, its autopilot 3, expected 10 or 11, and 3");
}

TEST(RoverDevice, SpeaksAndHearsOnlyWhatIsSignedWhereItHasAKey) {
  RoverSettings settings = quick();
  settings.key = parse_key("passphrase:ours").value();
  settings.signing_clock = [] { return SigningTime{1'000'000}; };
  Pair same(settings, settings.key);
  same.rover.signing_time = 1'000'000;
  same.pass(2.0);
  same.drive(2.0, {1.0, 0.0});
  EXPECT_NEAR(same.rover.speed, 1.0, 1e-6) << same.why();
  Pair other(settings, parse_key("passphrase:theirs").value());
  other.rover.signing_time = 1'000'000;
  other.pass(2.0);
  EXPECT_EQ(other.why(), "has not been heard yet: what comes is signed with another key");
  EXPECT_FALSE(other.rover.heard_ground_station_at);
  Pair none(settings);
  none.pass(2.0);
  EXPECT_EQ(none.why(), "has not been heard yet: what comes is not signed, and a key is set");
}

TEST(RoverDevice, TellsTheRoverToStopWhenItIsDestroyed) {
  Pair pair(quick());
  pair.pass(2.0);
  pair.drive(2.0, {1.0, 0.0});
  pair.device.reset();
  pair.now += std::chrono::milliseconds(50);
  pair.rover.work(pair.now);
  EXPECT_EQ(pair.rover.mode, Mode::kHold);
  EXPECT_EQ(pair.rover.speed, 0.0);
}

TEST(RoverDevice, DrivesAndStopsOverALinkThatLosesAFifthAndIsLate) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Pair pair(quick());
    pair.link.random = base::Random(seed);
    pair.link.loss = 0.2;
    pair.link.delay = std::chrono::milliseconds(200);
    pair.pass(10.0);
    pair.drive(5.0, {1.0, 0.0});
    EXPECT_EQ(pair.report().readiness, Readiness::kReady) << pair.why();
    double way = pair.rover.north;
    pair.drive(20.0, {1.0, 0.0});
    way = pair.rover.north - way;
    EXPECT_NEAR(way, 20.0, 0.5);
    pair.device->stop(pair.now);
    pair.pass(2.0);
    EXPECT_EQ(pair.rover.speed, 0.0);
    EXPECT_EQ(pair.rover.mode, Mode::kHold);
    EXPECT_EQ(pair.rover.forced_disarms, 0);
    pair.drive(3.0, {1.0, 0.0});
    EXPECT_EQ(pair.report().readiness, Readiness::kReady) << pair.why();
  }
}

TEST(RoverDevice, ComesBackAHundredTimes) {
  Pair pair(quick());
  base::Random random(42);
  pair.link.random = base::Random(43);
  pair.link.loss = 0.1;
  for (int i = 0; i < 100; ++i) {
    SCOPED_TRACE(i);
    pair.link.is_cut = false;
    if (random.below(4) == 0) pair.rover.restart(pair.now);
    // Parameters are asked for again, and each question may get lost some times.
    for (int k = 0; k < 40 && pair.report().readiness != Readiness::kReady; ++k) pair.drive(0.5, {1.0, 0.0});
    ASSERT_EQ(pair.report().readiness, Readiness::kReady) << pair.why();
    pair.drive(random.uniform(0.0, 1.0), {1.0, 0.0});
    pair.link.is_cut = true;
    pair.pass(pair.device->limits().standstill, [&] { pair.device->drive({1.0, 0.0}, pair.now); });
    ASSERT_EQ(pair.rover.speed, 0.0) << "it stands within its stated time";
    pair.pass(random.uniform(0.7, 3.0), [&] { pair.device->drive({1.0, 0.0}, pair.now); });
    ASSERT_EQ(pair.report().readiness, Readiness::kSilent);
  }
}

}  // namespace
}  // namespace mlab::mavlink
