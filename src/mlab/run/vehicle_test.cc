#include "mlab/run/vehicle.h"

#include <map>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/base/angle.h"

namespace mlab::run {
namespace {

mission::RobotType type_with(std::vector<mission::RobotParameter> parameters) {
  mission::RobotType type;
  type.parameters = std::move(parameters);
  return type;
}

TEST(BodyOf, IsASmallHolonomicDiscWithoutParameters) {
  text::Diagnostics sink;
  const binding::BodySpec body = body_of(type_with({}), {}, sink);
  EXPECT_EQ(body.radius, 0.2);
  EXPECT_EQ(body.kinematics.drive, binding::Drive::kHolonomic);
  EXPECT_EQ(body.ring.count, 0);
  EXPECT_TRUE(sink.items().empty());
}

TEST(BodyOf, TakesDriveLimitsAndRing) {
  text::Diagnostics sink;
  const binding::BodySpec body = body_of(type_with({{"robot_type", "differential", {}, {}},
                                                    {"robot_radius", "0.5", {}, {}},
                                                    {"max_turn_rate", "90", {}, {}},
                                                    {"ring_count", "24", {}, {}},
                                                    {"ring_range", "3", {}, {}}}),
                                         {}, sink);
  EXPECT_EQ(body.kinematics.drive, binding::Drive::kDifferential);
  EXPECT_EQ(body.radius, 0.5);
  EXPECT_DOUBLE_EQ(body.kinematics.max_turn_rate, base::radians(90));
  EXPECT_EQ(body.ring.count, 24);
  EXPECT_EQ(body.ring.range, 3.0);
}

TEST(BodyOf, SimulatesHistoricRobotTypesAsHolonomicWithoutAWord) {
  text::Diagnostics sink;
  for (const char* historic : {"SIMULATION", "MRV2", "DRV1", "HSERVER"}) {
    EXPECT_EQ(body_of(type_with({{"robot_type", historic, {}, {}}}), {}, sink).kinematics.drive,
              binding::Drive::kHolonomic);
  }
  EXPECT_TRUE(sink.items().empty());
  body_of(type_with({{"robot_type", "HUMMER", {}, {}}}), {}, sink);
  EXPECT_EQ(sink.warning_count(), 1U);
}

TEST(BodyOf, RefusesAValueThatIsNoNumberOrOutOfRange) {
  for (const char* value : {"wide", "-1", "nan", "1e9", ""}) {
    text::Diagnostics sink;
    body_of(type_with({{"robot_radius", value, {}, {}}}), {}, sink);
    EXPECT_EQ(sink.error_count(), 1U) << value;
  }
}

TEST(BodyOf, TakesWhatAConfigurationSaysUnlessTheMissionSaysOtherwise) {
  text::Diagnostics sink;
  const std::map<std::string, double> configured = {
      {"radius", 0.4}, {"drive", 3.0}, {"max_turn_rate", 1.5}, {"ring_arc", 3.0}, {"ring_obstacles", 1.0}};
  const binding::BodySpec body = body_of(type_with({{"robot_radius", "0.6", {}, {}}}), configured, sink);
  EXPECT_EQ(body.radius, 0.6);
  EXPECT_EQ(body.kinematics.drive, binding::Drive::kSynchro);
  EXPECT_EQ(body.kinematics.max_turn_rate, 1.5);
  EXPECT_EQ(body.ring.arc, 3.0);
  EXPECT_EQ(body.ring.first_angle, -1.5);
  EXPECT_TRUE(body.has_ring_obstacles);
  EXPECT_TRUE(sink.items().empty());
}

TEST(BodyOf, SaysNothingMoreOfAValueThatTheProgramRefused) {
  const auto source = std::make_shared<const text::Source>("m.mdl", "robot_radius=-1");
  const text::Place key{source, {0, 12}};
  const text::Place place{source, {13, 15}};
  text::Diagnostics sink;
  body_of(type_with({{"robot_radius", "-1", key, place}}), {}, sink);
  ASSERT_EQ(sink.error_count(), 1U) << "nobody refused it before";
  EXPECT_EQ(source->text(sink.items()[0].place.span), "-1");
  text::Diagnostics refused;
  refused.error("bad-parameter", place, "-1 is out of range");
  body_of(type_with({{"robot_radius", "-1", key, place}}), {}, refused);
  EXPECT_EQ(refused.error_count(), 1U);
}

TEST(BodyOf, RefusesASettingThatNoBodyHas) {
  text::Diagnostics sink;
  body_of(type_with({}), {{"rdius", 0.4}, {"ring_range", -1.0}}, sink);
  ASSERT_EQ(sink.error_count(), 2U);
  EXPECT_EQ(sink.items()[0].hints, (std::vector<std::string>{"did you mean `radius`?"}));
  EXPECT_EQ(sink.items()[1].kind, "out-of-range");
}

}  // namespace
}  // namespace mlab::run
