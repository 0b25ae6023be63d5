#include "mlab/ros2/readings.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

namespace mlab::ros2 {
namespace {

using std::chrono::milliseconds;
using Time = vehicle::Clock::time_point;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr float kNanF = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

Quaternion facing(double angle) {
  return {0.0, 0.0, std::sin(angle / 2.0), std::cos(angle / 2.0)};
}

/// A robot that says all ten milliseconds' multiples where it is, on a clock of its own.
class ReadingsTest : public ::testing::Test {
 protected:
  void begin(const Places& places = {}) {
    readings.emplace(places, std::vector<std::string>{"/scan"}, 1.0);
    pass(500);
  }
  Stamp stamp() const {
    const auto millis = std::chrono::duration_cast<milliseconds>(now.time_since_epoch()).count() + offset;
    return {static_cast<std::int32_t>(millis / 1000), static_cast<std::uint32_t>(millis % 1000) * 1'000'000U};
  }
  Odometry odometry() const {
    return {.stamp = stamp(),
            .frame = "odom",
            .child_frame = "base_link",
            .position = {x, 0.0, 0.0},
            .orientation = facing(0.5),
            .speed = speed,
            .turn_rate = 0.0,
            .writer = 1};
  }
  LaserScan scan() const {
    return {.topic = 0,
            .stamp = stamp(),
            .frame = "laser",
            .angle_min = -1.0F,
            .angle_increment = 0.5F,
            .range_min = 0.2F,
            .range_max = 8.0F,
            .ranges = {1.0F, 2.0F, 3.0F, 4.0F}};
  }
  void take(const Odometry& one) {
    Heard heard;
    heard.odometry = {one};
    readings->take(heard, now);
  }
  void take(const LaserScan& one) {
    Heard heard;
    heard.scans = {one};
    readings->take(heard, now);
  }
  void take(const Transform& one) {
    Heard heard;
    heard.transforms = {one};
    readings->take(heard, now);
  }
  void mount(const Quaternion& rotation = {}) {
    take(Transform{"base_link", "laser", {0.25, 0.0, 0.1}, rotation, true, false});
  }
  void pass(int millis) {
    for (int i = 0; i < millis; i += 50) {
      now += milliseconds(50);
      take(odometry());
    }
  }
  std::optional<vehicle::Scan> seen() const {
    std::vector<vehicle::Scan> out;
    readings->scans(now, out);
    return out.empty() ? std::nullopt : std::optional(out[0]);
  }

