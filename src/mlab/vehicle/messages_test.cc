#include "mlab/vehicle/messages.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace mlab::vehicle {
namespace {

const Clock::time_point kNow{std::chrono::seconds(50)};

Report full_report() {
  Report out;
  out.readiness = Readiness::kReady;
  out.is_global = true;
  out.motion = Motion{{{3.0, -4.0}, 0.5}, 1.5, -0.25, kNow - std::chrono::milliseconds(100)};
  Scan scan;
  scan.sensor = 3;
  scan.mount = {{0.1, 0.2}, 0.3};
  scan.first_angle = -1.0;
  scan.step = 0.5;
  scan.farthest = 8.0;
  scan.distances = {1.0F, std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()};
  scan.at = kNow;
  scan.pose = geom::Pose{{2.9, -4.0}, 0.4};
  out.scans.push_back(scan);
  out.fix = Fix{{48.2082, 16.3738}, {1.0, 2.0}, 1.5, kNow};
  out.battery = Battery{0.5, 12.5, kNow};
  return out;
}

wire::VehicleReport message() {
  wire::VehicleReport out;
  encode(full_report(), kNow, out);
  return out;
}

TEST(VehicleMessages, ArriveAsTheyWereSent) {
  const auto arrived = decode(message(), kNow);
  ASSERT_TRUE(arrived) << arrived.error();
  EXPECT_EQ(arrived->readiness, Readiness::kReady);
  EXPECT_TRUE(arrived->is_global);
  EXPECT_EQ(arrived->motion->pose, full_report().motion->pose);
  EXPECT_NEAR(seconds_between(arrived->motion->at, kNow), 0.1, 1e-6);
  ASSERT_EQ(arrived->scans.size(), 1U);
  EXPECT_EQ(arrived->scans[0].distances[0], 1.0F);
  EXPECT_TRUE(std::isinf(arrived->scans[0].distances[1]));
  EXPECT_TRUE(std::isnan(arrived->scans[0].distances[2]));
  EXPECT_EQ(arrived->scans[0].pose, full_report().scans[0].pose);
  ASSERT_TRUE(arrived->fix);
  EXPECT_EQ(arrived->fix->place, full_report().fix->place);
  EXPECT_EQ(arrived->fix->point, full_report().fix->point);
  EXPECT_EQ(arrived->fix->north, 1.5);
  EXPECT_EQ(arrived->battery->share, 0.5);
}

TEST(VehicleMessages, AreRefusedWhereSomethingIsNoNumberOrBeyondAllBounds) {
  wire::VehicleReport nowhere = message();
  nowhere.mutable_motion()->mutable_pose()->set_x(std::nan(""));
  EXPECT_EQ(decode(nowhere, kNow).error(), "its motion is none");
  wire::VehicleReport old = message();
  old.mutable_motion()->set_age(-1.0);
  EXPECT_FALSE(decode(old, kNow));
  wire::VehicleReport behind = message();
  behind.mutable_scans(0)->set_distances(0, -1.0F);
  EXPECT_EQ(decode(behind, kNow).error(), "scan of sensor 3 is none");
  wire::VehicleReport polar = message();
  polar.mutable_fix()->set_latitude_deg(89.0);
  EXPECT_EQ(decode(polar, kNow).error(), "its place on the Earth is none");
  wire::VehicleReport charged = message();
  charged.mutable_battery()->set_share(1.5);
  EXPECT_FALSE(decode(charged, kNow));
  wire::VehicleReport unknown = message();
  unknown.set_readiness(9);
  EXPECT_EQ(decode(unknown, kNow).error(), "readiness is 9, expected 0 to 6");
}

TEST(VehicleMessages, LimitsAreCheckedByName) {
  wire::OfferedVehicle said;
  said.set_drive(1);
  said.set_radius(0.4);
  said.set_wheelbase(1.0);
  ASSERT_TRUE(limits_of(said));
  said.set_max_speed(-1.0);
  EXPECT_EQ(limits_of(said).error(), "its max_speed is -1, expected 0 to 1000");
  said.set_max_speed(1.0);
  said.set_drive(0);
  EXPECT_EQ(limits_of(said).error(), "its drive is 0, expected 1 to 3");
}

std::vector<Check> checks() {
  return {{"watchdog", CheckResult::kPass, "brakes 0.5 s after its last command", ""},
          {"parameter FS_ACTION", CheckResult::kFail, "is 0", "2"},
          {"firmware", CheckResult::kUnknown, "does not tell its version", ""}};
}

TEST(VehicleChecks, ArriveAsTheyWereSent) {
  const auto arrived = decode_checks(encode(checks()));
  ASSERT_TRUE(arrived) << arrived.error();
  EXPECT_EQ(*arrived, checks());
  EXPECT_EQ(decode_checks("")->size(), 0U);
}

TEST(VehicleChecks, AreBoundedAndFitForPeople) {
  EXPECT_EQ(decode_checks(encode(std::vector<Check>(100, checks()[0])))->size(), kMostChecks);
  wire::VehicleChecks many;
  for (std::size_t i = 0; i <= kMostChecks; ++i) many.add_checks()->set_name("one");
  EXPECT_EQ(decode_checks(many.SerializeAsString()).error(), "it has 65 checks, at most 64 are read");
  wire::VehicleChecks other;
  other.add_checks()->set_name("one");
  other.mutable_checks(0)->set_result(4);
  EXPECT_EQ(decode_checks(other.SerializeAsString()).error(), "result of a check is 4, expected 0 to 3");
  other.mutable_checks(0)->set_result(1);
  other.mutable_checks(0)->set_is(std::string(5000, 'x') + "\x1b[2J");
  EXPECT_LT(decode_checks(other.SerializeAsString())->front().is.size(), 250U);
  other.mutable_checks(0)->set_is("\x1b[2J");
  EXPECT_EQ(decode_checks(other.SerializeAsString())->front().is, "\\x1b[2J");
  other.mutable_checks(0)->clear_name();
  EXPECT_EQ(decode_checks(other.SerializeAsString()).error(), "a check of it has no name");
}

// Likewise.
RC_GTEST_PROP(VehicleChecks, OfAnyBytesAreShortTextsOrNothing, (const std::string& bytes)) {
  std::string mixed = encode(checks());
  mixed.replace(mixed.size() / 2, std::string::npos, bytes);
  const auto arrived = decode_checks(mixed);
  if (!arrived) return;
  for (const Check& one : *arrived) {
    RC_ASSERT(!one.name.empty());
    RC_ASSERT(one.is.find('\x1b') == std::string::npos);
  }
}

// Whatever anybody sends is read to a report of numbers, or refused.
RC_GTEST_PROP(VehicleMessages, OfAnyBytesAreNumbersOrNothing, (const std::string& bytes)) {
  std::string mixed = message().SerializeAsString();
  mixed.replace(mixed.size() / 2, std::string::npos, bytes);
  wire::VehicleReport read;
  if (!read.ParseFromString(mixed)) return;
  const auto arrived = decode(read, kNow);
  if (arrived && arrived->motion) RC_ASSERT(std::isfinite(arrived->motion->pose.position.x));
}

}  // namespace
}  // namespace mlab::vehicle
