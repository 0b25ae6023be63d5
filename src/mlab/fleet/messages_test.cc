#include "mlab/fleet/messages.h"

#include <algorithm>
#include <limits>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/base/hash.h"
#include "mlab/fleet/fleet.h"
#include "mlab/schema/requests.h"

namespace mlab::fleet {
namespace {

using base::hash_text;
using percept::Audience;
using percept::Request;
using schema::claim;
using schema::notification;

// Robots 1 and 2 are team 0, robots 3 and 4 are team 1.
struct TestMessages {
  Messages messages;
  std::vector<FleetRobot> robots;

  TestMessages() {
    for (std::uint32_t i = 0; i < 4; ++i) {
      robots.emplace_back();
      robots.back().id = {i + 1};
      robots.back().team = i / 2;
    }
  }
  TestMessages& ask(std::uint32_t robot, const Request& request) {
    EXPECT_TRUE(robots[robot - 1].action.ask(request));
    return *this;
  }
  void resolve(double time = 0.0) {
    messages.resolve(robots, time);
    for (FleetRobot& robot : robots) robot.action = {};
  }
  // The ids of the robots that hear it.
  std::vector<int> hearers(std::string_view name) const {
    std::vector<int> out;
    for (const FleetRobot& robot : robots) {
      if (std::ranges::binary_search(robot.notifications, hash_text(name)))
        out.push_back(static_cast<int>(robot.id.value));
    }
    return out;
  }
  // Who holds the claim; 0: nobody.
  std::uint32_t holder(std::uint32_t team, std::uint32_t object) const {
    for (const percept::Claim& claim : messages.claims(team)) {
      if (claim.object.value == object) return claim.robot.value;
    }
    return 0;
  }
};

TEST(Messages, NotificationsReachTheirAudience) {
  TestMessages t;
  t.ask(1, notification("all", Audience::kAll));
  t.ask(1, notification("team", Audience::kTeam));
  t.ask(3, notification("self", Audience::kSelf));
  t.resolve();
  EXPECT_EQ(t.hearers("all"), (std::vector{1, 2, 3, 4}));
  EXPECT_EQ(t.hearers("team"), (std::vector{1, 2}));
  EXPECT_EQ(t.hearers("self"), (std::vector{3}));
}

TEST(Messages, ANotificationWaitsUntilItsRobotTakesIt) {
  TestMessages t;
  t.ask(4, notification("ready", Audience::kAll)).resolve();
  t.resolve();
  t.ask(1, schema::take_notification("ready")).resolve();
  EXPECT_EQ(t.hearers("ready"), (std::vector{2, 3, 4}));
}

TEST(Messages, WhatComesWhileTheOldOneIsTakenIsNews) {
  TestMessages t;
  t.ask(4, notification("ready", Audience::kAll)).resolve();
  t.ask(1, schema::take_notification("ready")).ask(2, notification("ready", Audience::kAll)).resolve();
  EXPECT_EQ(t.hearers("ready"), (std::vector{1, 2, 3, 4}));
}

TEST(Messages, WhatARobotTellsItselfIsNewsThoughItTakesTheOldOneAfterwards) {
  TestMessages t;
  t.ask(1, notification("ready", Audience::kSelf)).ask(1, schema::take_notification("ready")).resolve();
  EXPECT_EQ(t.hearers("ready"), (std::vector{1}));
}

TEST(Messages, InboxesAreSortedAndHoldEachNotificationOnce) {
  TestMessages t;
  for (const char* name : {"c", "a", "b", "a"}) t.ask(2, notification(name, Audience::kAll));
  t.resolve();
  EXPECT_EQ(t.robots[0].notifications.size(), 3U);
  EXPECT_TRUE(std::ranges::is_sorted(t.robots[0].notifications));
}

TEST(Messages, KeepTheLastPlaceOfEveryRobot) {
  TestMessages t;
  Request place;
  place.kind = Request::Kind::kSharePlace;
  place.place = {5, 6};
  t.ask(3, place).ask(1, place).resolve(1.0);
  place.object = {9};
  place.object_class = percept::ObjectClass::kFlag;
  place.place = {7, 8};
  t.ask(3, place).resolve(2.0);
  t.resolve(3.0);
  ASSERT_EQ(t.messages.places(t.robots[0]).size(), 2U);
  EXPECT_EQ(t.messages.places(t.robots[0])[0].from.value, 1U);
  EXPECT_EQ(t.messages.places(t.robots[0])[0].time, 1.0);
  EXPECT_EQ(t.messages.places(t.robots[0])[1].object.value, 9U);
  EXPECT_EQ(t.messages.places(t.robots[0])[1].object_class, percept::ObjectClass::kFlag);
  EXPECT_EQ(t.messages.places(t.robots[0])[1].place, (geom::Point{7, 8}));
  EXPECT_EQ(t.messages.places(t.robots[0])[1].time, 2.0);
}

Request asked_passage(geom::Point to, double cost) {
  Request out;
  out.kind = Request::Kind::kAskPassage;
  out.place = to;
  out.cost = cost;
  return out;
}

TEST(Messages, WhoAsksForPassageLosesNoPlaceThatItTold) {
  TestMessages t;
  Request place;
  place.kind = Request::Kind::kSharePlace;
  place.object = {9};
  place.place = {5, 6};
  t.ask(1, place).ask(3, asked_passage({3, 4}, 7.0)).ask(1, asked_passage({1, 2}, 3.0)).resolve(1.0);
  t.ask(1, asked_passage({7, 8}, 2.0)).resolve(2.0);
  t.ask(1, asked_passage({std::numeric_limits<double>::infinity(), 8}, 2.0)).resolve(3.0);
  ASSERT_EQ(t.messages.places(t.robots[1]).size(), 1U);
  EXPECT_EQ(t.messages.places(t.robots[1])[0].place, (geom::Point{5, 6}));
  EXPECT_EQ(t.messages.places(t.robots[1])[0].object.value, 9U);
  percept::Percepts percepts;
  t.messages.add_told(t.robots[1], percepts);
  EXPECT_EQ(percepts.shared_places.size(), 1U);
  const auto passages = percepts.asked_passages;
  ASSERT_EQ(passages.size(), 2U);
  EXPECT_EQ(passages[0].from.value, 1U);
  EXPECT_EQ(passages[0].to, (geom::Point{7, 8})) << "the last that is a place";
  EXPECT_EQ(passages[0].cost, 2.0);
  EXPECT_EQ(passages[0].time, 2.0);
  EXPECT_EQ(passages[1].from.value, 3U);
}

TEST(Messages, DropPlacesThatAreNoNumbers) {
  TestMessages t;
  Request place;
  place.kind = Request::Kind::kSharePlace;
  place.place.x = std::numeric_limits<double>::quiet_NaN();
  t.ask(1, place).resolve();
  EXPECT_TRUE(t.messages.places(t.robots[0]).empty());
}

TEST(Messages, AClaimGoesToTheRobotWithTheLeastCostOfEqualsToTheFirst) {
  TestMessages t;
  t.ask(1, claim({7}, 3.0)).ask(2, claim({7}, 2.0));
  t.ask(1, claim({8}, 2.0)).ask(2, claim({8}, 2.0));
  t.ask(1, claim({9}, std::numeric_limits<double>::quiet_NaN())).ask(2, claim({9}, 1e9));
  t.resolve();
  EXPECT_EQ(t.holder(0, 7), 2U);
  EXPECT_EQ(t.holder(0, 8), 1U);
  EXPECT_EQ(t.holder(0, 9), 2U) << "a cost that is no number is the highest";
}

TEST(Messages, WhoHoldsAClaimKeepsItAsLongAsItAsks) {
  TestMessages t;
  t.ask(2, claim({7}, 3.0)).resolve();
  t.ask(1, claim({7}, 1.0)).ask(2, claim({7}, 3.0)).resolve();
  EXPECT_EQ(t.holder(0, 7), 2U);
  t.ask(1, claim({7}, 1.0)).resolve();
  EXPECT_EQ(t.holder(0, 7), 1U);
  t.resolve();
  EXPECT_EQ(t.holder(0, 7), 0U);
}

TEST(Messages, TeamsClaimWithoutRegardToEachOther) {
  TestMessages t;
  t.ask(1, claim({7}, 3.0)).ask(4, claim({7}, 1.0)).ask(3, claim({6}, 1.0)).resolve();
  EXPECT_EQ(t.holder(0, 7), 1U);
  EXPECT_EQ(t.holder(1, 7), 4U);
  ASSERT_EQ(t.messages.claims(1).size(), 2U);
  EXPECT_EQ(t.messages.claims(1)[0].object.value, 6U);
  EXPECT_TRUE(t.messages.claims(2).empty());
}

TEST(Messages, NobodyClaimsNoObject) {
  TestMessages t;
  t.ask(1, claim({0}, 0.0)).resolve();
  EXPECT_TRUE(t.messages.claims(0).empty());
}

// Radios that link those of the same net, as a test says; what a robot of `lossy` tells is lost to those of
// `deaf`.
struct TestLinks final : binding::RadioLinks {
  std::vector<std::uint32_t> nets = {0, 0, 1, 1};
  std::vector<std::uint32_t> lossy;  // bodies
  std::vector<std::uint32_t> deaf;   // bodies

