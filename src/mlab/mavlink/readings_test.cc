#include "mlab/mavlink/readings.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "mlab/mavlink/ardupilot.h"

namespace mlab::mavlink {
namespace {

using std::chrono::milliseconds;

constexpr double kPi = std::numbers::pi;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
const Readings::Time kBegin{std::chrono::hours(1)};

Readings::Time at(int ms) {
  return kBegin + milliseconds(ms);
}

LocalPositionNed position(std::uint32_t ms, float north, float east, float v_north = 0.0F,
                          float v_east = 0.0F) {
  return {ms, north, east, 0, v_north, v_east, 0};
}
Attitude attitude(std::uint32_t ms, float yaw, float rate = 0.0F) {
  return {ms, 0, 0, yaw, 0, 0, rate};
}

// Of a rover that looks so, at one place.
vehicle::Motion motion_with(float yaw, float v_north, float v_east, float rate) {
  Readings readings({}, 2.0);
  readings.take(attitude(0, yaw, rate), at(0));
  readings.take(position(0, 3, 4, v_north, v_east), at(0));
  return readings.motion(at(0)).value();
}

std::vector<vehicle::Scan> scans_of(const Readings& readings, int ms = 0) {
  std::vector<vehicle::Scan> out;
  readings.scans(at(ms), out);
  return out;
}

TEST(Readings, TurnNorthEastDownIntoEastNorth) {
  const vehicle::Motion north = motion_with(0, 1, 0, 0.25F);
  EXPECT_EQ(north.pose.position, (geom::Point{4, 3}));
  EXPECT_NEAR(north.pose.heading, kPi / 2, 1e-6);
  EXPECT_NEAR(north.speed, 1.0, 1e-6);
  EXPECT_DOUBLE_EQ(north.turn_rate, -0.25);
  const vehicle::Motion east = motion_with(static_cast<float>(kPi / 2), 0, 1, 0);
  EXPECT_NEAR(east.pose.heading, 0.0, 1e-6);
  EXPECT_NEAR(east.speed, 1.0, 1e-6);
  const vehicle::Motion west = motion_with(static_cast<float>(-kPi / 2), 0, 1, 0);
  EXPECT_NEAR(std::abs(west.pose.heading), kPi, 1e-6);
  EXPECT_NEAR(west.speed, -1.0, 1e-6) << "it goes backwards";
  // What is pushed sideways has no speed along its heading.
  EXPECT_NEAR(motion_with(0, 0, 1, 0).speed, 0.0, 1e-6);
}

TEST(Readings, PlaceTheRoversFrameInTheWorld) {
  Readings readings(geom::Point{100, 200}, 2.0);
  readings.take(attitude(0, 0), at(0));
  readings.take(position(0, 3, 4), at(0));
  EXPECT_EQ(readings.motion(at(0))->pose.position, (geom::Point{104, 203}));
}

TEST(Readings, TellPlaceAndHeadingOfOneMoment) {
  Readings readings({}, 2.0);
  readings.take(attitude(0, 0.0F), at(0));
  readings.take(position(0, 0, 0), at(0));
  readings.take(attitude(100, 0.5F), at(100));  // what was said of its place then is lost
  EXPECT_NEAR(readings.motion(at(100))->pose.heading, kPi / 2, 1e-6);
  EXPECT_EQ(readings.motion(at(100))->at, at(0));
  readings.take(attitude(200, 1.0F), at(200));
  readings.take(position(200, 2, 0), at(200));
  EXPECT_NEAR(readings.motion(at(200))->pose.heading, kPi / 2 - 1.0, 1e-6);
  EXPECT_EQ(readings.motion(at(200))->at, at(200));
}

TEST(Readings, TellPlaceAndHeadingOfOneMomentWhereTheyAreSaidByTurns) {
  Readings readings({}, 2.0);
  readings.take(attitude(0, 0.0F), at(0));
  readings.take(position(50, 1, 0), at(50));
  readings.take(attitude(100, 0.5F), at(100));
  EXPECT_EQ(readings.motion(at(100))->at, at(50));
  EXPECT_NEAR(readings.motion(at(100))->pose.heading, kPi / 2 - 0.25, 1e-6);
}

TEST(Readings, TellPlaceAndHeadingAlsoWhereTheyPartAndMeetAgain) {
  Readings readings({}, 2.0);
  const auto go_on = [&](std::uint32_t from, std::uint32_t apart) {
    for (std::uint32_t ms = from; ms < from + 2000; ms += 100) {
      const int now = static_cast<int>(ms + apart);
      readings.take(attitude(ms, static_cast<float>(ms) / 10'000.0F), at(static_cast<int>(ms)));
      readings.take(position(ms + apart, static_cast<float>(ms + apart) / 1000.0F, 0), at(now));
      const auto motion = readings.motion(at(now));
      ASSERT_TRUE(motion) << ms;
      if (ms >= from + 500) {
        EXPECT_GE(motion->at, at(now - 100)) << ms;
      }
      const double told = std::chrono::duration<double>(motion->at - kBegin).count();
      EXPECT_NEAR(motion->pose.position.y, told, 1e-3) << ms;
      EXPECT_NEAR(motion->pose.heading, kPi / 2 - told / 10.0, 1e-3) << ms;
    }
  };
  go_on(0, 0);
  go_on(2000, 50);
  go_on(4000, 0);
  go_on(6000, 35);
}

TEST(Readings, KnowWhichPointOfTheRoversFrameIsWhereOnTheEarth) {
  Readings readings({}, 2.0);
  GlobalPositionInt place;
  place.time_boot_ms = 150;
  place.lat = 482082000;
  place.lon = 163738000;
  EXPECT_FALSE(readings.fix(at(0)));
  readings.take(position(100, 0, 0, 1.0F), at(100));
  readings.take(place, at(150));
  ASSERT_TRUE(readings.fix(at(150)));
  EXPECT_NEAR(readings.fix(at(150))->point.y, 0.05, 1e-6) << "as it moved";
  readings.take(position(200, 0.2F, 0, 1.0F), at(200));
  const vehicle::Fix fix = readings.fix(at(200)).value();
  EXPECT_NEAR(fix.point.y, 0.1, 1e-6) << "between what it has said";
  EXPECT_NEAR(fix.place.latitude_deg, 48.2082, 1e-9);
  EXPECT_NEAR(fix.place.longitude_deg, 16.3738, 1e-9);
  EXPECT_NEAR(fix.north, kPi / 2, 1e-9);
  EXPECT_FALSE(readings.fix(at(1200)));
}

TEST(Readings, NoticeThatTheVehicleHasBegunAgainSoonAfterItBegan) {
  Readings readings({}, 2.0);
  readings.take(position(4000, 0, 0), at(4000));
  bool has_begun_again = false;
  for (int ms = 0; ms < 1000; ms += 100)
    has_begun_again =
        has_begun_again || readings.take(position(static_cast<std::uint32_t>(ms), 5, 5), at(6000 + ms));
  EXPECT_TRUE(has_begun_again);
}

TEST(Readings, AreNotThereAnyMoreWhenTheyAreOld) {
  Readings readings({}, 2.0);
  readings.take(attitude(0, 0), at(0));
  EXPECT_FALSE(readings.motion(at(0))) << "a heading is no place";
  readings.take(position(0, 3, 4), at(0));
  EXPECT_TRUE(readings.motion(at(1000)));
  EXPECT_FALSE(readings.motion(at(1001)));
  readings.take(position(1000, 3, 4), at(1001));
  EXPECT_FALSE(readings.motion(at(1001))) << "it is as old as the older of both";
}

TEST(Readings, DropWhatIsNoNumberOrOutOfRange) {
  Readings readings({}, 2.0);
  for (const Attitude& wrong :
       {attitude(0, kNan), attitude(0, 0, kNan), attitude(0, 1e9F), attitude(0, 0, 1e9F)})
    readings.take(wrong, at(0));
  for (const LocalPositionNed& wrong : {position(0, kNan, 0), position(0, 0, INFINITY), position(0, 2e6F, 0),
                                        position(0, 0, 0, kNan), position(0, 0, 0, 0, 1000)})
    readings.take(wrong, at(0));
  GlobalPositionInt nowhere;
  readings.take(nowhere, at(0));
  nowhere.lat = 900'000'001;
  readings.take(nowhere, at(0));
  EXPECT_EQ(readings.dropped(), 11U);
  readings.take(attitude(0, 0), at(0));
  readings.take(position(0, 0, 0), at(0));
  EXPECT_TRUE(readings.motion(at(0)));
  EXPECT_FALSE(readings.place(at(0)));
}

TEST(Readings, DropWhatWasOvertakenAndTellARestart) {
  Readings readings({}, 2.0);
  readings.take(attitude(10'000, 0), at(0));
  EXPECT_FALSE(readings.take(position(10'000, 1, 0), at(0)));
  EXPECT_FALSE(readings.take(position(9'900, 2, 0), at(10)));
  EXPECT_EQ(readings.motion(at(10))->pose.position.y, 1.0);
  EXPECT_EQ(readings.dropped(), 1U);
  EXPECT_TRUE(readings.take(position(500, 3, 0), at(20)));
  readings.begin_anew();
  EXPECT_FALSE(readings.motion(at(20)));
  EXPECT_FALSE(readings.take(position(600, 3, 0), at(120)));
}

TEST(Readings, KnowHowMuchLaterThanOthersSomethingCame) {
  Readings readings({}, 2.0);
  readings.take(attitude(0, 0), at(50));
  readings.take(position(100, 0, 0), at(150));
  readings.take(attitude(200, 0), at(250));
  readings.take(position(200, 0, 0), at(650));
  EXPECT_NEAR(std::chrono::duration<double>(at(650) - readings.motion(at(650))->at).count(), 0.4, 1e-3);
  // However it lies, nothing is of the future.
  readings.take(attitude(4'000'000'000, 0), at(700));
  readings.take(position(4'000'000'000, 0, 0), at(700));
  EXPECT_LE(readings.motion(at(700))->at, at(700));
}

TEST(Readings, ForgetAfterTenSecondsWhatCameFaster) {
  Readings readings({}, 2.0);
  const auto is_known_at = [&](int ms, int boot_ms) {
    readings.take(attitude(static_cast<std::uint32_t>(boot_ms), 0), at(ms));
    readings.take(position(static_cast<std::uint32_t>(boot_ms), 0, 0), at(ms));
    return readings.motion(at(ms)).has_value();
  };
  EXPECT_TRUE(is_known_at(0, 3000));
  // It began again unseen, and counts from three seconds less.
  EXPECT_FALSE(is_known_at(4000, 4000));
  EXPECT_FALSE(is_known_at(9000, 9000));
  EXPECT_TRUE(is_known_at(14'100, 14'100));
}

TEST(Readings, TellAJumpThatNoSpeedExplains) {
  Readings readings({}, 2.0);
  readings.take(position(0, 0, 0), at(0));
  readings.take(position(1000, 2, 0), at(1000));
  EXPECT_EQ(readings.jump(at(1000)), 0.0) << "that is as fast as it goes";
  readings.take(position(1100, 12, 0), at(1100));
  EXPECT_DOUBLE_EQ(readings.jump(at(1100)), 10.0);
  EXPECT_DOUBLE_EQ(readings.jump(at(2100)), 10.0);
  EXPECT_EQ(readings.jump(at(2101)), 0.0);
}

TEST(Readings, TellTheBatteryOnlyWhereItIsKnown) {
  Readings readings({}, 2.0);
  SysStatus message;
  message.battery_remaining = -1;
  message.voltage_battery = 12'000;
  readings.take(message, at(0));
  EXPECT_FALSE(readings.battery(at(0)));
  message.battery_remaining = 40;
  readings.take(message, at(0));
  EXPECT_DOUBLE_EQ(readings.battery(at(0))->share, 0.4);
  EXPECT_DOUBLE_EQ(readings.battery(at(0))->voltage, 12.0);
  BatteryStatus cells;
  cells.voltages = {4000, 4100, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535};
  cells.battery_remaining = 39;
  readings.take(cells, at(0));
  EXPECT_DOUBLE_EQ(readings.battery(at(0))->voltage, 8.1);
  cells.battery_remaining = 101;
  readings.take(cells, at(0));
  cells.battery_remaining = 7;
  cells.id = 1;
  readings.take(cells, at(0));
  EXPECT_DOUBLE_EQ(readings.battery(at(0))->share, 0.39) << "of its own battery, and a share";
  EXPECT_FALSE(readings.battery(at(10'001)));
}

TEST(Readings, ReadSensorsOfDistanceByWhereTheyLook) {
  Readings readings({}, 2.0);
  DistanceSensor message;
  message.min_distance = 20;
  message.max_distance = 500;
  message.current_distance = 150;
  message.orientation = 2;
  message.horizontal_fov = 0.1F;
  readings.take(message, at(0));
  message.orientation = 7;
  message.current_distance = 501;
  readings.take(message, at(0));
  message.orientation = 0;
  message.current_distance = 10;
  readings.take(message, at(0));
  message.orientation = 25;  // down
  readings.take(message, at(0));
  const auto scans = scans_of(readings);
  ASSERT_EQ(scans.size(), 3U);
  EXPECT_TRUE(std::isnan(scans[0].distances[0])) << "it can't see what is so near";
  EXPECT_NEAR(scans[1].mount.heading, -kPi / 2, 1e-9) << "to the right";
  EXPECT_FLOAT_EQ(scans[1].distances[0], 1.5F);
  EXPECT_NEAR(scans[1].beam_width, 0.1, 1e-6);
  EXPECT_NEAR(scans[2].mount.heading, kPi / 4, 1e-9) << "half left";
  EXPECT_TRUE(std::isinf(scans[2].distances[0]));
  EXPECT_TRUE(scans_of(readings, 1001).empty());
}

TEST(Readings, TakeScansForAsOldAsTheyAre) {
  Readings readings({}, 2.0);
  DistanceSensor message;
  message.time_boot_ms = 5000;
  message.min_distance = 20;
  message.max_distance = 500;
  readings.take(message, at(0));
  EXPECT_EQ(scans_of(readings).size(), 1U) << "its clock is not known yet";
  readings.take(attitude(6000, 0), at(0));
  readings.take(message, at(0));
  EXPECT_EQ(scans_of(readings, 0).size(), 1U);
  EXPECT_EQ(scans_of(readings, 1).size(), 0U) << "it is a second old";
}

TEST(Readings, ReadDistancesAllRoundCounterClockwise) {
  Readings readings({}, 2.0);
  ObstacleDistance message;
  message.distances.fill(65535);
  message.distances[0] = 100;
  message.distances[1] = 200;
  message.min_distance = 10;
  message.max_distance = 900;
  message.increment = 10;
  message.angle_offset = -5.0F;
  message.frame = kFrameBodyFrd;
  readings.take(message, at(0));
  const vehicle::Scan scan = scans_of(readings).at(0);
  ASSERT_EQ(scan.distances.size(), 36U) << "more would be round and round";
  const auto angle = [&](std::size_t i) {
    return std::remainder(scan.first_angle + scan.step * static_cast<double>(i), 2 * kPi);
  };
  EXPECT_GT(scan.step, 0.0);
  EXPECT_FLOAT_EQ(scan.distances[35], 1.0F);
  EXPECT_NEAR(angle(35), 5.0 * kPi / 180, 1e-6);
  EXPECT_FLOAT_EQ(scan.distances[34], 2.0F);
  EXPECT_NEAR(angle(34), -5.0 * kPi / 180, 1e-6);
  EXPECT_TRUE(std::isnan(scan.distances[0]));
}

TEST(Readings, ReadDistancesFromNorthOnlyWhereItsHeadingIsKnown) {
  Readings readings({}, 2.0);
  ObstacleDistance message;
  message.distances.fill(901);
  message.distances[18] = 300;  // east
  message.min_distance = 10;
  message.max_distance = 900;
  message.increment = 5;
  message.frame = kFrameGlobal;
  readings.take(message, at(0));
  EXPECT_TRUE(scans_of(readings).empty());
  readings.take(attitude(0, static_cast<float>(kPi / 2)), at(0));
  readings.take(message, at(0));
  const vehicle::Scan scan = scans_of(readings).at(0);
  for (std::size_t i = 0; i < scan.distances.size(); ++i) {
    const double angle = std::remainder(scan.first_angle + scan.step * static_cast<double>(i), 2 * kPi);
    EXPECT_EQ(std::isfinite(scan.distances[i]), std::abs(angle) < 0.01) << "it looks east, too";
  }
}

TEST(Readings, DropScansThatCantBe) {
  Readings readings({}, 2.0);
  ObstacleDistance message;
  message.min_distance = 10;
  message.max_distance = 900;
  message.frame = kFrameBodyFrd;
  readings.take(message, at(0));  // no step
  message.increment_f = kNan;
  readings.take(message, at(0));
  message.increment_f = 1.0F;
  message.angle_offset = kNan;
  readings.take(message, at(0));
  message.angle_offset = 0.0F;
  message.max_distance = 10;
  readings.take(message, at(0));
  message.max_distance = 900;
  message.frame = 7;
  readings.take(message, at(0));
  DistanceSensor sensor;
  readings.take(sensor, at(0));
  EXPECT_EQ(readings.dropped(), 6U);
  EXPECT_TRUE(scans_of(readings).empty());
}

}  // namespace
}  // namespace mlab::mavlink