  Time now{std::chrono::hours(1)};
  std::int64_t offset = 1'700'000'000'000;  // its clock ahead of ours [ms]
  double x = 0.0;
  double speed = 0.0;
  std::optional<Readings> readings;
};

TEST_F(ReadingsTest, TellWhereItIsAndWhen) {
  begin();
  x = 0.1;
  speed = 0.4;
  now += milliseconds(50);
  const Odometry late = odometry();
  now += milliseconds(120);
  take(late);
  const auto motion = readings->motion(now);
  ASSERT_TRUE(motion) << readings->why_no_motion(now);
  EXPECT_EQ(motion->pose.position.x, 0.1);
  EXPECT_NEAR(motion->pose.heading, 0.5, 1e-9);
  EXPECT_EQ(motion->speed, 0.4);
  EXPECT_NEAR(vehicle::seconds_between(motion->at, now), 0.12, 0.005) << "as old as it was under way";
  EXPECT_EQ(readings->clock().theirs(now - milliseconds(120)).sec, late.stamp.sec);
  EXPECT_EQ(readings->base_frame(), "base_link");
  now += milliseconds(1001);
  EXPECT_FALSE(readings->motion(now));
  EXPECT_EQ(readings->why_no_motion(now), "has said nothing for more than a second");
}

TEST_F(ReadingsTest, AreNotThereBeforeAnythingCanBeCountedOn) {
  readings.emplace(Places{}, std::vector<std::string>{}, 1.0);
  EXPECT_EQ(readings->why_no_motion(now), "has not been heard yet");
  take(odometry());
  EXPECT_FALSE(readings->motion(now));
  pass(500);
  EXPECT_TRUE(readings->motion(now));
}

TEST_F(ReadingsTest, LeaveOutWhatIsNoPlaceOrHasNoTime) {
  begin();
  now += milliseconds(1100);
  for (const auto& change : std::vector<void (*)(Odometry&)>{
           [](Odometry& o) { o.position.x = kNan; }, [](Odometry& o) { o.position.y = 1e9; },
           [](Odometry& o) { o.orientation = {0.0, 0.0, 0.0, 0.0}; },
           [](Odometry& o) { o.orientation.w = kNan; }, [](Odometry& o) { o.speed = kNan; },
           [](Odometry& o) { o.turn_rate = 1e300; }}) {
    Odometry bad = odometry();
    change(bad);
    take(bad);
    EXPECT_FALSE(readings->motion(now));
    EXPECT_EQ(readings->why_no_motion(now), "makes no sense: its odometry is no place and no speed");
  }
  Odometry timeless = odometry();
  timeless.stamp = {};
  take(timeless);
  EXPECT_EQ(readings->why_no_motion(now), "does not say when: its odometry has no times");
  timeless.stamp = {5, 4'000'000'000};
  take(timeless);
  EXPECT_FALSE(readings->motion(now));
}

TEST_F(ReadingsTest, KeepTheNewestWhereMessagesOvertakeEachOther) {
  begin();
  const Odometry old = odometry();
  x = 0.2;
  pass(50);
  take(old);
  EXPECT_EQ(readings->motion(now)->pose.position.x, 0.2);
  EXPECT_TRUE(readings->take_news().empty());
}

TEST_F(ReadingsTest, BeginAnewWhereItsClockRunsBackwardsOrIsSet) {
  for (const std::int64_t set : {std::int64_t{-3'600'000}, std::int64_t{7'200'000}, std::int64_t{0}}) {
    offset = 1'700'000'000'000;
    begin();
    offset = set;
    pass(50);
    EXPECT_EQ(readings->take_news(),
              std::vector<std::string>{"has begun again: its clock runs from elsewhere"});
    EXPECT_FALSE(readings->motion(now)) << "nobody knows yet how late that was";
    pass(500);
    EXPECT_TRUE(readings->motion(now));
  }
}

TEST_F(ReadingsTest, TellAJumpThatNoSpeedExplains) {
  begin();
  x = 0.2;
  pass(50);
  EXPECT_EQ(readings->jump(now), 0.0);
  x = 3.2;
  pass(50);
  EXPECT_NEAR(readings->jump(now), 3.0, 1e-9);
  EXPECT_EQ(readings->take_news(), std::vector<std::string>{"has jumped by 3.0 m, as its odometry says"});
  pass(1100);
  EXPECT_EQ(readings->jump(now), 0.0);
}

TEST_F(ReadingsTest, BelieveOneOfTwoWhoPublishItsOdometry) {
  begin();
  Odometry other = odometry();
  other.writer = 2;
  other.position.x = 50.0;
  for (int i = 0; i < 10; ++i) {
    pass(50);
    other.stamp = stamp();
    take(other);
  }
  EXPECT_EQ(readings->motion(now)->pose.position.x, 0.0);
  EXPECT_EQ(readings->jump(now), 0.0);
  EXPECT_EQ(
      readings->take_news(),
      std::vector<std::string>{"is told of by two who publish its odometry: only the first is believed"});
  now += milliseconds(1200);
  other.stamp = stamp();
  take(other);
  EXPECT_EQ(readings->motion(now)->pose.position.x, 50.0) << "the first one has gone";
}

TEST_F(ReadingsTest, HaveStoodOnceTwoMessagesOfLaterSaySo) {
  speed = 0.3;
  begin();
  const Time then = now;
  pass(500);
  EXPECT_FALSE(readings->has_stood_since(then));
  speed = 0.0;
  pass(50);
  EXPECT_FALSE(readings->has_stood_since(then));
  pass(50);
  EXPECT_TRUE(readings->has_stood_since(then));
  EXPECT_FALSE(readings->has_stood_since(now));
}

TEST_F(ReadingsTest, PutAScannerWhereTfSaysThatItIs) {
  begin();
  mount(facing(std::numbers::pi));
  take(scan());
  const auto is = seen();
  ASSERT_TRUE(is);
  EXPECT_EQ(is->mount.position.x, 0.25);
  EXPECT_NEAR(std::abs(is->mount.heading), std::numbers::pi, 1e-9);
  EXPECT_EQ(is->first_angle, -1.0);
  EXPECT_EQ(is->step, 0.5);
  EXPECT_EQ(is->distances, (std::vector<float>{1.0F, 2.0F, 3.0F, 4.0F}));
  pass(1100);
  EXPECT_FALSE(seen());
}

TEST_F(ReadingsTest, TurnTheBeamsOfAScannerThatHangsUpsideDown) {
  begin();
  mount({1.0, 0.0, 0.0, 0.0});
  take(scan());
  ASSERT_TRUE(seen());
  EXPECT_EQ(seen()->first_angle, 1.0);
  EXPECT_EQ(seen()->step, -0.5);
}

TEST_F(ReadingsTest, DoNotUseAScannerThatLooksAtTheFloor) {
  begin();
  mount({0.0, std::sin(0.5), 0.0, std::cos(0.5)});
  take(scan());
  EXPECT_FALSE(seen());
  EXPECT_EQ(readings->take_news(),
            std::vector<std::string>{"scanner /scan is not used: it looks up or down"});
}

TEST_F(ReadingsTest, SayThatAScannersPlaceIsNotKnownAndTakeItToBeInTheMiddle) {
  begin();
  take(scan());
  EXPECT_FALSE(seen()) << "tf may come yet";
  pass(3100);
  take(scan());
  ASSERT_TRUE(seen());
  EXPECT_EQ(seen()->mount, geom::Pose{});
  EXPECT_EQ(readings->take_news(),
            std::vector<std::string>{"scanner /scan is taken to be in the middle and to look ahead: no tf "
                                     "leads from `base_link` to `laser`"});
  mount();
  pass(50);
  take(scan());
  EXPECT_EQ(seen()->mount.position.x, 0.25);
  EXPECT_EQ(readings->take_news(), std::vector<std::string>{"scanner /scan is well again"});
}

TEST_F(ReadingsTest, DoNotUseScansOfAnotherClock) {
  begin();
  mount();
  LaserScan other = scan();
  other.stamp.sec += 20;
  take(other);
  EXPECT_FALSE(seen());
  EXPECT_EQ(readings->take_news(),
            std::vector<std::string>{"scanner /scan is 20.0 s ahead of its odometry: is its clock another?"});
  other.stamp.sec -= 1'000'000;
  take(other);
  EXPECT_FALSE(seen());
}

TEST_F(ReadingsTest, RefuseScansThatCanNotBe) {
  begin();
  mount();
  for (const auto& change : std::vector<void (*)(LaserScan&)>{
           [](LaserScan& s) { s.ranges.clear(); }, [](LaserScan& s) { s.ranges.assign(200'000, 1.0F); },
           [](LaserScan& s) { s.angle_increment = 0.0F; }, [](LaserScan& s) { s.angle_increment = 7.0F; },
           [](LaserScan& s) { s.angle_increment = kNanF; }, [](LaserScan& s) { s.angle_min = kInfinity; },
           [](LaserScan& s) { s.range_min = -1.0F; }, [](LaserScan& s) { s.range_max = 0.1F; },
           [](LaserScan& s) { s.range_max = kNanF; }, [](LaserScan& s) { s.range_max = kInfinity; }}) {
    LaserScan bad = scan();
    change(bad);
    take(bad);
    EXPECT_FALSE(seen());
  }
  take(scan());
  EXPECT_TRUE(seen());
}

TEST(Scan, KnowsNothingWhereABeamIsNoDistance) {
  LaserScan message{.topic = 3,
                    .stamp = {},
                    .frame = {},
                    .angle_min = 0.0F,
                    .angle_increment = 0.1F,
                    .range_min = 0.5F,
                    .range_max = 8.0F,
                    .ranges = {0.0F, 0.4F, kNanF, 9.0F, -1.0F, kInfinity, -kInfinity, 2.0F}};
  vehicle::Scan scan;
  EXPECT_EQ(read_scan(message, scan), "");
  EXPECT_EQ(scan.sensor, 3U);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_TRUE(std::isnan(scan.distances[i])) << i;
  EXPECT_EQ(scan.distances[5], kInfinity) << "nothing is there";
  EXPECT_EQ(scan.distances[6], 0.5F) << "something is too near to be measured";
  EXPECT_EQ(scan.distances[7], 2.0F);
}

TEST(Scan, HasFewerBeamsWhereThereAreVeryMany) {
  LaserScan message{.topic = 0,
                    .stamp = {},
                    .frame = {},
                    .angle_min = -1.5F,
                    .angle_increment = 0.001F,
                    .range_min = 0.1F,
                    .range_max = 8.0F,
                    .ranges = std::vector<float>(3000, kInfinity)};
  message.ranges[4] = 2.0F;
  message.ranges[5] = 1.0F;
  message.ranges[7] = kNanF;
  vehicle::Scan scan;
  EXPECT_EQ(read_scan(message, scan), "");
  ASSERT_EQ(scan.distances.size(), 1000U);
  EXPECT_NEAR(scan.step, 0.003, 1e-7);
  EXPECT_NEAR(scan.beam_width, 0.003, 1e-7);
  EXPECT_NEAR(scan.first_angle, -1.499, 1e-6);
  EXPECT_EQ(scan.distances[0], kInfinity);
  EXPECT_EQ(scan.distances[1], 1.0F);
  EXPECT_TRUE(std::isnan(scan.distances[2]));
}

TEST_F(ReadingsTest, TellWhereItIsOnTheMapWhereTfSays) {
  begin({.map_frame = "map", .origin = geom::Point{100.0, 200.0}});
  EXPECT_FALSE(readings->motion(now));
  EXPECT_EQ(readings->why_no_motion(now),
            "does not know where it is on the map: no tf leads from `map` to `odom`");
  x = 0.1;
  pass(50);
  take(Transform{"map", "odom", {1.0, 2.0, 0.0}, facing(std::numbers::pi / 2.0), false, false});
  const auto motion = readings->motion(now);
  ASSERT_TRUE(motion);
  EXPECT_NEAR(motion->pose.position.x, 101.0, 1e-9);
  EXPECT_NEAR(motion->pose.position.y, 202.1, 1e-9);
  EXPECT_NEAR(motion->pose.heading, 0.5 + std::numbers::pi / 2.0, 1e-9);
  pass(10'100);
  EXPECT_FALSE(readings->motion(now)) << "nobody has said for long where that is";
}

TEST_F(ReadingsTest, HaveABatteryAsLongAsTheRobotIsHeard) {
  begin();
  Heard heard;
  heard.batteries = {{12.5F, 0.5F}};
  readings->take(heard, now);
  ASSERT_TRUE(readings->battery(now));
  EXPECT_EQ(readings->battery(now)->share, 0.5);
  EXPECT_EQ(readings->battery(now)->voltage, 12.5);
  heard.batteries = {{kNanF, kNanF}, {12.0F, -1.0F}, {-5.0F, 87.0F}};
  readings->take(heard, now);
  EXPECT_NEAR(readings->battery(now)->share, 0.87, 1e-6) << "some say per cent";
  EXPECT_EQ(readings->battery(now)->voltage, 0.0);
  pass(5000);
  EXPECT_TRUE(readings->battery(now));
  now += milliseconds(1100);
  EXPECT_FALSE(readings->battery(now));
  pass(5000);
  EXPECT_FALSE(readings->battery(now)) << "it is ten seconds old";
}

}  // namespace
}  // namespace mlab::ros2