  std::uint32_t net_of(binding::BodyIndex body) const override { return nets[body.value]; }
  bool loses(binding::BodyIndex from) const override {
    return std::ranges::find(lossy, from.value) != lossy.end();
  }
  bool arrives(binding::BodyIndex from, binding::BodyIndex to) const override {
    return net_of(from) == net_of(to) && !(loses(from) && std::ranges::find(deaf, to.value) != deaf.end());
  }
};

// Robots 1 and 3 are team 0, robots 2 and 4 are team 1; 1 and 2 hear each other, and 3 and 4.
struct TestRadio : TestMessages {
  TestLinks links;

  TestRadio() {
    for (std::uint32_t i = 0; i < 4; ++i) {
      robots[i].team = i % 2;
      robots[i].body = {i};
    }
  }
  TestRadio& ask(std::uint32_t robot, const Request& request) {
    TestMessages::ask(robot, request);
    return *this;
  }
  void hear(double time = 0.0) {
    messages.resolve(robots, time, [this] { return &links; });
    for (FleetRobot& robot : robots) robot.action = {};
  }
  std::vector<geom::Point> places_of(std::uint32_t robot) const {
    std::vector<geom::Point> out;
    for (const percept::SharedPlace& one : messages.places(robots[robot - 1])) out.push_back(one.place);
    return out;
  }
};

Request at_place(geom::Point place) {
  Request out;
  out.kind = Request::Kind::kSharePlace;
  out.place = place;
  return out;
}

TEST(Radio, NotificationsComeToThoseWhoAreLinkedAndToTheTellerHimself) {
  TestRadio t;
  t.ask(1, notification("all", Audience::kAll)).ask(4, notification("team", Audience::kTeam)).hear();
  EXPECT_EQ(t.hearers("all"), (std::vector<int>{1, 2}));
  EXPECT_EQ(t.hearers("team"), (std::vector<int>{4}));
  t.links.nets = {0, 0, 0, 0};
  t.ask(1, notification("other", Audience::kAll)).hear();
  EXPECT_EQ(t.hearers("all"), (std::vector<int>{1, 2})) << "what was missed is not told again";
  EXPECT_EQ(t.hearers("other"), (std::vector<int>{1, 2, 3, 4}));
  t.ask(4, notification("team", Audience::kTeam)).hear();
  EXPECT_EQ(t.hearers("team"), (std::vector<int>{2, 4}));
}

TEST(Radio, WhatIsLostOnItsWayIsNotHeard) {
  TestRadio t;
  t.links.lossy = {0};
  t.links.deaf = {0, 1};
  t.ask(1, notification("all", Audience::kAll)).ask(1, at_place({5, 6})).hear();
  EXPECT_EQ(t.hearers("all"), (std::vector<int>{1})) << "who tells it knows it";
  EXPECT_EQ(t.places_of(1), (std::vector<geom::Point>{{5, 6}}));
  EXPECT_TRUE(t.places_of(2).empty());
  t.ask(2, notification("back", Audience::kAll)).hear();
  EXPECT_EQ(t.hearers("back"), (std::vector<int>{1, 2})) << "of those who lose nothing all arrives";
}

TEST(Radio, PlacesAreKnownAsTheyWereHeardLast) {
  TestRadio t;
  t.ask(1, at_place({5, 6})).hear(1.0);
  t.links.nets = {0, 1, 1, 1};
  t.ask(1, at_place({7, 8})).hear(2.0);
  EXPECT_EQ(t.places_of(2), (std::vector<geom::Point>{{5, 6}}));
  EXPECT_EQ(t.places_of(1), (std::vector<geom::Point>{{7, 8}}));
  EXPECT_TRUE(t.places_of(3).empty());
}

TEST(Radio, PassagesAreHeardByWhoIsLinkedBesidePlaces) {
  TestRadio t;
  t.ask(1, at_place({5, 6})).ask(1, asked_passage({7, 8}, 2.0)).hear(1.0);
  EXPECT_EQ(t.places_of(2), (std::vector<geom::Point>{{5, 6}}));
  ASSERT_EQ(t.messages.passages(t.robots[1]).size(), 1U);
  EXPECT_EQ(t.messages.passages(t.robots[1])[0].to, (geom::Point{7, 8}));
  EXPECT_TRUE(t.messages.passages(t.robots[2]).empty());
  t.ask(4, asked_passage({1, 2}, 3.0)).resolve(2.0);
  EXPECT_EQ(t.messages.passages(t.robots[2]).size(), 2U) << "once all hear all, they know all";
}

TEST(Radio, WhatWasKnownBeforeRadiosHadARangeStaysKnown) {
  TestRadio t;
  t.ask(1, at_place({5, 6})).resolve(1.0);
  t.ask(3, at_place({1, 2})).hear(2.0);
  EXPECT_EQ(t.places_of(1), (std::vector<geom::Point>{{5, 6}}));
  EXPECT_EQ(t.places_of(4), (std::vector<geom::Point>{{5, 6}, {1, 2}}));
  t.ask(1, at_place({7, 8})).resolve(3.0);
  EXPECT_EQ(t.places_of(2), (std::vector<geom::Point>{{7, 8}, {1, 2}})) << "once all hear all, they know all";
}

TEST(Radio, WhoHasNoBodyHearsNobody) {
  TestRadio t;
  t.robots[1].body = binding::kNoBody;
  t.ask(1, notification("all", Audience::kAll)).ask(1, at_place({5, 6})).hear();
  EXPECT_EQ(t.hearers("all"), (std::vector<int>{1}));
  EXPECT_TRUE(t.places_of(2).empty());
  t.ask(2, notification("gone", Audience::kAll)).ask(2, at_place({1, 2})).hear();
  EXPECT_TRUE(t.hearers("gone").empty()) << "nor does anybody hear him";
  EXPECT_EQ(t.places_of(1), (std::vector<geom::Point>{{5, 6}}));
}

TEST(Radio, OfManyTellersTheOldestIsForgotten) {
  TestRadio t;
  t.links.nets.assign(400, 0);
  for (std::uint32_t i = 4; i < 400; ++i) {
    t.robots.emplace_back();
    t.robots.back().id = {i + 1};
    t.robots.back().body = {i};
  }
  for (std::uint32_t robot = 400; robot > 100; --robot)
    t.ask(robot, at_place({1.0 * robot, 0})).hear(500.0 - robot);
  const std::vector<geom::Point> known = t.places_of(1);
  ASSERT_EQ(known.size(), 256U);
  EXPECT_EQ(known.front().x, 101.0);
  EXPECT_EQ(known.back().x, 356.0);
}

}  // namespace
}  // namespace mlab::fleet
