#include "mlab/fleet/contracts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "mlab/base/hash.h"
#include "mlab/fleet/fleet_robot.h"
#include "mlab/schema/contracts.h"
#include "mlab/schema/requests.h"

namespace mlab::fleet {
namespace {

using base::hash_text;
using percept::Contract;
using percept::ContractState;
using percept::Request;
using Kind = Request::Kind;

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

// Robots 1 to 3 are team 0, robot 4 is team 1. A cycle takes a second.
struct TestTeams {
  Contracts contracts;
  std::vector<FleetRobot> robots;
  double time = 0.0;

  TestTeams() {
    for (std::uint32_t i = 0; i < 4; ++i) {
      robots.emplace_back();
      robots.back().id = {i + 1};
      robots.back().team = i / 3;
    }
  }
  TestTeams& ask(std::uint32_t robot, const Request& request) {
    EXPECT_TRUE(robots[robot - 1].action.ask(request));
    return *this;
  }
  TestTeams& announce(std::uint32_t robot, std::uint32_t object, double wait = 0.0, double patience = 3.0,
                      geom::Point place = {}) {
    Request request = schema::announcement(hash_text("Visit"), {object}, place);
    request.wait = wait;
    request.patience = patience;
    return ask(robot, request);
  }
  TestTeams& tell(std::uint32_t robot, Kind kind, std::uint32_t object = 0, double cost = 0.0) {
    Request request;
    request.kind = kind;
    request.notification = hash_text("Visit");
    request.object = {object};
    request.cost = cost;
    return ask(robot, request);
  }
  TestTeams& bid(std::uint32_t robot, std::uint32_t object, double cost) {
    return tell(robot, Kind::kBid, object, cost);
  }
  void resolve() {
    contracts.resolve(robots, time);
    for (FleetRobot& robot : robots) robot.action = {};
    time += 1.0;
  }
  const Contract* find(std::uint32_t object, std::uint32_t team = 0) const {
    for (const Contract& contract : contracts.of(team)) {
      if (contract.object.value == object) return &contract;
    }
    return nullptr;
  }
  // Who has the task, or had it when it was done; 0: nobody.
  std::uint32_t contractor(std::uint32_t object) const { return find(object)->contractor.value; }
  ContractState state(std::uint32_t object) const { return find(object)->state; }
};

TEST(Contracts, AnAnnouncementIsKnownToItsTeamAlone) {
  TestTeams t;
  t.announce(2, 7, 0.0, 3.0, {5, 6}).resolve();
  ASSERT_NE(t.find(7), nullptr);
  EXPECT_EQ(t.find(7)->task, hash_text("Visit"));
  EXPECT_EQ(t.find(7)->manager.value, 2U);
  EXPECT_EQ(t.find(7)->place, (geom::Point{5, 6}));
  EXPECT_TRUE(t.contracts.of(1).empty());
  t.bid(4, 7, 0.0).resolve();
  EXPECT_EQ(t.contractor(7), 0U) << "robot 4 is of another team";
}

TEST(Contracts, StandByTaskAndObjectWhateverTheOrderInWhichTheyWereAnnounced) {
  TestTeams t;
  for (const std::uint32_t object : {9U, 3U, 6U}) t.announce(1, object, 9.0);
  t.announce(4, 4, 9.0).resolve();
  ASSERT_EQ(t.contracts.of(0).size(), 3U);
  EXPECT_EQ(t.contracts.of(0)[0].object.value, 3U);
  EXPECT_EQ(t.contracts.of(0)[2].object.value, 9U);
  EXPECT_EQ(t.contracts.of(1).size(), 1U);
}

TEST(Contracts, TheLeastBidGetsTheTaskOfEqualsTheLowestId) {
  TestTeams t;
  t.announce(1, 7).announce(1, 8, 1.0).resolve();
  t.bid(1, 7, 3.0).bid(2, 7, 2.0).bid(3, 7, 2.0).resolve();
  EXPECT_EQ(t.contractor(7), 2U);
  EXPECT_EQ(t.state(7), ContractState::kAwarded);
  t.tell(2, Kind::kKeepTasks).bid(1, 8, -1.0).bid(3, 8, 0.0).bid(2, 8, kNoNumber).resolve();
  EXPECT_EQ(t.contractor(8), 1U) << "a cost that is no number is no bid";
}

TEST(Contracts, BidsAreComparedWhenTheWaitIsOver) {
  TestTeams t;
  t.announce(1, 7, 2.0).resolve();
  t.bid(3, 7, 1.0).resolve();
  EXPECT_EQ(t.state(7), ContractState::kOpen) << "after one second";
  t.bid(3, 7, 2.0).bid(2, 7, 1.0).resolve();
  EXPECT_EQ(t.contractor(7), 2U) << "a bid holds for its cycle";
}

TEST(Contracts, ATeamGivesOneTaskInACycle) {
  TestTeams t;
  t.announce(1, 7).announce(1, 8).announce(4, 7).resolve();
  t.bid(1, 7, 1.0).bid(2, 8, 2.0).bid(4, 7, 9.0).resolve();
  EXPECT_EQ(t.contractor(7), 1U);
  EXPECT_EQ(t.contractor(8), 0U);
  EXPECT_EQ(t.find(7, 1)->contractor.value, 4U) << "another team";
  t.tell(1, Kind::kKeepTasks).bid(2, 8, 2.0).resolve();
  EXPECT_EQ(t.contractor(8), 2U);
}

TEST(Contracts, ATaskThatNobodyWantsHasFailedAndCanBeAnnouncedAnew) {
  TestTeams t;
  t.announce(1, 7, 1.0).resolve();
  EXPECT_EQ(t.state(7), ContractState::kOpen);
  t.resolve();
  EXPECT_EQ(t.state(7), ContractState::kFailed);
  t.bid(2, 7, 1.0).resolve();
  EXPECT_EQ(t.contractor(7), 0U) << "too late";
  t.announce(3, 7).resolve();
  t.bid(2, 7, 1.0).resolve();
  EXPECT_EQ(t.contractor(7), 2U);
  EXPECT_EQ(t.find(7)->manager.value, 3U);
}

TEST(Contracts, ATaskWaitsWhileTheTeamBidsForOthers) {
  TestTeams t;
  t.announce(1, 7).announce(1, 8).resolve();
  t.bid(1, 7, 1.0).resolve();
  EXPECT_EQ(t.state(8), ContractState::kOpen) << "the least bid of this cycle was for another one";
  t.tell(1, Kind::kKeepTasks).resolve();
  EXPECT_EQ(t.state(8), ContractState::kFailed) << "nobody bids for anything";
  t.announce(1, 8).announce(1, 9, 2.0).resolve();
  t.tell(1, Kind::kKeepTasks).bid(2, 9, 1.0).resolve();
  EXPECT_EQ(t.state(8), ContractState::kOpen);
}

TEST(Contracts, WhatIsInWorkIsNotAnnouncedAnew) {
  TestTeams t;
  t.announce(1, 7).resolve();
  t.bid(2, 7, 1.0).resolve();
  t.tell(2, Kind::kStartTask, 7).announce(3, 7, 0.0, 3.0, {9, 9}).resolve();
  EXPECT_EQ(t.state(7), ContractState::kStarted);
  EXPECT_EQ(t.find(7)->place, geom::Point{});
  t.tell(2, Kind::kFinishTask, 7).resolve();
  EXPECT_EQ(t.state(7), ContractState::kDone);
  EXPECT_EQ(t.contractor(7), 2U);
  t.announce(3, 7, 0.0, 3.0, {9, 9}).resolve();
  EXPECT_EQ(t.find(7)->place, (geom::Point{9, 9})) << "what is done is";
}

TEST(Contracts, OnlyWhoHasATaskTellsWhatCameOfIt) {
  TestTeams t;
  t.announce(1, 7, 5.0).resolve();
  t.tell(2, Kind::kFinishTask, 7).resolve();
  EXPECT_EQ(t.state(7), ContractState::kOpen);
  for (int i = 0; i < 4; ++i) t.bid(2, 7, 1.0).resolve();
  ASSERT_EQ(t.contractor(7), 2U);
  t.tell(1, Kind::kFinishTask, 7).tell(3, Kind::kRenegeTask, 7).tell(2, Kind::kStartTask, 99).resolve();
  EXPECT_EQ(t.state(7), ContractState::kAwarded);
}

TEST(Contracts, ATaskOfARobotThatWasSilentIsOnOfferAgain) {
  TestTeams t;
  t.announce(1, 7, 0.0, 3.0).announce(1, 8, 1.0, 3.0).resolve();
  t.bid(2, 7, 1.0).resolve();
  t.bid(3, 8, 1.0).resolve();
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(t.contractor(7), 2U) << i;
    t.tell(3, Kind::kKeepTasks).resolve();
  }
  EXPECT_EQ(t.contractor(7), 0U) << "four seconds after it was awarded";
  EXPECT_EQ(t.contractor(8), 3U);
  t.tell(3, Kind::kKeepTasks).bid(1, 7, 5.0).bid(2, 7, 6.0).resolve();
  EXPECT_EQ(t.contractor(7), 1U);
}

TEST(Contracts, WhoGaveATaskBackDoesNotGetItAgain) {
  TestTeams t;
  t.announce(1, 7, 1.0).resolve();
  t.bid(2, 7, 1.0).resolve();
  ASSERT_EQ(t.contractor(7), 2U);
  t.tell(2, Kind::kRenegeTask, 7).resolve();
  EXPECT_EQ(t.state(7), ContractState::kOpen);
  EXPECT_EQ(t.find(7)->reneged.value, 2U);
  t.bid(2, 7, 1.0).bid(3, 7, 9.0).resolve();
  EXPECT_EQ(t.contractor(7), 3U);
  t.tell(3, Kind::kRenegeTask, 7).resolve();
  t.bid(3, 7, 1.0).resolve();
  EXPECT_EQ(t.state(7), ContractState::kFailed) << "nobody else wants it";
}

TEST(Contracts, DropPlacesThatAreNoNumbersAndWhatIsTooMany) {
  TestTeams t;
  t.announce(1, 7, 0.0, 3.0, {kNoNumber, 0.0}).resolve();
  EXPECT_TRUE(t.contracts.of(0).empty());
  for (std::uint32_t object = 0; object < Contracts::kMostOfATeam + 5; ++object)
    t.announce(1, object, 1e6).resolve();
  t.announce(4, 1, 1e6).resolve();
  EXPECT_EQ(t.contracts.of(0).size(), Contracts::kMostOfATeam);
  EXPECT_EQ(t.contracts.of(1).size(), 1U) << "teams are counted for themselves";
}

TEST(Contracts, ForgetTheOldestThatIsOverWhereThereAreTooMany) {
  TestTeams t;
  t.announce(1, 0).resolve();  // nobody wants it
  t.resolve();
  t.announce(1, 1).resolve();
  t.resolve();
  EXPECT_EQ(t.find(1)->state, ContractState::kFailed);
  for (std::uint32_t object = 2; object <= Contracts::kMostOfATeam; ++object)
    t.announce(1, object, 1e6).resolve();
  EXPECT_EQ(t.contracts.of(0).size(), Contracts::kMostOfATeam);
  EXPECT_EQ(t.find(0), nullptr);
  EXPECT_NE(t.find(1), nullptr);
}

TEST(Contracts, WhoHasATaskAndHasNotBegunMayHandItToWhoeverItCostsLess) {
  for (const double other : {3.0, 8.0}) {
    for (const bool offers : {false, true}) {
      for (const bool has_begun : {false, true}) {
        TestTeams t;
        t.announce(1, 7).resolve();
        t.bid(2, 7, 5.0).resolve();
        if (has_begun) t.tell(2, Kind::kStartTask, 7).resolve();
        if (offers) t.bid(2, 7, 5.0);
        t.bid(3, 7, other).resolve();
        const bool changes = offers && !has_begun && other < 5.0;
        EXPECT_EQ(t.find(7)->contractor.value, changes ? 3U : 2U) << other << offers << has_begun;
      }
    }
  }
}

TEST(Contracts, ACopyGoesOnAlike) {
  TestTeams t;
  t.announce(1, 7, 0.0, 2.0).announce(1, 8, 3.0).resolve();
  t.bid(2, 7, 1.0).resolve();
  TestTeams copy = t;
  for (TestTeams* one : {&t, &copy}) {
    for (int i = 0; i < 4; ++i) one->bid(3, 8, 1.0).resolve();
  }
  ASSERT_EQ(t.contracts.of(0).size(), copy.contracts.of(0).size());
  for (std::size_t i = 0; i < t.contracts.of(0).size(); ++i) {
    EXPECT_EQ(t.contracts.of(0)[i].state, copy.contracts.of(0)[i].state);
    EXPECT_EQ(t.contracts.of(0)[i].contractor, copy.contracts.of(0)[i].contractor);
    EXPECT_EQ(t.contracts.of(0)[i].time, copy.contracts.of(0)[i].time);
  }
}

TEST(TaskWay, EndsWithPlacesThatAreFarBeyondWhatNumbersTell) {
  for (const double far : {1e15, 1e160, 1e308, HUGE_VAL, kNoNumber}) {
    std::vector<Contract> contracts(8);
    for (std::size_t i = 0; i < contracts.size(); ++i) {
      const double side = i % 2 == 0 ? 1.0 : -1.0;
      contracts[i].place = {side * far, side * static_cast<double>(i) * far};
      contracts[i].contractor = {2};
      contracts[i].state = ContractState::kAwarded;
      contracts[i].object = {static_cast<std::uint32_t>(i)};
    }
    percept::Percepts percepts;
    percepts.id = {2};
    percepts.contracts = contracts;
    EXPECT_EQ(schema::TaskWay(percepts).size(), contracts.size()) << far;
  }
}

// --- auctions against the best that there is

struct Routing {
  std::vector<geom::Point> robots;
  std::vector<geom::Point> places;
};

Routing any_routing(int most_robots, int most_places) {
  // Few different numbers, so that places in line, on one spot and equally far occur.
  const auto point = [] {
    return geom::Point{static_cast<double>(*rc::gen::inRange(0, 12)),
                       static_cast<double>(*rc::gen::inRange(0, 12))};
  };
  Routing out;
  for (int n = *rc::gen::inRange(1, most_robots + 1); n > 0; --n) out.robots.push_back(point());
  for (int n = *rc::gen::inRange(1, most_places + 1); n > 0; --n) out.places.push_back(point());
  return out;
}

// The sum of all ways when robots of one team bid in rounds until every place is somebody's.
double auctioned(const Routing& routing) {
  Contracts contracts;
  std::vector<FleetRobot> robots(routing.robots.size());
  for (std::size_t i = 0; i < robots.size(); ++i) robots[i].id = {static_cast<std::uint32_t>(i + 1)};
  double time = 0.0;
  for (std::size_t i = 0; i < routing.places.size(); ++i) {
    Request request = schema::announcement(1, {static_cast<std::uint32_t>(i)}, routing.places[i]);
    request.patience = 1e9;
    // The last of them is known when bidding begins.
    request.wait = static_cast<double>(routing.places.size() - i);
    robots[0].action = {};
    robots[0].action.ask(request);
    contracts.resolve(robots, time);
    time += 1.0;
  }
  const auto way_of = [&](std::size_t i) {
    percept::Percepts percepts;
    percepts.id = robots[i].id;
    percepts.pose.position = routing.robots[i];
    percepts.contracts = contracts.of(0);
    return schema::TaskWay(percepts);
  };
  for (std::size_t round = 0; round < routing.places.size(); ++round) {
    for (std::size_t i = 0; i < robots.size(); ++i) {
      robots[i].action = {};
      const schema::TaskWay way = way_of(i);
      const Contract* best = nullptr;
      for (const Contract& contract : contracts.of(0)) {
        if (contract.state != ContractState::kOpen) continue;
        if (best == nullptr || way.added(contract.place) < way.added(best->place)) best = &contract;
      }
      if (best == nullptr) continue;
      Request request = schema::about_task(Kind::kBid, *best);
      request.cost = way.added(best->place);
      robots[i].action.ask(request);
    }
    contracts.resolve(robots, time);
    time += 1.0;
  }
  for (const Contract& contract : contracts.of(0)) RC_ASSERT(contract.state == ContractState::kAwarded);
  double sum = 0.0;
  for (std::size_t i = 0; i < robots.size(); ++i) sum += way_of(i).length();
  return sum;
}

// The shortest way of one robot over all places whose bit is set, by every order of them.
double shortest(geom::Point start, const std::vector<geom::Point>& places, unsigned set) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if ((set >> i & 1U) != 0) order.push_back(i);
  }
  double best = HUGE_VAL;
  do {
    double sum = 0.0;
    geom::Point at = start;
    for (const std::size_t next : order) {
      sum += geom::distance(at, places[next]);
      at = places[next];
    }
    best = std::min(best, sum);
  } while (std::ranges::next_permutation(order).found);
  return best;
}

