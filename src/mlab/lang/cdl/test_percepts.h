#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "mlab/base/table.h"
#include "mlab/flow/limit.h"

// What tests may tell a component that it senses: `given obstacle(at = {3, 0});`

namespace mlab::cdl {

/// What a test tells a component that it senses.
enum class TestPercept : std::uint8_t {
  kSelf,
  kObstacle,
  kRobot,
  kObject,
  kCarrying,
  kOrder,
  kWaypoint,
  kUnit,
  kStick,
  kMessage,
  kCamera,
  kBeam,
  kSharedPlace,
  kAskedPassage,
  kClaim,
  kDoor,
  kHallway,
  kPlace,
  kTouch,
  kRadio
};

struct TestInput {
  std::string_view name;
  std::string_view type;     ///< as parameters have it: `length`, `Point`
  std::string_view initial;  ///< a constant of the type, in SI units; empty: it has to be given
  std::string_view help;
  double min = -flow::kNoLimit;
  double max = flow::kNoLimit;
};

struct TestPerceptInfo {
  TestPercept percept;
  std::string_view name;  ///< `given NAME(...);`
  bool is_many;           ///< each `given` adds one; else it takes the place of the one before
  std::span<const TestInput> inputs;
  std::string_view help;
};

inline constexpr double kMostTestMetres = 1e6;
inline constexpr double kMostTestIds = 1e6;

inline constexpr TestInput kTestSelf[] = {
    {"at", "Point", "{0, 0}", "where the robot is"},
    {"heading", "angle", "0", "where it looks, counter-clockwise from east"}};
inline constexpr TestInput kTestObstacle[] = {
    {"at", "Point", "", "where its middle is"},
    {"radius", "length", "0.2", "from its middle to its edge", 0.0, kMostTestMetres}};
inline constexpr TestInput kTestRobot[] = {
    {"at", "Point", "", "where it is"},
    {"heading", "angle", "0", "where it looks, counter-clockwise from east"},
    {"radius", "length", "0.2", "of its body", 0.0, kMostTestMetres},
    {"mate", "flag", "false", "whether it belongs to the same unit"},
    {"class", "object_class", "FriendlyRobot", "what its colour tells"},
    {"id", "count", "0", "its number; 0: the next one, from 2 on", 0.0, kMostTestIds}};
inline constexpr TestInput kTestObject[] = {
    {"class", "object_class", "", "what its colour tells"},
    {"at", "Point", "", "where it is"},
    {"style", "text", "movable", "`movable`, `fixed` or `container`"},
    {"radius", "length", "0.2", "from its middle to its edge", 0.0, kMostTestMetres},
    {"id", "count", "0", "its number; 0: the next one, from 1 on", 0.0, kMostTestIds}};
inline constexpr TestInput kTestCarrying[] = {
    {"class", "object_class", "", "of what it carries"},
    {"id", "count", "1000000", "the number of what it carries", 1.0, kMostTestIds}};
inline constexpr TestInput kTestOrder[] = {
    {"task", "Task", "", "what the mission wants"},
    {"goal", "Point", "{0, 0}", "where to"},
    {"formation", "Formation", "None", "in which formation the unit goes"},
    {"heading", "angle", "", "of the formation; left out: the order fixes none"},
    {"speed", "speed", "0", "of the unit; 0: the robot's own", 0.0, 1e4},
    {"halted", "flag", "false", "hold where you are"}};
inline constexpr TestInput kTestWaypoint[] = {{"at", "Point", "", "the next point of the order's route"}};
inline constexpr TestInput kTestUnit[] = {
    {"size", "count", "1", "how many robots it has", 1.0, 1e4},
    {"rank", "count", "0", "of this robot in it; 0: it leads", 0.0, 1e4},
    {"center", "Point", "", "where its middle is; left out: where the robot is"},
    {"leader", "Point", "", "where its leader is; left out: where the robot is"},
    {"neighbor", "Point", "", "where the robot one rank before is; left out: where the robot is"},
    {"heading", "angle", "0", "in which direction its formation looked last"}};
inline constexpr TestInput kTestStick[] = {
    {"x", "number", "0", "to the right", -1.0, 1.0},
    {"y", "number", "0", "up: ahead, or north", -1.0, 1.0},
    {"magnitude", "gain", "1", "how far it is pushed; 0: nobody steers", 0.0, 100.0},
    {"ahead", "flag", "false", "up is ahead of the robot; else north"},
    {"complete", "flag", "false", "the operator has ended it"}};
inline constexpr TestInput kTestMessage[] = {{"name", "text", "", "of the notification that has come"}};
inline constexpr TestInput kTestCamera[] = {
    {"pan", "angle", "0", "where it looks, counter-clockwise from ahead"},
    {"field_of_view", "angle", "6.283185307179586", "how much it sees", 0.0, 6.2832}};
inline constexpr TestInput kTestBeam[] = {
    {"angle", "angle", "", "of the beam, counter-clockwise from ahead"},
    {"distance", "length", "", "from the body to what was hit, or how far it sees", 0.0, kMostTestMetres},
    {"hit", "flag", "true", "whether it hit anything"}};
inline constexpr TestInput kTestSharedPlace[] = {
    {"class", "object_class", "", "of what is there"},
    {"at", "Point", "", "where"},
    {"from", "count", "2", "the number of the robot that told it", 0.0, kMostTestIds},
    {"object", "count", "0", "the number of what is there; 0: just a place", 0.0, kMostTestIds}};
inline constexpr TestInput kTestAskedPassage[] = {
    {"to", "Point", "", "where it wants to go"},
    {"from", "count", "2", "the number of the robot that asks", 0.0, kMostTestIds},
    {"cost", "number", "0", "of those who meet, the one with the least goes first"}};
inline constexpr TestInput kTestClaim[] = {
    {"object", "count", "", "the number of what is claimed", 1.0, kMostTestIds},
    {"robot", "count", "2", "the number of who claims it", 0.0, kMostTestIds}};
inline constexpr TestInput kTestDoor[] = {{"from", "Point", "", "one post"},
                                          {"to", "Point", "", "the other post"},
                                          {"marked", "flag", "false", "whether a robot has marked it"}};
inline constexpr TestInput kTestHallway[] = {
    {"from", "Point", "", "where its middle line begins"},
    {"to", "Point", "", "where it ends"},
    {"width", "length", "2", "from wall to wall", 0.0, kMostTestMetres}};
inline constexpr TestInput kTestPlace[] = {{"name", "text", "", "as `place(\"Gate\")` says it"},
                                           {"at", "Point", "", "where it lies"}};

inline constexpr TestInput kTestTouch[] = {
    {"direction", "angle", "", "of what is touched, counter-clockwise from ahead"}};
inline constexpr TestInput kTestRadio[] = {
    {"at", "Point", "", "where who is heard says that he is"},
    {"strength", "double", "", "of his signal, in percent of what it is within 1 m", 0.0, 100.0},
    {"robot", "count", "2", "his number", 0.0, kMostTestIds},
    {"mate", "flag", "false", "whether he belongs to the same unit"}};

/// By their numbers.
inline constexpr std::array kTestPercepts = {
    TestPerceptInfo{TestPercept::kSelf, "self", false, kTestSelf,
                    "where the robot is; without it at [0 m, 0 m], looking east"},
    TestPerceptInfo{TestPercept::kObstacle, "obstacle", true, kTestObstacle, "something solid"},
    TestPerceptInfo{TestPercept::kRobot, "robot", true, kTestRobot, "another robot"},
    TestPerceptInfo{TestPercept::kObject, "object", true, kTestObject,
                    "an object that is told by its colour"},
    TestPerceptInfo{TestPercept::kCarrying, "carrying", false, kTestCarrying, "what the robot carries"},
    TestPerceptInfo{TestPercept::kOrder, "order", false, kTestOrder, "the order in force"},
    TestPerceptInfo{TestPercept::kWaypoint, "waypoint", true, kTestWaypoint, "a point of the order's route"},
    TestPerceptInfo{TestPercept::kUnit, "unit", false, kTestUnit, "the robot's unit"},
    TestPerceptInfo{TestPercept::kStick, "stick", false, kTestStick, "the operator's stick"},
    TestPerceptInfo{TestPercept::kMessage, "message", true, kTestMessage, "a notification that has come"},
    TestPerceptInfo{TestPercept::kCamera, "camera", false, kTestCamera,
                    "where the camera looks: objects are seen only in its field"},
    TestPerceptInfo{TestPercept::kBeam, "beam", true, kTestBeam, "a beam of the ring of range sensors"},
    TestPerceptInfo{TestPercept::kSharedPlace, "shared_place", true, kTestSharedPlace,
                    "a place that another robot told"},
    TestPerceptInfo{TestPercept::kAskedPassage, "asked_passage", true, kTestAskedPassage,
                    "that another robot asks to be let through"},
    TestPerceptInfo{TestPercept::kClaim, "claim", true, kTestClaim,
                    "an object that a robot of the team claims"},
    TestPerceptInfo{TestPercept::kDoor, "door", true, kTestDoor, "a door of the building"},
    TestPerceptInfo{TestPercept::kHallway, "hallway", true, kTestHallway, "a hallway of the building"},
    TestPerceptInfo{TestPercept::kPlace, "place", true, kTestPlace, "where a named place lies"},
    TestPerceptInfo{TestPercept::kTouch, "touch", false, kTestTouch, "what the body touches"},
    TestPerceptInfo{TestPercept::kRadio, "radio", true, kTestRadio, "another robot whose radio is heard"},
};
static_assert(base::has_a_row_for_each<kTestPercepts, &TestPerceptInfo::percept>());

}  // namespace mlab::cdl
