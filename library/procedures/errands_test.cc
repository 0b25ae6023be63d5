#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "../testing/library_probe.h"
#include "mlab/schema/errands.h"
#include "mlab/schema/tour.h"
#include "mlab/ways/planned_way.h"

namespace mlab::library_test {
namespace {

using percept::Contract;
using percept::ContractState;
using percept::Request;
using percept::SharedPlace;
using percept::Task;
using Kind = percept::Request::Kind;

// Robot 2 of two stands at (10, 0), under the third order of the mission.
struct Unit {
  std::vector<geom::Point> route;
  Task task = Task::kVisit;
  std::vector<Contract> contracts = {};
  std::vector<SharedPlace> places = {};

  void tell(flow::BehaviorProbe& p) const {
    p.percepts.id = {2};
    p.percepts.pose = {{10, 0}, 0.0};
    p.percepts.order.sequence = 3;
    p.percepts.order.task = task;
    p.percepts.order.route = route;
    p.percepts.unit.size = 2;
    p.percepts.unit.rank = 1;
    p.percepts.contracts = contracts;
    p.percepts.shared_places = places;
  }
  flow::BehaviorProbe probe_of(const char* name) const {
    flow::BehaviorProbe p = probe(name);
    tell(p);
    return p;
  }
  // The part of that number, from 0.
  Unit& add(std::uint32_t errand, ContractState state, std::uint32_t contractor = 0) {
    percept::Percepts percepts;
    percepts.order.sequence = 3;
    percepts.order.task = task;
    percepts.order.route = route;
    const schema::Errands errands(percepts);
    contracts.push_back(
        {errands.task(), {errand + 1}, errands.way(errand).front(), state, {1}, {contractor}, {}, 0.0});
    return *this;
  }
};

TEST(NextErrand, AnnouncesWhatNobodyHasAnnouncedItsOwnSliceFirst) {
  Unit unit{.route = {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}}};
  unit.add(3, ContractState::kOpen);
  flow::BehaviorProbe p = unit.probe_of("NextErrand");
  p.step();
  const std::vector<Request> told = asked(p, Kind::kAnnounceTask);
  ASSERT_EQ(told.size(), 3U) << "beside the bid";
  EXPECT_EQ(told[0].object.value, 2U);
  EXPECT_EQ(told[1].object.value, 1U);
  EXPECT_EQ(told[0].place, (geom::Point{1, 0}));
  EXPECT_EQ(p.output<geom::Point>(), (geom::Point{10, 0})) << "nothing is awarded to it";
}

TEST(NextErrand, BidsForThePlaceThatAddsLeastToItsWay) {
  Unit unit{.route = {{0, 0}, {14, 3}, {30, 0}}};
  unit.add(0, ContractState::kOpen).add(1, ContractState::kOpen).add(2, ContractState::kAwarded, 1);
  flow::BehaviorProbe p = unit.probe_of("NextErrand");
  p.step();
  ASSERT_EQ(asked(p, Kind::kBid).size(), 1U);
  EXPECT_EQ(asked(p, Kind::kBid)[0].object.value, 2U);
  EXPECT_GE(asked(p, Kind::kBid)[0].cost, 5.0);
  EXPECT_LE(asked(p, Kind::kBid)[0].cost, 6.0);
}

TEST(NextErrand, GoesToWhatItHasAndTellsThatItIsDone) {
  Unit unit{.route = {{0, 0}, {14, 3}}};
  unit.add(0, ContractState::kDone, 1).add(1, ContractState::kAwarded, 2);
  flow::BehaviorProbe p = unit.probe_of("NextErrand");
  p.set("left", 0.5).step();
  EXPECT_EQ(p.output<geom::Point>(), (geom::Point{14, 3}));
  EXPECT_EQ(asked(p, Kind::kStartTask).size(), 1U);
  EXPECT_TRUE(asked(p, Kind::kFinishTask).empty()) << "what was left is not about this place";
  p.action = {};
  p.set("left", 3.0).step();
  EXPECT_TRUE(asked(p, Kind::kFinishTask).empty());
  p.action = {};
  p.set("left", 1.9).step();
  EXPECT_EQ(asked(p, Kind::kFinishTask).size(), 1U);
  EXPECT_EQ(asked(p, Kind::kKeepTasks).size(), 1U);
}

TEST(NextErrand, KeepsWhatItSetOutForThoughAnotherPlaceIsNearerNow) {
  Unit unit{.route = {{14, 0}, {20, 0}}};
  unit.add(1, ContractState::kStarted, 2);
  flow::BehaviorProbe p = unit.probe_of("NextErrand");
  p.step();
  unit.contracts.clear();
  unit.add(0, ContractState::kAwarded, 2).add(1, ContractState::kStarted, 2);
  p.action = {};
  unit.tell(p);
  p.step();
  EXPECT_EQ(p.output<geom::Point>(), (geom::Point{20, 0}));
}

TEST(NextErrand, BidsThoughThereIsMuchToAnnounce) {
  Unit unit{.route = {}};
  for (int i = 0; i < 50; ++i) unit.route.push_back({10.0 + i, 0});
  for (std::uint32_t i = 0; i < 40; ++i) unit.add(i, i < 20 ? ContractState::kOpen : ContractState::kFailed);
  flow::BehaviorProbe p = unit.probe_of("NextErrand");
  p.step();
  EXPECT_EQ(asked(p, Kind::kBid).size(), 1U);
}

TEST(NextErrand, GivesBackWhatNoWayLeadsTo) {
  Unit unit{.route = {{14, 3}}};
  unit.add(0, ContractState::kStarted, 2);
  flow::BehaviorProbe p = unit.probe_of("NextErrand");
  p.step();
  p.action = {};
  p.set("left", schema::kClosedEnd + 1.0).step();
  ASSERT_EQ(asked(p, Kind::kRenegeTask).size(), 1U);
  // On offer again, it does not bid; nor announces it when nobody else wanted it.
  for (const ContractState state : {ContractState::kOpen, ContractState::kFailed}) {
    unit.contracts[0].state = state;
    unit.contracts[0].contractor = {};
    p.action = {};
    unit.tell(p);
    p.step();
    EXPECT_EQ(p.action.request_count, 0);
  }
}

TEST(NextErrand, GivesBackWhatItComesNoNearerTo) {
  Unit unit{.route = {{14, 3}}};
  unit.add(0, ContractState::kStarted, 2);
  flow::BehaviorProbe p = unit.probe_of("NextErrand");
  int cycles = 0;
  while (asked(p, Kind::kRenegeTask).empty() && cycles < 2000) {
    p.action = {};
    p.set("left", 50.0).step();
    ++cycles;
  }
  EXPECT_NEAR(cycles * p.percepts.cycle_duration, 60.0, 1.0);
}

TEST(NextErrand, GoesAlongThePieceOfASearch) {
  Unit unit{.route = {{0, 0}, {0, 9}, {0, 9}, {20, 9}, {20, 0}}, .task = Task::kSearch};
  unit.add(0, ContractState::kDone, 1).add(1, ContractState::kAwarded, 2);
  flow::BehaviorProbe p = unit.probe_of("NextErrand");
  const std::vector<geom::Point> legs = {{0, 9}, {20, 9}, {20, 0}};
  for (const geom::Point leg : legs) {
    p.action = {};
    p.percepts.pose.position = leg;
    p.set("left", 9.0);
    p.step();
    p.step();
    EXPECT_EQ(p.output<geom::Point>(), leg);
    EXPECT_TRUE(asked(p, Kind::kFinishTask).empty());
    p.set("left", 0.1).step();
  }
  EXPECT_EQ(asked(p, Kind::kFinishTask).size(), 1U);
}

TEST(NextErrand, KeepsToTheLegsOfASearchRoundWhatNobodyKnewOf) {
  Unit unit{.route = {{0, 0}, {0, 9}, {0, 9}, {60, 9}}, .task = Task::kSearch};
  unit.add(0, ContractState::kDone, 1).add(1, ContractState::kAwarded, 2);
  flow::BehaviorProbe p = unit.probe_of("NextErrand");
  p.percepts.order.swath = 10.0;
  struct Step {
    geom::Point at;
    double left;  // of the way to what it heads for
    geom::Point goal;
  };
  const std::vector<Step> steps = {
      {{0, 9}, 9.0, {0, 9}},
      {{0, 9}, 0.1, {60, 9}},
      {{3, 9.3}, 57.0, {60, 9}},
      {{12.5, 10.1}, 47.0, {17.5, 9}},  // it has left the leg, round something
      {{14.9, 12}, 4.0, {17.5, 9}},
      {{15.1, 12}, 4.0, {22.5, 9}},
      {{20.1, 9.3}, 2.0, {27.5, 9}},  // it is nearly back
      {{25.1, 9.1}, 4.0, {60, 9}},    // and now it is
      {{30, 10.1}, 30.0, {35, 9}},
      {{30, 12}, schema::kClosedEnd + 0.1, {40, 9}},  // what stands at that place is left out
      {{30, 12}, schema::kClosedEnd + 0.1, {60, 9}},  // nor can it come to the next one
      {{30, 12}, 30.0, {60, 9}},
      {{59, 10}, 5.0, {60, 9}},
  };
  for (const Step& step : steps) {
    p.action = {};
    p.percepts.pose.position = step.at;
    p.set("left", step.left).step();
    EXPECT_EQ(p.output<geom::Point>(), step.goal) << step.at.x;
    EXPECT_TRUE(asked(p, Kind::kFinishTask).empty());
  }
  p.action = {};
  p.set("left", 0.1).step();
  EXPECT_EQ(asked(p, Kind::kFinishTask).size(), 1U);
}

TEST(NextErrand, LooksBackAtWhatItHasLeftUnseenOfAPiece) {
  Unit unit{.route = {{0, 0}, {60, 0}}, .task = Task::kSearch};
  unit.add(0, ContractState::kStarted, 2);
  flow::BehaviorProbe p = unit.probe_of("NextErrand");
  p.percepts.order.swath = 10.0;
  const std::vector<ways::Round> rock{{{30, 0}, 3.0}};
  p.percepts.ground = {.revision = 1, .discs = rock, .walls = {}, .bounds = {}};
  // Goes where it wants to, but round the rock at first.
  geom::Point here{0, 0};
  double lowest = 0.0;
  double farthest = 0.0;
  int cycles = 0;
  for (; asked(p, Kind::kFinishTask).empty() && cycles < 1'000; ++cycles) {
    const geom::Point goal = cycles == 0 ? here : p.output<geom::Point>();
    p.action = {};
    p.percepts.pose.position = here;
    p.set("left", distance(here, goal)).step();
    const bool is_round = farthest < 38.0;
    const geom::Offset left = is_round ? geom::Offset{1, 0} : p.output<geom::Point>() - here;
    here = here + left * std::min(1.0, 0.4 / std::max(length(left), 1e-9));
    if (is_round) here.y = std::clamp(std::min(here.x - 22, 38 - here.x), 0.0, 6.0);
    lowest = std::min(lowest, here.y);
    farthest = std::max(farthest, here.x);
  }
  EXPECT_LT(cycles, 400);
  EXPECT_LT(lowest, -0.5) << "it goes back to what lies beyond the rock";
  EXPECT_GT(farthest, 57.5);
}

TEST(NextErrand, BeginsAPieceOfASearchAtTheNextCornerWhereItCanNotComeToTheFirst) {
  Unit unit{.route = {{20, 0}, {40, 0}, {40, 9}}, .task = Task::kSearch};
  unit.add(0, ContractState::kAwarded, 2);
  flow::BehaviorProbe p = unit.probe_of("NextErrand");
  p.step();
  EXPECT_EQ(p.output<geom::Point>(), (geom::Point{20, 0}));
  p.percepts.pose.position = {19, 1.5};
  p.set("left", schema::kClosedEnd + 0.1).step();
  p.action = {};
  p.set("left", 20.0).step();
  EXPECT_EQ(p.output<geom::Point>(), (geom::Point{25, 0})) << "back to the lane beyond what stands there";
  EXPECT_TRUE(asked(p, Kind::kRenegeTask).empty());
  p.percepts.pose.position = {40, 0};
  for (int corner = 0; corner < 3; ++corner) {
    p.action = {};
    p.set("left", 0.1).step();
  }
  EXPECT_EQ(asked(p, Kind::kFinishTask).size(), 1U);
}

TEST(NextErrand, GivesBackAPieceOfASearchOfWhichItComesToNothing) {
  Unit unit{.route = {{20, 0}, {40, 0}, {40, 9}}, .task = Task::kSearch};
  unit.add(0, ContractState::kStarted, 2);
  flow::BehaviorProbe p = unit.probe_of("NextErrand");
  p.step();
  int cycles = 0;
  for (; asked(p, Kind::kRenegeTask).empty() && cycles < 5000; ++cycles) {
    p.action = {};
    p.set("left", 10.0).step();
    EXPECT_TRUE(asked(p, Kind::kFinishTask).empty());
  }
  EXPECT_LT(cycles, 5000);
  EXPECT_EQ(std::string(p.action.alert.data()),
            "Way: gives back part 1 of 1, at (20, 0): it comes no nearer");
}

TEST(NextErrand, TakesOnePieceAtATimeAndLeavesOthersTheirShares) {
  // Eight pieces, from one side to the other: two shares.
  Unit unit{.route = {}, .task = Task::kSearch};
  for (int i = 0; i < 8; ++i) {
    unit.route.push_back({i * 10.0, 0});
    unit.route.push_back({i * 10.0 + 10.0, 0});
  }
  for (std::uint32_t i = 0; i < 8; ++i) unit.add(i, ContractState::kOpen);
  unit.contracts[0].state = ContractState::kDone;
  unit.contracts[0].contractor = {1};
  flow::BehaviorProbe p = unit.probe_of("NextErrand");
  p.step();
  ASSERT_EQ(asked(p, Kind::kBid).size(), 1U);
  EXPECT_EQ(asked(p, Kind::kBid)[0].object.value, 5U) << "the next one belongs to the share of robot 1";
  unit.contracts[4].state = ContractState::kAwarded;
  unit.contracts[4].contractor = {2};
  p.action = {};
  unit.tell(p);
  p.step();
  EXPECT_TRUE(asked(p, Kind::kBid).empty());
}

// A robot that has nothing left to do, beside the share that robot 1 is on the first piece of: from (0, 0)
// on, each of 100 m.
struct Helper : Unit {
  Helper() : Unit{.route = {}, .task = Task::kSearch} {
    for (int i = 0; i < 4; ++i) {
      route.push_back({i * 100.0, 0});
      route.push_back({i * 100.0 + 100.0, 0});
    }
    for (std::uint32_t i = 0; i < 4; ++i) add(i, ContractState::kOpen);
    contracts[0].state = ContractState::kStarted;
    contracts[0].contractor = {1};
  }
  /// The pieces that it bids for, from 1.
  std::vector<std::uint32_t> bids_at(geom::Point place, double time = 10.0) const {
    flow::BehaviorProbe p = probe_of("NextErrand");
    p.percepts.pose.position = place;
    p.percepts.time = time;
    p.step();
    std::vector<std::uint32_t> out;
    for (const Request& bid : asked(p, Kind::kBid)) out.push_back(bid.object.value);
    return out;
  }
};

TEST(NextErrand, HelpsWithTheLastPieceOfAShareWhereItIsThereInTime) {
  const Helper helper;
  EXPECT_EQ(helper.bids_at({400, 0}), (std::vector<std::uint32_t>{4}));
  EXPECT_EQ(helper.bids_at({300, 190}), (std::vector<std::uint32_t>{4}));
  EXPECT_TRUE(helper.bids_at({300, 210}).empty()) << "the other one is there before";
}

TEST(NextErrand, WaitsForTheNextPieceOfItsShareUntilThatIsOnOfferAgain) {
  Helper own;
  own.contracts[0].state = ContractState::kDone;
  own.contracts[0].contractor = {2};
  own.contracts[1].state = ContractState::kFailed;  // nobody wanted it, as all were busy
  EXPECT_TRUE(own.bids_at({100, 0}).empty());
  own.contracts[1].state = ContractState::kOpen;
  EXPECT_EQ(own.bids_at({100, 0}), (std::vector<std::uint32_t>{2}));
}

TEST(NextErrand, LeavesTheNextPieceToWhoIsOnTheOneBefore) {
  Helper helper;
  for (std::size_t i = 2; i < 4; ++i) {
    helper.contracts[i].state = ContractState::kDone;
    helper.contracts[i].contractor = {2};
  }
  EXPECT_TRUE(helper.bids_at({100, 0}).empty());
  helper.contracts[0].contractor = {};  // lost
  helper.contracts[0].state = ContractState::kOpen;
  EXPECT_EQ(helper.bids_at({100, 0}), (std::vector<std::uint32_t>{1}));
}

TEST(NextErrand, TakesTheNextPieceOfWhoTakesLong) {
  const Helper helper;
  EXPECT_TRUE(helper.bids_at({100, 500}, 129.0).empty());
  EXPECT_EQ(helper.bids_at({100, 500}, 131.0), (std::vector<std::uint32_t>{2}));
}

TEST(ErrandsLeft, CountsThoseThatAreNotDone) {
  Unit unit{.route = {{0, 0}, {14, 3}, {1, 1}}};
  unit.add(0, ContractState::kDone, 1).add(1, ContractState::kAwarded, 2);
  flow::BehaviorProbe p = unit.probe_of("ErrandsLeft");
  p.step();
  EXPECT_EQ(p.output<double>(), 2.0);
}

TEST(ErrandsLeft, IsBelowZeroWhereNobodyWantsWhatIsLeft) {
  Unit unit{.route = {{0, 0}, {14, 3}, {1, 1}}};
  unit.add(0, ContractState::kDone, 1).add(1, ContractState::kFailed).add(2, ContractState::kStarted, 1);
  flow::BehaviorProbe p = unit.probe_of("ErrandsLeft");
  const auto left = [&](double time) {
    unit.tell(p);
    p.percepts.time = time;
    p.step();
    return p.output<double>();
  };
  EXPECT_EQ(left(100.0), 2.0) << "somebody is at work";
  unit.contracts[2].state = ContractState::kFailed;
  EXPECT_EQ(left(4.0), 2.0) << "somebody may announce them anew";
  EXPECT_EQ(left(6.0), -2.0);
  unit.contracts.clear();
  unit.route.clear();
  EXPECT_EQ(left(0.0), -1.0) << "there is nothing that could be done";
}

TEST(ErrandsLeft, OfAPatrolIsBelowZeroForWhoComesToNoPlace) {
  const Unit unit{.route = {{100, 0}, {200, 0}, {200, 20}}, .task = Task::kPatrol};
  flow::BehaviorProbe p = unit.probe_of("NextErrand");
  const auto left_after = [&](double left) {
    p.action = {};
    p.set("left", left).step();
    flow::BehaviorProbe other = unit.probe_of("ErrandsLeft");
    const std::vector<SharedPlace> places{
        {{2}, asked(p, Kind::kSharePlace)[0].object, {}, p.percepts.pose.position, 0.0}};
    other.percepts.shared_places = places;
    other.step();
    return other.output<double>();
  };
  EXPECT_EQ(left_after(90.0), 1.0);
  EXPECT_EQ(left_after(1.0), 1.0);
  for (const double left : {1.0, 1.0, -1.0, -1.0})
    EXPECT_EQ(left_after(schema::kClosedEnd + 1.0), left > 0.0 ? 1.0 : -1.0);
  EXPECT_EQ(left_after(1.0), 1.0) << "a way is open again";
}

TEST(NextErrand, CountsPlacesThatNoWayLeadsToAsPassed) {
  const Unit unit{.route = {{10, 0}, {20, 0}, {20, 20}}, .task = Task::kPatrol};
  flow::BehaviorProbe p = unit.probe_of("NextErrand");
  p.step();
  for (const double left : {1.0, schema::kClosedEnd + 1.0, 1.0, 1.0}) {
    p.action = {};
    p.set("left", left).step();
  }
  EXPECT_TRUE(
      schema::tour_place(p.percepts.order, {{2}, p.action.requests[0].object, {}, {}, 0.0})->has_gone_round);
}

TEST(NextErrand, GoesRoundAndTellsWhereItIs) {
  const Unit unit{.route = {{0, 0}, {20, 0}, {20, 20}}, .task = Task::kPatrol};
  flow::BehaviorProbe p = unit.probe_of("NextErrand");
  p.set("left", 9.0).step();
  EXPECT_EQ(p.output<geom::Point>(), (geom::Point{20, 0})) << "the end of the nearest leg";
  for (const geom::Point next : {geom::Point{20, 20}, {0, 0}, {20, 0}}) {
    p.action = {};
    p.set("left", 1.0).step();
    p.set("left", 9.0).step();
    EXPECT_EQ(p.output<geom::Point>(), next);
  }
  ASSERT_FALSE(asked(p, Kind::kSharePlace).empty());
  const Request told = asked(p, Kind::kSharePlace)[0];
  const auto at = schema::tour_place(p.percepts.order, {{2}, told.object, {}, told.place, 0.0});
  ASSERT_TRUE(at);
  EXPECT_EQ(at->leg, 1U);
  EXPECT_FALSE(at->has_gone_round);
  p.action = {};
  p.set("left", 1.0).step();
  EXPECT_TRUE(
      schema::tour_place(p.percepts.order, {{2}, p.action.requests[0].object, {}, {}, 0.0})->has_gone_round);
}

TEST(ErrandPace, IsNothingForWhoHasNothing) {
  Unit unit{.route = {{0, 0}, {14, 3}}};
  unit.add(0, ContractState::kAwarded, 1);
  for (const double pace : {0.0, 1.0}) {
    flow::BehaviorProbe p = unit.probe_of("ErrandPace");
    p.step();
    EXPECT_EQ(p.output<double>(), pace);
    unit.add(1, ContractState::kAwarded, 2);
  }
}

TEST(ErrandPace, WaitsForWhoIsAheadUntilAllAreEvenlySpread) {
  // Round 80 m; this one is at 10 of it.
  Unit unit{.route = {{0, 0}, {20, 0}, {20, 20}, {0, 20}}, .task = Task::kPatrol};
  percept::Order order;
  order.sequence = 3;
  order.route = unit.route;
  const auto at = [&](std::uint32_t robot, std::size_t leg, geom::Point place, double time) {
    unit.places.push_back({{robot}, schema::tour_code(order, {leg, false}), {}, place, time});
  };
  at(2, 1, {10, 0}, 100.0);
  const auto pace = [&] {
    flow::BehaviorProbe p = unit.probe_of("ErrandPace");
    p.percepts.time = 100.0;
    p.step();
    return p.output<double>();
  };
  EXPECT_EQ(pace(), 1.0) << "alone";
  at(3, 3, {10, 20}, 100.0);
  EXPECT_EQ(pace(), 1.0) << "half a round ahead";
  at(4, 1, {15, 0}, 100.0);
  EXPECT_EQ(pace(), 0.2) << "close ahead";
  unit.places.back().time = 90.0;
  EXPECT_EQ(pace(), 1.0) << "who is silent does not count";
}

TEST(TellOfErrand, NamesAPlaceOnce) {
  const Unit unit{.route = {{50, 60}, {20, 30}, {70, 30}}};
  ways::PlannedWay way;
  way.corners = {geom::Point{10, 0}, {13, 4}};
  way.count = 2;
  way.end = ways::WayEnd::kClosedOff;
  flow::BehaviorProbe p = unit.probe_of("TellOfErrand");
  p.percepts.unit.rank = 0;
  const auto told = [&](geom::Point goal) {
    p.action = {};
    p.set("way", way).set("goal", goal).step();
    return std::string(p.action.alert.data());
  };
  EXPECT_NE(told({50, 60}).find("(50, 60)"), std::string::npos);
  EXPECT_EQ(told({50, 60}), "");
  EXPECT_NE(told({20, 30}), "");
  EXPECT_EQ(told({50, 60}), "") << "nor when it comes back to it";
  EXPECT_EQ(told({10, 0}), "") << "where it is, as long as there is nothing for it";
  way.end = ways::WayEnd::kBesideGoal;
  EXPECT_NE(told({70, 30}).find("something stands"), std::string::npos);
}

TEST(TellOfErrand, OfTheLeaderLooksAtAllPlaces) {
  const std::vector<geom::Segment> room{
      {{40, 40}, {60, 40}}, {{60, 40}, {60, 60}}, {{60, 60}, {40, 60}}, {{40, 60}, {40, 40}}};
  for (const Task task : {Task::kVisit, Task::kPatrol}) {
    const Unit unit{.route = {{20, 30}, {50, 50}, {70, 30}}, .task = task};
    flow::BehaviorProbe p = unit.probe_of("TellOfErrand");
    p.percepts.ground = {.revision = 7, .discs = {}, .walls = room, .bounds = {0, -100, 100, 100}};
    ways::PlannedWay way;
    way.corners = {geom::Point{10, 0}, {20, 30}};
    way.count = 2;
    way.end = ways::WayEnd::kGoal;
    p.set("way", way).set("goal", geom::Point{20, 30});
    for (const std::uint32_t rank : {1U, 0U}) {
      p.percepts.unit.rank = rank;
      std::string told;
      for (int cycle = 0; cycle < 5; ++cycle) {
        p.action = {};
        p.step();
        told += p.action.alert.data();
      }
      EXPECT_EQ(told.find("no way to (50, 50) is known") != std::string::npos, rank == 0) << told;
    }
  }
}

TEST(TellOfErrand, OfALeaderThatIsShutInSaysThatAndLeavesThePlacesToTheNext) {
  const std::vector<geom::Segment> room{
      {{0, -10}, {20, -10}}, {{20, -10}, {20, 10}}, {{20, 10}, {0, 10}}, {{0, 10}, {0, -10}}};
  Unit unit{.route = {{50, 50}, {70, 30}}};
  const auto told_by = [&](std::uint32_t rank, geom::Point here) {
    flow::BehaviorProbe p = unit.probe_of("TellOfErrand");
    p.percepts.pose.position = here;
    p.percepts.unit.rank = static_cast<std::uint16_t>(rank);
    // What was planned on ground of the same revision is remembered.
    p.percepts.ground = {.revision = 19, .discs = {}, .walls = room, .bounds = {-100, -100, 100, 100}};
    ways::PlannedWay way;
    way.corners = {here};
    way.count = 1;
    way.end = ways::WayEnd::kClosedOff;
    p.set("way", way).set("goal", geom::Point{50, 50});
    std::string told;
    for (int cycle = 0; cycle < 5; ++cycle) {
      p.action = {};
      p.step();
      told += p.action.alert.data();
      for (const Request& one : asked(p, Kind::kSharePlace))
        unit.places.push_back({p.percepts.id, one.object, {}, here, 0.0});
    }
    return told;
  };
  EXPECT_EQ(told_by(1, {10, 0}), "") << "the first one tells";
  EXPECT_EQ(told_by(0, {10, 0}),
            "Way: no way leads out of where robot 2 is: a wall at (19.9, 10.0) is in front of it");
  ASSERT_EQ(unit.places.size(), 1U);
  EXPECT_NE(told_by(1, {10, 0}).find("no way leads out"), std::string::npos);
  ASSERT_EQ(unit.places.size(), 2U);
  EXPECT_EQ(told_by(1, {40, 0}), "") << "nor does it lead now";
}

TEST(TellOfErrand, OfOthersNamesWhatWasNotKnownAtTheBeginning) {
  const Unit unit{.route = {{50, 60}, {20, 30}}};
  ways::PlannedWay way;
  way.corners = {geom::Point{10, 0}, {13, 4}};
  way.count = 2;
  way.end = ways::WayEnd::kClosedOff;
  flow::BehaviorProbe p = unit.probe_of("TellOfErrand");
  const auto told = [&](std::uint64_t revision) {
    p.action = {};
    p.percepts.ground.revision = revision;
    p.set("way", way).set("goal", geom::Point{50, 60}).step();
    return std::string(p.action.alert.data());
  };
  EXPECT_EQ(told(7), "");
  EXPECT_NE(told(8).find("(50, 60)"), std::string::npos);
  EXPECT_EQ(told(9), "");
}

TEST(WayLeft, IsFarWhereNoWayLeadsOn) {
  const Unit unit{.route = {}};
  ways::PlannedWay way;
  way.corners = {geom::Point{10, 0}, {13, 4}};
  way.count = 2;
  for (const auto& [end, left] :
       {std::pair{ways::WayEnd::kGoal, 5.0}, {ways::WayEnd::kClosedOff, 5.0 + schema::kClosedEnd}}) {
    way.end = end;
    flow::BehaviorProbe p = unit.probe_of("WayLeft");
    p.set("way", way).set("goal", geom::Point{10, 100}).step();
    EXPECT_EQ(p.output<double>(), left);
    p.set("follows", false).step();
    EXPECT_EQ(p.output<double>(), 100.0);
  }
}

}  // namespace
}  // namespace mlab::library_test
