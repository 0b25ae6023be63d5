#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "../testing/library_probe.h"

namespace mlab::library_test {
namespace {

using geom::Vector;
using percept::ObjectClass;
using percept::ObjectReading;
using percept::SharedPlace;
using Kind = percept::Request::Kind;

TEST(ShareObjectPlace, TellsWhereInTheWorldTheObjectIs) {
  flow::BehaviorProbe p = probe("ShareObjectPlace");
  p.percepts.pose = {{10, 20}, std::numbers::pi / 2};
  p.set("object", ObjectReading{.id = {7}, .object_class = ObjectClass::kFlag, .center = {3, 1}}).step();
  ASSERT_EQ(p.action.request_count, 1);
  EXPECT_EQ(p.action.requests[0].kind, Kind::kSharePlace);
  EXPECT_EQ(p.action.requests[0].object.value, 7U);
  EXPECT_EQ(p.action.requests[0].object_class, ObjectClass::kFlag);
  EXPECT_NEAR(p.action.requests[0].place.x, 9.0, 1e-12);
  EXPECT_NEAR(p.action.requests[0].place.y, 23.0, 1e-12);
}

TEST(ShareObjectPlace, TellsNothingWithoutAnObject) {
  flow::BehaviorProbe p = probe("NOTIFY_ROBOTS_OBJECT_LOCATION");
  p.set("object", ObjectReading{}).step();
  EXPECT_EQ(p.action.request_count, 0);
}

TEST(SharePlace, TellsOnceEachTimeItStarts) {
  flow::BehaviorProbe p = probe("NOTIFY_GOALS");
  p.set("place", geom::Point{3, 4}).step();
  ASSERT_EQ(p.action.request_count, 1);
  EXPECT_EQ(p.action.requests[0].place, (geom::Point{3, 4}));
  EXPECT_EQ(p.action.requests[0].object.value, 0U);
  p.action = {};
  p.step();
  EXPECT_EQ(p.action.request_count, 0);
}

// Robot 2 looks north from (10, 20), 100 s after the start.
struct Told {
  std::vector<SharedPlace> places;
  Vector output(const char* classes = "AnyObject", double max_age = 1e9) const {
    flow::BehaviorProbe p = probe("NotifiedPlace");
    p.percepts.id = {2};
    p.percepts.time = 100;
    p.percepts.pose = {{10, 20}, std::numbers::pi / 2};
    p.percepts.shared_places = places;
    p.set_text("classes", classes).set("max_age", max_age).step();
    flow::BehaviorProbe is = probe("IsPlaceNotified");
    is.percepts = p.percepts;
    is.set_text("classes", classes).set("max_age", max_age).step();
    EXPECT_EQ(is.output<bool>(), p.output<Vector>() != Vector{});
    return p.output<Vector>();
  }
};

TEST(NotifiedPlace, IsTheNewestOfAnotherRobotSeenFromThisOne) {
  Told t;
  EXPECT_EQ(t.output(), Vector{});
  constexpr ObjectClass kAny = ObjectClass::kUnknown;
  t.places = {{{1}, {}, kAny, {10, 25}, 50},
              {{2}, {}, kAny, {10, 21}, 70},
              {{3}, {}, kAny, {8, 20}, 60},
              {{4}, {}, kAny, {0, 0}, 60}};
  EXPECT_NEAR(t.output().y, 2.0, 1e-12) << "of robot 3: its own does not count, and 4 told it no later";
  EXPECT_NEAR(t.output().x, 0.0, 1e-12);
}

TEST(NotifiedPlace, IsOfTheClassesAndAgeInQuestion) {
  Told t;
  t.places = {{{1}, {}, ObjectClass::kFlag, {10, 25}, 50}, {{3}, {}, ObjectClass::kMine, {10, 22}, 60}};
  EXPECT_NEAR(t.output("Flag").x, 5.0, 1e-12);
  EXPECT_NEAR(t.output("Flag|Mine").x, 2.0, 1e-12);
  EXPECT_EQ(t.output("Basket"), Vector{});
  EXPECT_EQ(t.output("Flag", 49.0), Vector{});
  EXPECT_NEAR(t.output("Flag", 51.0).x, 5.0, 1e-12);
}

}  // namespace
}  // namespace mlab::library_test
