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
  ASSERT_EQ(t.messages.places().size(), 2U);
  EXPECT_EQ(t.messages.places()[0].from.value, 1U);
  EXPECT_EQ(t.messages.places()[0].time, 1.0);
  EXPECT_EQ(t.messages.places()[1].object.value, 9U);
  EXPECT_EQ(t.messages.places()[1].object_class, percept::ObjectClass::kFlag);
  EXPECT_EQ(t.messages.places()[1].place, (geom::Point{7, 8}));
  EXPECT_EQ(t.messages.places()[1].time, 2.0);
}

TEST(Messages, DropPlacesThatAreNoNumbers) {
  TestMessages t;
  Request place;
  place.kind = Request::Kind::kSharePlace;
  place.place.x = std::numeric_limits<double>::quiet_NaN();
  t.ask(1, place).resolve();
  EXPECT_TRUE(t.messages.places().empty());
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

}  // namespace
}  // namespace mlab::fleet
