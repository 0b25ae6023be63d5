#include <algorithm>
#include <limits>
#include <sstream>

#include <gtest/gtest.h>

#include "mlab/preflight/testing/yard.h"

namespace mlab::preflight {
namespace {

using enum vehicle::CheckResult;
using testing::both_well;

const Item& item(const Checklist& checklist, const std::string& id) {
  static const Item kNone{"", "", "", kUnknown, "there is none", ""};
  const auto at = std::ranges::find(checklist.items, id, &Item::id);
  EXPECT_NE(at, checklist.items.end()) << id << " in\n" << text_of(checklist);
  return at == checklist.items.end() ? kNone : *at;
}

/// What comes out where something of `veh-1` is otherwise.
template <class Change>
Checklist with(Change change) {
  auto facts = both_well();
  change(facts[0]);
  return testing::checklist(facts);
}

TEST(Checklist, IsOfTheVehiclesThatRobotsHaveAsBodies) {
  const Checklist list = testing::checklist();
  EXPECT_EQ(hosts_of(*testing::yard()), (std::vector<std::string>{"veh-1", "veh-2"}));
  ASSERT_EQ(list.vehicles.size(), 2U);
  EXPECT_EQ(list.vehicles[1].name, "veh-2");
  EXPECT_EQ(list.vehicles[1].robots, std::vector<std::uint32_t>{2});
  EXPECT_EQ(item(list, "mission/robots").is, "3 robots, 2 on vehicles");
  EXPECT_TRUE(list.is_needed());
}

TEST(Checklist, HasNothingAgainstVehiclesWithWhichAllIsWell) {
  for (const Item& one : testing::checklist().items) {
    if (one.vehicle.empty()) continue;
    EXPECT_EQ(one.result, kPass) << one.id << ": " << one.is;
  }
  EXPECT_EQ(item(testing::checklist(), "mission/battery-failsafe").result, kWarn);
  EXPECT_EQ(testing::checklist().worst(), kWarn);
}

TEST(Checklist, IsNotNeededWhereNothingRealMoves) {
  auto facts = both_well();
  for (VehicleFacts& one : facts) one.is_simulated = true;
  EXPECT_FALSE(testing::checklist(facts).is_needed());
  facts[1] = {.name = "veh-2", .why_not_there = "has not joined the fleet"};
  EXPECT_FALSE(testing::checklist(facts).is_needed());
  facts[0].is_simulated = false;
  EXPECT_TRUE(testing::checklist(facts).is_needed());
}

TEST(Checklist, SaysOfWhoIsNotThereNothingElse) {
  auto facts = both_well();
  facts[0] = {.name = "veh-1", .why_not_there = "has been silent for 7 s"};
  const Checklist list = testing::checklist(facts);
  EXPECT_EQ(item(list, "veh-1/presence").result, kFail);
  EXPECT_EQ(item(list, "veh-1/presence").is, "has been silent for 7 s");
  EXPECT_EQ(std::ranges::count(list.items, "veh-1", &Item::vehicle), 1);
}

TEST(Checklist, CallsUnknownWhatIsNotKnown) {
  const Checklist list = with([](VehicleFacts& one) {
    one.report->battery.reset();
    one.checks.reset();
    one.report->is_global = false;
  });
  EXPECT_EQ(item(list, "veh-1/battery").result, kUnknown);
  EXPECT_EQ(item(list, "veh-1/its-own-checks").result, kUnknown);
  EXPECT_EQ(item(list, "veh-1/place").result, kUnknown);
  EXPECT_EQ(item(list, "veh-1/place").expected, "stands at (8.0, 12.0) m, looking to 0 degrees");
  // START decides where it will be.
  EXPECT_EQ(item(list, "veh-1/geofence-field").result, kPass);
}

TEST(Checklist, GradesTheLink) {
  const auto graded = [](double round_trip, double lost) {
    return item(with([&](VehicleFacts& one) { one.link = Link{round_trip, lost, 0.0}; }), "veh-1/link")
        .result;
  };
  EXPECT_EQ(graded(0.15, 0.1), kPass);
  EXPECT_EQ(graded(0.16, 0.0), kWarn);
  EXPECT_EQ(graded(0.002, 0.2), kWarn);
  EXPECT_EQ(graded(0.5, 0.0), kFail);
  EXPECT_EQ(graded(0.002, 0.5), kFail);
  EXPECT_EQ(item(with([](VehicleFacts& one) { one.link.reset(); }), "veh-1/link").result, kFail);
}

TEST(Checklist, TellsAClockThatIsWrong) {
  const Checklist list = with([](VehicleFacts& one) { one.link->clock_offset = -90.0; });
  EXPECT_EQ(item(list, "veh-1/clock").result, kWarn);
  EXPECT_EQ(item(list, "veh-1/clock").is, "is 90 s behind this machine's");
}

TEST(Checklist, HoldsThePlaceAgainstStartAndFence) {
  const auto at = [](geom::Point place) {
    return with([&](VehicleFacts& one) { one.report->motion->pose.position = place; });
  };
  EXPECT_EQ(item(at({8.4, 12.0}), "veh-1/place").result, kPass);
  EXPECT_EQ(item(at({10.0, 12.0}), "veh-1/place").result, kWarn);
  EXPECT_EQ(item(at({10.0, 12.0}), "veh-1/place").is, "is at (10.0, 12.0) m, 2.0 m from its START");
  EXPECT_EQ(item(at({800.0, 12.0}), "veh-1/place").result, kFail);
  EXPECT_EQ(item(at({0.1, 12.0}), "veh-1/geofence-field").result, kWarn) << "its edge is over the line";
  EXPECT_EQ(item(at({-1.0, 12.0}), "veh-1/geofence-field").result, kFail);
  EXPECT_EQ(item(at({-1.0, 12.0}), "veh-1/geofence-field").is, "1.0 m outside of its line");
}

TEST(Checklist, WarnsWhereNothingIsStated) {
  const auto bare = testing::yard();
  bare->failsafes.clear();
  bare->steps.clear();
  const Checklist list = assemble(testing::crew(bare), "alpha", both_well(), "1.0");
  EXPECT_EQ(item(list, "mission/failsafes").result, kWarn);
  EXPECT_EQ(item(list, "veh-1/geofence").result, kWarn);
  EXPECT_EQ(item(list, "veh-1/place").is, "no START of the mission names its robot");
}

TEST(Checklist, ComparesTheSpeedAskedForWithTheVehiclesOwn) {
  const auto fast = testing::yard();
  std::get<mission::UnitCommand>(fast->steps[0].commands[0]).speed = 1.5;
  const Checklist list = assemble(testing::crew(fast), "alpha", both_well(), "1.0");
  EXPECT_EQ(item(list, "veh-2/speed").result, kWarn);
  EXPECT_EQ(item(list, "veh-2/speed").is, "the mission asks for up to 1.5 m/s");
}

TEST(Checklist, SaysWhatTheVehicleSaysOfItself) {
  using vehicle::Readiness;
  const auto state = [](Readiness readiness) {
    return item(with([&](VehicleFacts& one) {
                  one.report->readiness = readiness;
                  one.report->why = "is not armed";
                }),
                "veh-1/state");
  };
  EXPECT_EQ(state(Readiness::kStandby).result, kPass);
  EXPECT_EQ(state(Readiness::kStandby).is, "gets ready when it is driven: it is not armed");
  EXPECT_EQ(state(Readiness::kTaken).result, kWarn);
  EXPECT_EQ(state(Readiness::kNotReady).result, kFail);
  EXPECT_EQ(state(Readiness::kFaulty).result, kFail);
  EXPECT_EQ(state(Readiness::kAbsent).result, kFail);
  const Checklist list = with([](VehicleFacts& one) {
    one.checks = {{"parameter FS_ACTION", kFail, "is 0", "2"}, {"parameter FS_ACTION", kPass, "is 2", "2"}};
    one.is_driven = true;
    one.is_stopped = true;
    one.report->scans.clear();
    one.report_age = 2.0;
  });
  EXPECT_EQ(item(list, "veh-1/own/parameter-fs_action").result, kFail);
  EXPECT_EQ(item(list, "veh-1/own/parameter-fs_action-2").result, kPass);
  EXPECT_EQ(item(list, "veh-1/driver").result, kFail);
  EXPECT_EQ(item(list, "veh-1/emergency-stop").result, kWarn);
  EXPECT_EQ(item(list, "veh-1/sensors").result, kWarn);
  EXPECT_EQ(item(list, "veh-1/reports").result, kFail);
}

TEST(Checklist, SaysWhichOfItsLimitsCanNotBe) {
  const Checklist list = with([](VehicleFacts& one) {
    one.limits.reset();
    one.limits_refusal = "its max_speed is -1, expected 0 to 1000";
  });
  EXPECT_EQ(item(list, "veh-1/limits").result, kFail);
  EXPECT_EQ(item(list, "veh-1/limits").is,
            "says limits that can't be: its max_speed is -1, expected 0 to 1000");
}

TEST(Checklist, IsOfVehiclesWhoseStateIsToldAlsoWithoutIt) {
  using Told = binding::VehicleState;
  VehicleFacts one = testing::well("veh-1", {8.0, 12.0});
  one.report->readiness = vehicle::Readiness::kStandby;
  one.report->why = "is not armed";
  one.report->battery->at -= std::chrono::seconds(2);
  one.report_age = 0.5;
  one.is_driven = true;
  const auto told = state_of(one);
  ASSERT_TRUE(told);
  EXPECT_EQ(told->name, "veh-1");
  EXPECT_EQ(told->kind, "rover at udp:14550");
  EXPECT_EQ(told->readiness, Told::Readiness::kStandby);
  EXPECT_EQ(told->why, "is not armed");
  EXPECT_EQ(told->driver, Told::Driver::kAnotherRun);
  EXPECT_EQ(told->age, 0.5);
  EXPECT_EQ(told->battery->share, 0.9);
  EXPECT_NEAR(told->battery->age, 2.5, 1e-9);
  EXPECT_NEAR(*told->motion_age, 0.5, 1e-9);
  ASSERT_EQ(told->sensors.size(), 1U);
  EXPECT_EQ(told->sensors[0].beams, 2U);
  one.is_there = false;
  EXPECT_FALSE(state_of(one));
}

TEST(Checklist, WarnsOfSensorsThatTellNothing) {
  const Checklist list = with([](VehicleFacts& one) {
    one.report->scans[0].distances.assign(8, std::numeric_limits<float>::quiet_NaN());
  });
  EXPECT_EQ(item(list, "veh-1/sensors").result, kWarn);
  EXPECT_EQ(item(list, "veh-1/sensors").is, "0 of 8 beams tell something, up to 10.0 m, 0.0 s old");
}

TEST(Checklist, GivesEachItemAnIdOfItsOwn) {
  std::vector<std::string> ids;
  for (const Item& one : testing::checklist().items) ids.push_back(one.id);
  std::ranges::sort(ids);
  EXPECT_EQ(std::ranges::adjacent_find(ids), ids.end());
}

TEST(ChecklistText, FitsInto80Columns) {
  const std::string text = text_of(with([](VehicleFacts& one) {
    one.checks = {{"parameter SYSID_MYGCS_OF_SOMEBODY_ELSE", kFail, "is 0",
                   "255: it has to count our heartbeats, not somebody else's, and this is a long sentence"}};
  }));
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
  EXPECT_NE(text.find("\nThe vehicle veh-1, body of robot 1\n"), std::string::npos) << text;
  EXPECT_NE(text.find("  pass    link               2.0 ms there and back, nothing lost\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("                             expected: 255: it has to count"), std::string::npos)
      << text;
}

TEST(ChecklistText, HasWhatHasToBeLookedAtFirst) {
  const std::string text = text_of(with([](VehicleFacts& one) {
    one.version = "0.9";
    one.link->round_trip = 1.0;
    one.report->battery->share = 0.1;
    one.checks.reset();
  }));
  const std::size_t begin = text.find("The vehicle veh-1");
  std::vector<std::string> names;
  std::istringstream lines(text.substr(begin, text.find("The vehicle veh-2") - begin));
  for (std::string line; std::getline(lines, line) && names.size() < 6;) {
    if (line.starts_with("  ") && line[2] != ' ') names.push_back(line.substr(2, line.find(' ', 10) - 2));
  }
  EXPECT_EQ(names, (std::vector<std::string>{"FAIL    link", "FAIL    battery", "warn    version",
                                             "unknown its", "pass    presence", "pass    limits"}))
      << text;
}

TEST(MissionDigest, ChangesWithAnyText) {
  const std::string first = digest_of(testing::crew());
  EXPECT_EQ(first, digest_of(testing::crew()));
  EXPECT_EQ(first.size(), 16U);
  const auto other = testing::yard();
  other->texts.push_back(std::make_shared<const text::Source>("yard.odl", "BOUNDARY Field\n"));
  const std::string with_map = digest_of(testing::crew(other));
  EXPECT_NE(with_map, first);
  other->set.emplace_back("base_velocity", "1");
  EXPECT_NE(digest_of(testing::crew(other)), with_map);
}

}  // namespace
}  // namespace mlab::preflight
