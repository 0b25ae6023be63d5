#include <gtest/gtest.h>

#include "../testing/library_probe.h"

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
