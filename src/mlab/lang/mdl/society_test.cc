#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/lang/mdl/mdl.h"
#include "mlab/lang/mdl/testing/societies.h"

namespace mlab::mdl {
namespace {

constexpr const char* kQuitAtOnce = "COMMAND LIST:\n0. QUIT\n";
constexpr const char* kParty = "NEW-ROBOT p \"x.cdl#Party\" red (load = 2)\n";

std::shared_ptr<const mission::Mission> checked_with_societies(const std::string& text) {
  LoadOptions options;
  options.societies = testing::known_society;
  text::Diagnostics sink;
  auto mission = check_mission(std::make_shared<const text::Source>("test.mdl", text), "", sink, options);
  EXPECT_NE(mission, nullptr) << text::render(sink);
  EXPECT_TRUE(sink.items().empty()) << text::render(sink);
  return mission ? mission : std::make_shared<const mission::Mission>();
}

std::string errors_with_societies(const std::string& text) {
  LoadOptions options;
  options.societies = testing::known_society;
  text::Diagnostics sink;
  check_mission(std::make_shared<const text::Source>("test.mdl", text), "", sink, options);
  return text::render(sink);
}

// `1 p#Scout, 2 p#Carrier`
std::string robots_in(const mission::Mission& mission, const mission::Unit& unit) {
  std::string out;
  for (const base::RobotId id : unit.members) {
    for (const mission::Robot& robot : mission.robots) {
      if (robot.id != id) continue;
      out += (out.empty() ? "" : ", ") + std::to_string(id.value) + " " + mission.types[robot.type].name;
    }
  }
  return out;
}

TEST(MdlSocieties, AreAUnitOfTheTypesNameWhereNoUnitNamesThem) {
  const auto mission = checked_with_societies(std::string(kParty) + "UNIT <u> ROBOT\n" + kQuitAtOnce);
  ASSERT_EQ(mission->units.size(), 2U);
  EXPECT_EQ(mission->units[1].name, "p");
  EXPECT_EQ(robots_in(*mission, mission->units[1]), "2 p#Scout, 3 p#Scout, 4 p#Carrier");
  ASSERT_EQ(mission->types.size(), 3U);
  EXPECT_EQ(mission->types[1].program, "x.cdl#Scout");
  EXPECT_EQ(mission->types[2].program, "x.cdl#Carrier");
  for (const std::size_t i : {1U, 2U}) {
    EXPECT_EQ(mission->types[i].color, "red");
    EXPECT_EQ(mission->types[i].parameters.at(0).value, "2");
  }
}

TEST(MdlSocieties, StandInAUnitForAllTheirRobotsAnewEachTime) {
  const auto mission =
      checked_with_societies(std::string(kParty) + "UNIT <team> (<wing> P ROBOT) (<rest> p)\n" + kQuitAtOnce);
  ASSERT_EQ(mission->units.size(), 3U) << "no unit of its own name";
  EXPECT_EQ(robots_in(*mission, mission->units[0]),
            "1 p#Scout, 2 p#Scout, 3 p#Carrier, 4 ROBOT, 5 p#Scout, 6 p#Scout, 7 p#Carrier");
  EXPECT_EQ(robots_in(*mission, mission->units[2]), "5 p#Scout, 6 p#Scout, 7 p#Carrier");
}

TEST(MdlSocieties, HaveNoMoreRobotsThanThereMayBe) {
  const std::string commands = std::string("UNIT <u> a b\n") + kQuitAtOnce;
  for (const char* two : {"NEW-ROBOT a \"x.cdl#Half\"\nNEW-ROBOT b \"x.cdl#Half\"\n",
                          "NEW-ROBOT a \"x.cdl#Half\"\nNEW-ROBOT b \"x.cdl#Swarm\"\n",
                          "NEW-ROBOT a \"x.cdl#Swarm\"\nNEW-ROBOT b \"x.cdl#Party\"\n"}) {
    const std::string said = errors_with_societies(two + commands);
    EXPECT_NE(said.find("too-many-robots"), std::string::npos) << said;
  }
}

TEST(MdlSocieties, LeaveTheirNameToAUnitThatHasItAlready) {
  LoadOptions options;
  options.societies = testing::known_society;
  text::Diagnostics sink;
  const std::string text = std::string(kParty) + "UNIT <p> ROBOT\n" + kQuitAtOnce;
  const auto mission =
      check_mission(std::make_shared<const text::Source>("test.mdl", text), "", sink, options);
  ASSERT_TRUE(mission);
  ASSERT_EQ(mission->units.size(), 1U);
  EXPECT_EQ(robots_in(*mission, mission->units[0]), "1 ROBOT");
  ASSERT_EQ(sink.items().size(), 1U);
  EXPECT_EQ(sink.items()[0].kind, "unused-society");
}

TEST(MdlSocieties, GiveTheirFirstRobotTheNumberThatTheyWish) {
  const auto mission = checked_with_societies(
      std::string("NEW-ROBOT p \"x.cdl#Party\" (desired_robot_id = 7)\n") + kQuitAtOnce);
  EXPECT_EQ(robots_in(*mission, mission->units.at(0)), "7 p#Scout, 8 p#Scout, 9 p#Carrier");
}

TEST(MdlSocieties, LetAUnitNameTheirRobotsOneByOne) {
  const auto mission = checked_with_societies(std::string(kParty) + "UNIT <u> \"p#Carrier\"\n" + kQuitAtOnce);
  EXPECT_EQ(robots_in(*mission, mission->units.at(0)), "1 p#Carrier");
  EXPECT_EQ(mission->units.size(), 2U) << "the society is in no unit yet";
}

TEST(MdlSocieties, HaveOneNameWithRobotTypes) {
  EXPECT_NE(errors_with_societies(std::string(kParty) + "NEW-ROBOT P robot\n" + kQuitAtOnce)
                .find("[duplicate-robot-type]"),
            std::string::npos);
  EXPECT_NE(errors_with_societies(std::string("NEW-ROBOT p robot\n") + kParty + kQuitAtOnce)
                .find("[duplicate-robot-type]"),
            std::string::npos);
}

TEST(MdlSocieties, SayOnceWhatIsWrongWithTheirConfiguration) {
  const std::string errors = errors_with_societies(
      "NEW-ROBOT p \"x.cdl#Prty\"\nUNIT <u> ROBOT\nCOMMAND LIST:\n0. UNIT p START 10 10\n1. UNIT u START 1 "
      "1\n");
  EXPECT_EQ(errors.find("unknown-unit"), std::string::npos) << errors;
  EXPECT_NE(errors.find("no robot or society `Prty`"), std::string::npos) << errors;
}

TEST(MdlSocieties, MayBeNamedInATypedCommand) {
  const auto mission = checked_with_societies(std::string(kParty) + kQuitAtOnce);
  text::Diagnostics sink;
  const auto typed = parse_immediate("UNIT <more> p AND UNIT more START 10 10 2 0", *mission, sink);
  ASSERT_TRUE(typed) << text::render(sink);
  EXPECT_EQ(robots_in(*typed->edited, typed->edited->units.back()), "4 p#Scout, 5 p#Scout, 6 p#Carrier");
}

}  // namespace
}  // namespace mlab::mdl
