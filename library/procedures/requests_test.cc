#include <algorithm>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "library_probe.h"
#include "mlab/base/hash.h"

namespace mlab::library_test {
namespace {

using percept::ObjectReading;
using Kind = percept::Request::Kind;

TEST(PickUp, AsksForTheObjectWhileItsHandsAreFree) {
  flow::BehaviorProbe p = probe("PickUp");
  p.set("object", ObjectReading{.id = {7}, .center = {0.5, 0.0}}).set("reach", 2.0).step();
  ASSERT_EQ(p.action.request_count, 1);
  EXPECT_EQ(p.action.requests[0].kind, Kind::kPickUp);
  EXPECT_EQ(p.action.requests[0].object.value, 7U);
  EXPECT_DOUBLE_EQ(p.action.requests[0].reach, 2.0);
  p.action = {};
  p.percepts.carried = {7};
  p.step();
  EXPECT_EQ(p.action.request_count, 0);
  EXPECT_EQ(p.output<geom::Vector>(), geom::Vector{});
}

TEST(PickUp, AsksForNothingWhereThereIsNoObject) {
  flow::BehaviorProbe p = probe("PICKUP_OBJECT");
  p.set("object", ObjectReading{}).step();
  EXPECT_EQ(p.action.request_count, 0);
}

TEST(DropInBasket, AsksOnlyWhenItCarriesSomethingAndSeesABasket) {
  flow::BehaviorProbe p = probe("DropInBasket");
  p.set("basket", ObjectReading{.id = {9}, .center = {0.1, 0.0}}).step();
  EXPECT_EQ(p.action.request_count, 0);
  p.percepts.carried = {7};
  p.step();
  ASSERT_EQ(p.action.request_count, 1);
  EXPECT_EQ(p.action.requests[0].kind, Kind::kDropInBasket);
  EXPECT_EQ(p.action.requests[0].object.value, 9U);
}

TEST(Drop, AsksOnlyWhenItCarriesSomething) {
  flow::BehaviorProbe p = probe("Drop");
  p.step();
  EXPECT_EQ(p.action.request_count, 0);
  p.percepts.carried = {7};
  p.step();
  ASSERT_EQ(p.action.request_count, 1);
  EXPECT_EQ(p.action.requests[0].kind, Kind::kDrop);
}

TEST(Notify, TellsOnceEachTimeItStarts) {
  flow::BehaviorProbe p = probe("NOTIFY_ROBOTS");
  p.set_text("message", "Enemy found.");
  p.step();
  ASSERT_EQ(p.action.request_count, 1);
  EXPECT_EQ(p.action.requests[0].kind, Kind::kNotify);
  EXPECT_EQ(p.action.requests[0].notification, base::hash_text("Enemy found."));
  p.step();
  EXPECT_EQ(p.action.request_count, 0);
  p.skip();
  p.step();
  EXPECT_EQ(p.action.request_count, 1);
}

TEST(Notify, ReachesAllRobotsAndNotifySelfOnlyThisOne) {
  for (const auto& [name, to_self] : {std::pair("NOTIFY_ROBOTS", false), std::pair("NOTIFY", true)}) {
    flow::BehaviorProbe p = probe(name);
    p.set_text("message", "Enemy found.");
    p.step();
    ASSERT_EQ(p.action.request_count, 1);
    EXPECT_EQ(p.action.requests[0].to_self, to_self);
    EXPECT_EQ(p.action.requests[0].notification, base::hash_text("Enemy found."));
    p.step();
    EXPECT_EQ(p.action.request_count, 0);
  }
}

TEST(NotifiedOnce, HearsItsOwnMessageOnly) {
  std::vector<std::uint64_t> arrived = {base::hash_text("a"), base::hash_text("b"), base::hash_text("c")};
  std::ranges::sort(arrived);
  flow::BehaviorProbe p = probe("NotifiedOnce");
  p.percepts.notifications = arrived;
  p.set_text("message", "b").step();
  EXPECT_TRUE(p.output<bool>());
  p.set_text("message", "d").step();
  EXPECT_FALSE(p.output<bool>());
  p.percepts.notifications = {};
  p.set_text("message", "b").step();
  EXPECT_FALSE(p.output<bool>());
}

TEST(AskToProceed, AsksOnceEachTimeItStarts) {
  flow::BehaviorProbe p = probe("WAIT_FOR_PROCEED");
  p.step();
  ASSERT_EQ(p.action.request_count, 1);
  EXPECT_EQ(p.action.requests[0].kind, Kind::kProceed);
  p.step();
  EXPECT_EQ(p.action.request_count, 0);
}

}  // namespace
}  // namespace mlab::library_test
