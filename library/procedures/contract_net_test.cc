#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "../testing/library_probe.h"
#include "mlab/base/hash.h"

namespace mlab::library_test {
namespace {

using base::hash_text;
using percept::Contract;
using percept::ContractState;
using percept::Request;
using percept::SharedPlace;
using Kind = percept::Request::Kind;

// Robot 2 stands at (10, 0) and looks north. Contracts stand as a fleet gives them, by task, then object.
struct Net {
  std::vector<Contract> contracts;
  std::vector<SharedPlace> places;

  Net& add(std::string_view task, std::uint32_t object, ContractState state, std::uint32_t contractor = 0,
           geom::Point place = {}, double time = 0.0) {
    contracts.push_back({hash_text(task), {object}, place, state, {1}, {contractor}, {}, time});
    return *this;
  }
  flow::BehaviorProbe probe_of(const char* name) const {
    flow::BehaviorProbe p = probe(name);
    p.percepts.id = {2};
    p.percepts.pose = {{10, 0}, 1.5707963267948966};
    p.percepts.contracts = contracts;
    p.percepts.shared_places = places;
    return p;
  }
};

bool is_true(const Net& net, const char* name, std::string_view task = "*") {
  flow::BehaviorProbe p = net.probe_of(name);
  p.set_text("task", task).step();
  return p.output<bool>();
}

TEST(AnnounceTask, OffersItOnceWhereTheRobotIs) {
  const Net net;
  flow::BehaviorProbe p = net.probe_of("AnnounceTask");
  p.set_text("task", "EODTask").set_text("number", "4").set("wait", 2.0).set("patience", 9.0).step();
  ASSERT_EQ(asked(p, Kind::kAnnounceTask).size(), 1U);
  const Request request = p.action.requests[0];
  EXPECT_EQ(request.notification, hash_text("EODTask"));
  EXPECT_EQ(request.object.value, 4U);
  EXPECT_EQ(request.place, (geom::Point{10, 0}));
  EXPECT_EQ(request.wait, 2.0);
  EXPECT_EQ(request.patience, 9.0);
  p.action = {};
  p.step();
  EXPECT_EQ(p.action.request_count, 0);
}

TEST(AnnounceTask, OffersItWhereTheRobotToldThatSomethingIs) {
  Net net;
  net.places = {{{1}, {}, {}, {1, 1}, 0.0}, {{2}, {}, {}, {7, 8}, 0.0}};
  flow::BehaviorProbe p = net.probe_of("AnnounceTask");
  p.set_text("task", "TrackTask").step();
  EXPECT_EQ(p.action.requests[0].place, (geom::Point{7, 8}));
}

TEST(AnnounceTaskAt, OffersItAnewWhenNobodyWantedItWhereItIsToBeRepeated) {
  for (const bool repeats : {false, true}) {
    Net net;
    net.add("Visit", 0, ContractState::kFailed);
    flow::BehaviorProbe p = net.probe_of("AnnounceTaskAt");
    p.set_text("task", "Visit").set("place", geom::Point{3, 4}).set("repeats", repeats).step();
    EXPECT_EQ(p.action.requests[0].place, (geom::Point{3, 4}));
    p.action = {};
    p.step();
    EXPECT_EQ(p.action.request_count, repeats ? 1 : 0);
  }
}

TEST(AnnounceObjectTask, OffersATaskForEachNewObject) {
  Net net;
  net.add("Fetch", 5, ContractState::kDone).add("Fetch", 6, ContractState::kFailed);
  for (const std::uint32_t object : {0U, 5U, 6U, 7U}) {
    flow::BehaviorProbe p = net.probe_of("AnnounceObjectTask");
    p.set_text("task", "Fetch")
        .set("object", percept::ObjectReading{.id = {object}, .center = {1, 0}})
        .step();
    EXPECT_EQ(p.action.request_count, object > 5U ? 1 : 0) << object;
    if (object < 7U) continue;
    EXPECT_EQ(p.action.requests[0].object.value, 7U);
    EXPECT_NEAR(p.action.requests[0].place.y, 1.0, 1e-9) << "ahead is north";
  }
}

TEST(BidOnTask, BidsForTheNearestWithItsDistance) {
  Net net;
  net.add("Visit", 0, ContractState::kOpen, 0, {10, 9}).add("Visit", 1, ContractState::kOpen, 0, {13, 4});
  net.add("Visit", 2, ContractState::kAwarded, 3, {10, 0});
  flow::BehaviorProbe p = net.probe_of("BidOnTask");
  p.step();
  ASSERT_EQ(p.action.request_count, 1);
  EXPECT_EQ(p.action.requests[0].kind, Kind::kBid);
  EXPECT_EQ(p.action.requests[0].object.value, 1U);
  EXPECT_DOUBLE_EQ(p.action.requests[0].cost, 5.0);
}

TEST(BidOnTask, BidsForAnotherWithWhatThatAddsToItsWay) {
  Net net;
  net.add("Visit", 0, ContractState::kStarted, 2, {10, 10}).add("Visit", 1, ContractState::kOpen, 0, {10, 4});
  net.add("Visit", 2, ContractState::kOpen, 0, {10, 12});
  flow::BehaviorProbe p = net.probe_of("BidOnTask");
  p.step();
  EXPECT_TRUE(asked(p, Kind::kBid).empty()) << "it has as many as it may";
  EXPECT_EQ(asked(p, Kind::kKeepTasks).size(), 1U);
  p.action = {};
  p.set_text("most", "2").step();
  ASSERT_EQ(asked(p, Kind::kBid).size(), 1U);
  EXPECT_EQ(asked(p, Kind::kBid)[0].object.value, 1U);
  EXPECT_DOUBLE_EQ(asked(p, Kind::kBid)[0].cost, 0.0) << "it lies on its way";
}

TEST(BidOnTask, LeavesWhatItGaveBackAndTasksOfOtherNames) {
  Net net;
  net.add("Other", 0, ContractState::kOpen).add("Visit", 0, ContractState::kOpen);
  net.contracts[1].reneged = {2};
  flow::BehaviorProbe p = net.probe_of("BidOnTask");
  p.set_text("task", "Visit").step();
  EXPECT_EQ(p.action.request_count, 0);
  p.set_text("task", "Other").step();
  EXPECT_EQ(asked(p, Kind::kBid).size(), 1U);
}

TEST(StartTask, BeginsWithTheNextOnItsWayAndKeepsAll) {
  Net net;
  net.add("Visit", 0, ContractState::kAwarded, 2, {10, 9}, 1.0)
      .add("Visit", 1, ContractState::kAwarded, 2, {10, 3}, 2.0);
  flow::BehaviorProbe p = net.probe_of("StartTask");
  p.step();
  ASSERT_EQ(asked(p, Kind::kStartTask).size(), 1U);
  EXPECT_EQ(asked(p, Kind::kStartTask)[0].object.value, 1U);
  EXPECT_EQ(asked(p, Kind::kKeepTasks).size(), 1U);
  flow::BehaviorProbe place = net.probe_of("TaskPlace");
  place.step();
  EXPECT_NEAR(place.output<geom::Vector>().x, 3.0, 1e-9);
}

TEST(FinishTask, TellsOnceThatTheNextIsDone) {
  Net net;
  net.add("Visit", 0, ContractState::kStarted, 2).add("Visit", 1, ContractState::kStarted, 2, {10, 3});
  flow::BehaviorProbe p = net.probe_of("FinishTask");
  p.step();
  ASSERT_EQ(asked(p, Kind::kFinishTask).size(), 1U);
  EXPECT_EQ(asked(p, Kind::kFinishTask)[0].object.value, 1U);
  p.action = {};
  p.step();
  EXPECT_TRUE(asked(p, Kind::kFinishTask).empty());
  EXPECT_EQ(asked(p, Kind::kKeepTasks).size(), 1U);
}

TEST(RenegeTask, GivesTheNextBackOnce) {
  Net net;
  net.add("Visit", 3, ContractState::kStarted, 2);
  flow::BehaviorProbe p = net.probe_of("RenegeTask");
  p.step();
  ASSERT_EQ(asked(p, Kind::kRenegeTask).size(), 1U);
  EXPECT_EQ(asked(p, Kind::kRenegeTask)[0].object.value, 3U);
  p.action = {};
  p.step();
  EXPECT_TRUE(asked(p, Kind::kRenegeTask).empty());
}

TEST(ReportResult, TellsThatTheNextIsDoneOrGivenBack) {
  Net net;
  net.add("EODTask", 0, ContractState::kStarted, 2);
  for (const bool reneged : {false, true}) {
    flow::BehaviorProbe p = net.probe_of("CNP_NOTIFY_TASK_COMPLETED");
    p.set("reneged", reneged).step();
    EXPECT_EQ(asked(p, reneged ? Kind::kRenegeTask : Kind::kFinishTask).size(), 1U);
    EXPECT_TRUE(asked(p, reneged ? Kind::kFinishTask : Kind::kRenegeTask).empty());
  }
}

TEST(TaskPlace, IsNowhereWithoutATask) {
  Net net;
  net.add("Visit", 0, ContractState::kDone, 2, {3, 3}).add("Visit", 1, ContractState::kAwarded, 3, {4, 4});
  flow::BehaviorProbe p = net.probe_of("TaskPlace");
  p.step();
  EXPECT_EQ(geom::length(p.output<geom::Vector>()), 0.0);
}

TEST(IsTaskOpen, IsSoForThoseThatMayBid) {
  Net net;
  EXPECT_FALSE(is_true(net, "IsTaskOpen"));
  net.add("Visit", 0, ContractState::kOpen);
  EXPECT_TRUE(is_true(net, "IsTaskOpen"));
  EXPECT_TRUE(is_true(net, "IsTaskOpen", "Visit"));
  EXPECT_FALSE(is_true(net, "IsTaskOpen", "Other"));
  net.contracts[0].reneged = {2};
  EXPECT_FALSE(is_true(net, "IsTaskOpen"));
}

TEST(IsTaskAwarded, IsSoWhileTheRobotHasItAndKeepsIt) {
  for (const ContractState state : {ContractState::kOpen, ContractState::kAwarded, ContractState::kStarted,
                                    ContractState::kDone, ContractState::kFailed}) {
    Net net;
    net.add("EODTask", 0, state, 2);
    const bool has = state == ContractState::kAwarded || state == ContractState::kStarted;
    flow::BehaviorProbe p = net.probe_of("IsTaskAwarded");
    p.step();
    EXPECT_EQ(p.output<bool>(), has);
    EXPECT_EQ(p.action.request_count, has ? 1 : 0);
    EXPECT_EQ(is_true(net, "IsTaskAwarded", "EODTask"), has);
    EXPECT_FALSE(is_true(net, "IsTaskAwarded", "TrackTask"));
    flow::BehaviorProbe lost = net.probe_of("IsTaskLost");
    lost.step();
    EXPECT_EQ(lost.output<bool>(), !has);
  }
}

TEST(IsAuctionEnded, IsSoWhenTheRobotHasATaskOrNoneIsOnOffer) {
  const auto ended = [](const Net& net) {
    flow::BehaviorProbe p = net.probe_of("IsAuctionEnded");
    p.step();
    return p.output<bool>();
  };
  Net net;
  EXPECT_TRUE(ended(net));
  net.add("Visit", 0, ContractState::kOpen);
  EXPECT_FALSE(ended(net));
  net.add("Visit", 1, ContractState::kAwarded, 2);
  EXPECT_TRUE(ended(net));
}

TEST(IsAuctionFailed, ConcernsWhoAnnouncedTheTask) {
  Net net;
  net.add("Visit", 0, ContractState::kFailed);
  EXPECT_FALSE(is_true(net, "IsAuctionFailed")) << "robot 1 announced it";
  net.contracts[0].manager = {2};
  EXPECT_TRUE(is_true(net, "IsAuctionFailed"));
  EXPECT_TRUE(is_true(net, "IsAuctionFailed", "Visit"));
  EXPECT_FALSE(is_true(net, "IsAuctionFailed", "Other"));
}

TEST(IsTaskDone, WantsAllOfTheName) {
  Net net;
  EXPECT_FALSE(is_true(net, "IsTaskDone", "Visit"));
  net.add("Visit", 0, ContractState::kDone, 3);
  EXPECT_TRUE(is_true(net, "IsTaskDone", "Visit"));
  net.add("Visit", 1, ContractState::kStarted, 3);
  EXPECT_FALSE(is_true(net, "IsTaskDone", "Visit"));
}

TEST(IsTaskDone, OfItsOwnIsSoWhenTheRobotHasNoneLeft) {
  const auto done = [](const Net& net) {
    flow::BehaviorProbe p = net.probe_of("IsTaskDone");
    p.set("by_self", true).step();
    return p.output<bool>();
  };
  Net net;
  net.add("Visit", 0, ContractState::kDone, 3);
  EXPECT_FALSE(done(net)) << "another robot did it";
  net.add("Visit", 1, ContractState::kDone, 2);
  EXPECT_TRUE(done(net));
  net.add("Visit", 2, ContractState::kAwarded, 2);
  EXPECT_FALSE(done(net));
}

TEST(IsTaskReneged, IsSoUntilSomebodyElseHasIt) {
  Net net;
  net.add("Visit", 0, ContractState::kOpen);
  EXPECT_FALSE(is_true(net, "IsTaskReneged", "Visit"));
  net.contracts[0].reneged = {2};
  EXPECT_TRUE(is_true(net, "IsTaskReneged", "Visit"));
  EXPECT_FALSE(is_true(net, "IsTaskReneged", "Other"));
  net.contracts[0].state = ContractState::kAwarded;
  net.contracts[0].contractor = {3};
  EXPECT_FALSE(is_true(net, "IsTaskReneged", "Visit"));
  flow::BehaviorProbe own = net.probe_of("IsTaskReneged");
  own.set("by_self", true).step();
  EXPECT_TRUE(own.output<bool>());
}

}  // namespace
}  // namespace mlab::library_test
