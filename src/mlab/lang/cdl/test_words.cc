#include "mlab/lang/cdl/test_words.h"

#include <algorithm>
#include <iterator>

#include "mlab/base/table.h"

namespace mlab::cdl {
namespace {

constexpr double kMostMetres = 1e6;
constexpr double kMostIds = 1e6;

constexpr TestInput kSelf[] = {{"at", "Point", "{0, 0}", "where the robot is"},
                               {"heading", "angle", "0", "where it looks, counter-clockwise from east"}};
constexpr TestInput kObstacle[] = {
    {"at", "Point", "", "where its middle is"},
    {"radius", "length", "0.2", "from its middle to its edge", 0.0, kMostMetres}};
constexpr TestInput kRobot[] = {
    {"at", "Point", "", "where it is"},
    {"heading", "angle", "0", "where it looks, counter-clockwise from east"},
    {"radius", "length", "0.2", "of its body", 0.0, kMostMetres},
    {"mate", "flag", "false", "whether it belongs to the same unit"},
    {"class", "object_class", "FriendlyRobot", "what its colour tells"},
    {"id", "count", "0", "its number; 0: the next one, from 2 on", 0.0, kMostIds}};
constexpr TestInput kObject[] = {
    {"class", "object_class", "", "what its colour tells"},
    {"at", "Point", "", "where it is"},
    {"style", "text", "movable", "`movable`, `fixed` or `container`"},
    {"radius", "length", "0.2", "from its middle to its edge", 0.0, kMostMetres},
    {"id", "count", "0", "its number; 0: the next one, from 1 on", 0.0, kMostIds}};
constexpr TestInput kCarrying[] = {
    {"class", "object_class", "", "of what it carries"},
    {"id", "count", "1000000", "the number of what it carries", 1.0, kMostIds}};
constexpr TestInput kOrder[] = {{"task", "Task", "", "what the mission wants"},
                                {"goal", "Point", "{0, 0}", "where to"},
                                {"formation", "Formation", "None", "in which formation the unit goes"},
                                {"heading", "angle", "", "of the formation; left out: the order fixes none"},
                                {"speed", "speed", "0", "of the unit; 0: the robot's own", 0.0, 1e4},
                                {"halted", "flag", "false", "hold where you are"}};
constexpr TestInput kWaypoint[] = {{"at", "Point", "", "the next point of the order's route"}};
constexpr TestInput kUnit[] = {
    {"size", "count", "1", "how many robots it has", 1.0, 1e4},
    {"rank", "count", "0", "of this robot in it; 0: it leads", 0.0, 1e4},
    {"center", "Point", "", "where its middle is; left out: where the robot is"},
    {"leader", "Point", "", "where its leader is; left out: where the robot is"},
    {"neighbor", "Point", "", "where the robot one rank before is; left out: where the robot is"},
    {"heading", "angle", "0", "in which direction its formation looked last"}};
constexpr TestInput kStick[] = {
    {"x", "number", "0", "to the right", -1.0, 1.0},
    {"y", "number", "0", "up: ahead, or north", -1.0, 1.0},
    {"magnitude", "gain", "1", "how far it is pushed; 0: nobody steers", 0.0, 100.0},
    {"ahead", "flag", "false", "up is ahead of the robot; else north"},
    {"complete", "flag", "false", "the operator has ended it"}};
constexpr TestInput kMessage[] = {{"name", "text", "", "of the notification that has come"}};
constexpr TestInput kCamera[] = {
    {"pan", "angle", "0", "where it looks, counter-clockwise from ahead"},
    {"field_of_view", "angle", "6.283185307179586", "how much it sees", 0.0, 6.2832}};
constexpr TestInput kBeam[] = {
    {"angle", "angle", "", "of the beam, counter-clockwise from ahead"},
    {"distance", "length", "", "from the body to what was hit, or how far it sees", 0.0, kMostMetres},
    {"hit", "flag", "true", "whether it hit anything"}};
constexpr TestInput kSharedPlace[] = {
    {"class", "object_class", "", "of what is there"},
    {"at", "Point", "", "where"},
    {"from", "count", "2", "the number of the robot that told it", 0.0, kMostIds},
    {"object", "count", "0", "the number of what is there; 0: just a place", 0.0, kMostIds}};
constexpr TestInput kClaim[] = {{"object", "count", "", "the number of what is claimed", 1.0, kMostIds},
                                {"robot", "count", "2", "the number of who claims it", 0.0, kMostIds}};
constexpr TestInput kDoor[] = {{"from", "Point", "", "one post"},
                               {"to", "Point", "", "the other post"},
                               {"marked", "flag", "false", "whether a robot has marked it"}};
constexpr TestInput kHallway[] = {{"from", "Point", "", "where its middle line begins"},
                                  {"to", "Point", "", "where it ends"},
                                  {"width", "length", "2", "from wall to wall", 0.0, kMostMetres}};
constexpr TestInput kPlace[] = {{"name", "text", "", "as `place(\"Gate\")` says it"},
                                {"at", "Point", "", "where it lies"}};

constexpr std::array kPercepts = {
    TestPerceptInfo{TestPercept::kSelf, "self", false, kSelf, "where the robot is"},
    TestPerceptInfo{TestPercept::kObstacle, "obstacle", true, kObstacle, "something solid"},
    TestPerceptInfo{TestPercept::kRobot, "robot", true, kRobot, "another robot"},
    TestPerceptInfo{TestPercept::kObject, "object", true, kObject, "an object that is told by its colour"},
    TestPerceptInfo{TestPercept::kCarrying, "carrying", false, kCarrying, "what the robot carries"},
    TestPerceptInfo{TestPercept::kOrder, "order", false, kOrder, "the order in force"},
    TestPerceptInfo{TestPercept::kWaypoint, "waypoint", true, kWaypoint, "a point of the order's route"},
    TestPerceptInfo{TestPercept::kUnit, "unit", false, kUnit, "the robot's unit"},
    TestPerceptInfo{TestPercept::kStick, "stick", false, kStick, "the operator's stick"},
    TestPerceptInfo{TestPercept::kMessage, "message", true, kMessage, "a notification that has come"},
    TestPerceptInfo{TestPercept::kCamera, "camera", false, kCamera, "where the camera looks"},
    TestPerceptInfo{TestPercept::kBeam, "beam", true, kBeam, "a beam of the ring of range sensors"},
    TestPerceptInfo{TestPercept::kSharedPlace, "shared_place", true, kSharedPlace,
                    "a place that another robot told"},
    TestPerceptInfo{TestPercept::kClaim, "claim", true, kClaim, "an object that a robot of the team claims"},
    TestPerceptInfo{TestPercept::kDoor, "door", true, kDoor, "a door of the building"},
    TestPerceptInfo{TestPercept::kHallway, "hallway", true, kHallway, "a hallway of the building"},
    TestPerceptInfo{TestPercept::kPlace, "place", true, kPlace, "where a named place lies"},
};
static_assert(base::has_a_row_for_each<kPercepts, &TestPerceptInfo::percept>());

constexpr std::array kObjectStyles = {TestObjectStyle{"fixed", percept::ObjectStyle::kFixed},
                                      TestObjectStyle{"movable", percept::ObjectStyle::kMovable},
                                      TestObjectStyle{"container", percept::ObjectStyle::kContainer}};
static_assert(base::has_a_row_for_each<kObjectStyles, &TestObjectStyle::style>());

using Request = percept::Request::Kind;
constexpr TestAction kActions[] = {
    {"PickUp", Request::kPickUp, "picks something up"},
    {"Drop", Request::kDrop, "puts down what it carries"},
    {"DropInBasket", Request::kDropInBasket, "puts what it carries into a basket"},
    {"Notify", Request::kNotify, "tells others, or itself, a notification"},
    {"AskToProceed", Request::kProceed, "asks the operator whether to go on"},
    {"TakeNotification", Request::kTakeNotification, "has heard a notification"},
    {"SharePlace", Request::kSharePlace, "tells the others a place"},
    {"Claim", Request::kClaim, "claims an object for itself"},
    {"MarkObject", Request::kMarkObject, "marks an object as something else"},
    {"MarkDoor", Request::kMarkDoor, "marks a door"},
    {"UnmarkDoor", Request::kUnmarkDoor, "takes the mark off a door"},
    {"ShowAs", Request::kShowAs, "shows itself in another colour"},
    {"Localize", Request::kLocalize, "says where it is"},
    {"Halt", Request::kHalt, "ends its program"},
    {"EndMission", Request::kEndMission, "ends the mission for all"},
    {"Alert", std::nullopt, "alerts the operator"},
    {"Done", std::nullopt, "says that its order is done"},
    {"Look", std::nullopt, "turns its camera"},
};

}  // namespace

std::span<const TestPerceptInfo> test_percepts() {
  return kPercepts;
}

const TestPerceptInfo* test_percept_named(std::string_view name) {
  const auto* const found = std::ranges::find(kPercepts, name, &TestPerceptInfo::name);
  return found == kPercepts.end() ? nullptr : found;
}

std::span<const TestObjectStyle> test_object_styles() {
  return kObjectStyles;
}

const TestObjectStyle* test_object_style_named(std::string_view name) {
  const auto* const found = std::ranges::find(kObjectStyles, name, &TestObjectStyle::name);
  return found == kObjectStyles.end() ? nullptr : found;
}

std::span<const TestAction> test_actions() {
  return kActions;
}

const TestAction* test_action_named(std::string_view name) {
  const auto* const found = std::ranges::find(kActions, name, &TestAction::name);
  return found == std::end(kActions) ? nullptr : found;
}

bool is_done(const TestAction& what, const percept::Action& action) {
  if (what.request) {
    const auto asked = std::span(action.requests).first(action.request_count);
    return std::ranges::find(asked, *what.request, &percept::Request::kind) != asked.end();
  }
  if (what.name == "Alert") return action.alert[0] != 0;
  if (what.name == "Done") return action.status.done;
  return action.looks;
}

}  // namespace mlab::cdl