// The least sum of ways, over every way to divide the places among the robots.
double optimum(const Routing& routing) {
  const unsigned sets = 1U << routing.places.size();
  std::vector<double> best(sets, HUGE_VAL);
  best[0] = 0.0;
  for (const geom::Point start : routing.robots) {
    std::vector<double> alone(sets);
    for (unsigned set = 0; set < sets; ++set) alone[set] = shortest(start, routing.places, set);
    std::vector<double> next(sets, HUGE_VAL);
    for (unsigned set = 0; set < sets; ++set) {
      for (unsigned part = set;; part = (part - 1) & set) {
        next[set] = std::min(next[set], best[set & ~part] + alone[part]);
        if (part == 0) break;
      }
    }
    best = next;
  }
  return best[sets - 1];
}

// Lagoudakis et al. 2005, theorem for MiniSum and the rule BidSumPath.
TEST(Contracts, SequentialAuctionsLeadOverAtMostTwiceTheShortestWays) {
  EXPECT_TRUE(rc::check("auctioned <= 2 * optimum", [] {
    const Routing routing = any_routing(3, 5);
    const double best = optimum(routing);
    const double ours = auctioned(routing);
    RC_ASSERT(ours <= 2.0 * best + 1e-9);
    RC_ASSERT(ours >= best - 1e-9);
  }));
}

TEST(Contracts, AnAuctionOfASingleTaskIsOptimal) {
  EXPECT_TRUE(rc::check("auctioned == optimum", [] {
    const Routing routing = any_routing(4, 1);
    RC_ASSERT(std::abs(auctioned(routing) - optimum(routing)) < 1e-9);
  }));
}

TEST(Contracts, RobotsShareTheRoundsOfASequentialAuction) {
  // Two clusters, a robot at each: nobody goes over to the other one.
  const Routing routing{{{0, 0}, {100, 0}}, {{1, 0}, {2, 0}, {99, 0}, {98, 0}, {97, 0}}};
  EXPECT_DOUBLE_EQ(auctioned(routing), 5.0);
  EXPECT_DOUBLE_EQ(optimum(routing), 5.0);
}

}  // namespace
}  // namespace mlab::fleet
