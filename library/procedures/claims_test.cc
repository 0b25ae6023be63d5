#include <vector>

#include <gtest/gtest.h>

#include "../testing/library_probe.h"

namespace mlab::library_test {
namespace {

using percept::Claim;
using percept::ObjectReading;
using Kind = percept::Request::Kind;

// Robot 2 sees three objects; 11 is claimed by robot 1, 12 by itself.
struct ThreeObjects {
  std::vector<ObjectReading> objects = {{.id = {10}, .center = {3, 0}, .radius = 0.5},
                                        {.id = {11}, .center = {4, 0}},
                                        {.id = {12}, .center = {5, 0}}};
  std::vector<Claim> claims = {{{11}, {1}}, {{12}, {2}}};

  flow::BehaviorProbe probe_of(const char* name) const {
    flow::BehaviorProbe p = probe(name);
    p.percepts.id = {2};
    p.percepts.objects = objects;
    p.percepts.claims = claims;
    return p;
  }
};

std::vector<int> indices(const flow::Objects& list) {
  return {list.indices.begin(), list.indices.begin() + list.count};
}

TEST(ClaimObject, AsksForItInEveryCycleByItsDistance) {
  const ThreeObjects t;
  flow::BehaviorProbe p = t.probe_of("ClaimObject");
  p.set("object", t.objects[0]);
  for (int cycle = 0; cycle < 2; ++cycle) {
    p.action = {};
    p.step();
    EXPECT_EQ(p.output<ObjectReading>().id.value, 10U);
    ASSERT_EQ(p.action.request_count, 1);
    EXPECT_EQ(p.action.requests[0].kind, Kind::kClaim);
    EXPECT_EQ(p.action.requests[0].object.value, 10U);
    EXPECT_DOUBLE_EQ(p.action.requests[0].cost, 2.5);
  }
}

TEST(ClaimObject, KeepsItsOwnAndLeavesThoseOfOthers) {
  const ThreeObjects t;
  flow::BehaviorProbe p = t.probe_of("ClaimObject");
  p.set("object", t.objects[2]).step();
  EXPECT_EQ(p.output<ObjectReading>().id.value, 12U);
  EXPECT_EQ(p.action.request_count, 1);
  p.action = {};
  p.set("object", t.objects[1]).step();
  EXPECT_EQ(p.output<ObjectReading>().id.value, 0U);
  EXPECT_EQ(p.action.request_count, 0);
}

TEST(ClaimObject, ClaimsNothingWhereThereIsNoObject) {
  flow::BehaviorProbe p = probe("ClaimObject");
  p.set("object", ObjectReading{}).step();
  EXPECT_EQ(p.output<ObjectReading>().id.value, 0U);
  EXPECT_EQ(p.action.request_count, 0);
}

TEST(UnclaimedObjects, LeavesOutWhatOthersHaveClaimed) {
  const ThreeObjects t;
  flow::BehaviorProbe p = t.probe_of("UnclaimedObjects");
  p.set("objects", all<flow::Objects>(3)).step();
  EXPECT_EQ(indices(p.output<flow::Objects>()), (std::vector{0, 2}));
}

TEST(ClaimedObjects, KeepsThoseOfOthersOrItsOwn) {
  const ThreeObjects t;
  flow::BehaviorProbe p = t.probe_of("ClaimedObjects");
  p.set("objects", all<flow::Objects>(3)).step();
  EXPECT_EQ(indices(p.output<flow::Objects>()), (std::vector{1}));
  p.set("by_self", true).step();
  EXPECT_EQ(indices(p.output<flow::Objects>()), (std::vector{2}));
}

}  // namespace
}  // namespace mlab::library_test
