#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../testing/library_probe.h"
#include "mlab/base/hash.h"
#include "mlab/schema/requests.h"

namespace mlab::library_test {
namespace {

using percept::ObjectReading;
using Kind = percept::Request::Kind;

TEST(Alert, TellsTheOperatorOnceEachTimeItStarts) {
  flow::BehaviorProbe p = probe("ALERT");
  p.set_text("subject", "Biohazard").set_text("message", "in room 3").step();
  EXPECT_EQ(std::string(p.action.alert.data()), "Biohazard: in room 3");
  ASSERT_EQ(p.action.request_count, 1);
  EXPECT_EQ(p.action.requests[0].audience, percept::Audience::kSelf);
  p.action = {};
  p.step();
  EXPECT_EQ(p.action.alert[0], 0);
  p.skip();
  p.step();
  EXPECT_EQ(p.action.alert[0], 'B');
}

TEST(Alert, CutsWhatDoesNotFit) {
  percept::Action action;
  schema::alert(action, std::string(100, 'a'), std::string(100, 'b'));
  EXPECT_EQ(std::string(action.alert.data()), std::string(100, 'a') + ": " + std::string(25, 'b'));
}

TEST(AlertedOnce, HearsOfItAndTakesIt) {
  const std::vector<std::uint64_t> arrived = {base::hash_text("ALERTED")};
  flow::BehaviorProbe p = probe("ALERTED_ONCE");
  p.step();
  EXPECT_FALSE(p.output<bool>());
  p.percepts.notifications = arrived;
  p.step();
  EXPECT_TRUE(p.output<bool>());
  EXPECT_EQ(p.action.requests[0].kind, Kind::kTakeNotification);
}

TEST(LastKeyPress, KeepsTheKeyUntilItStartsAnew) {
  const std::vector<std::uint64_t> arrived = {base::hash_text("KEY s")};
  flow::BehaviorProbe p = probe("LAST_KEY_PRESS");
  p.step();
  EXPECT_EQ(p.output<int>(), -1);
  p.percepts.notifications = arrived;
  p.step();
  EXPECT_EQ(p.output<int>(), 's');
  EXPECT_EQ(p.action.requests[0].notification, base::hash_text("KEY s"));
  p.percepts.notifications = {};
  p.step();
  EXPECT_EQ(p.output<int>(), 's');
  p.skip();
  p.step();
  EXPECT_EQ(p.output<int>(), -1);
}

TEST(ProbeObject, FindsWhatCanBeCarriedDangerous) {
  const auto result = [](percept::ObjectStyle style, double away) {
    flow::BehaviorProbe p = probe("PROBE_OBJECT");
    p.set("object", ObjectReading{.id = {7}, .style = style, .center = {away, 0.0}}).step();
    return p.action.request_count == 1 ? p.action.requests[0].notification : 0;
  };
  EXPECT_EQ(result(percept::ObjectStyle::kMovable, 1.0), base::hash_text("KEY d"));
  EXPECT_EQ(result(percept::ObjectStyle::kMovable, 3.0), base::hash_text("KEY s"));
  EXPECT_EQ(result(percept::ObjectStyle::kFixed, 1.0), base::hash_text("KEY s"));
  flow::BehaviorProbe p = probe("ProbeObject");
  p.set("object", ObjectReading{}).step();
  EXPECT_EQ(p.action.request_count, 0);
}

TEST(MarkObject, AsksForTheNewClass) {
  flow::BehaviorProbe p = probe("MARK_OBJECT");
  ObjectReading seen;
  seen.id = {7};
  p.set("object", seen).set_text("classes", "Flag").step();
  ASSERT_EQ(p.action.request_count, 1);
  EXPECT_EQ(p.action.requests[0].kind, Kind::kMarkObject);
  EXPECT_EQ(p.action.requests[0].object_class, percept::ObjectClass::kFlag);
  p.action = {};
  p.set_text("classes", "0").step();
  EXPECT_EQ(p.action.request_count, 0) << "no class";
}

TEST(ChangeRobotColor, KnowsTheColoursOfClassesOnly) {
  flow::BehaviorProbe p = probe("CHANGE_ROBOT_COLOR");
  p.set_text("color", "red").step();
  ASSERT_EQ(p.action.request_count, 1);
  EXPECT_EQ(p.action.requests[0].object_class, percept::ObjectClass::kEnemyRobot);
  p.action = {};
  p.set_text("color", "mauve").step();
  EXPECT_EQ(p.action.request_count, 0);
}

TEST(Localize, SaysOnceWhereItIs) {
  flow::BehaviorProbe p = probe("SETXYTHETA");
  p.set("place", geom::Point{3, 4}).set("heading", 1.0).step();
  ASSERT_EQ(p.action.request_count, 1);
  EXPECT_EQ(p.action.requests[0].place, (geom::Point{3, 4}));
  EXPECT_DOUBLE_EQ(p.action.requests[0].heading, 1.0);
  p.action = {};
  p.step();
  EXPECT_EQ(p.action.request_count, 0);
}

TEST(Halt, AsksToEndTheProgramAndTerminateMissionToEndAll) {
  flow::BehaviorProbe halt = probe("HALT");
  halt.step();
  EXPECT_EQ(halt.action.requests[0].kind, Kind::kHalt);
  flow::BehaviorProbe end = probe("TerminateMission");
  end.step();
  EXPECT_EQ(end.action.requests[0].kind, Kind::kEndMission);
}

}  // namespace
}  // namespace mlab::library_test
