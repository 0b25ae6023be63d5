#include <algorithm>
#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/base/hash.h"
#include "mlab/fleet/fleet.h"
#include "mlab/robot/program/configuration_file.h"
#include "mlab/sim/simulated_binding.h"

// Tasks that robots of a team contract for, by the programs of configurations.
namespace mlab::simulated {
namespace {

using percept::Contract;
using percept::ContractState;

constexpr double kCycle = 0.1;

// Robot 1 announces, the others are of a second type; all are one unit.
struct Team {
  mission::Mission mission;
  std::vector<robot::RobotProgram> programs;
  sim::SimulatedBinding bodies;
  fleet::Fleet fleet;

  Team(const std::string& manager, const std::string& worker, const std::vector<geom::Point>& workers,
       int threads = 1)
      : mission(mission_of(workers.size())),
        programs(programs_of({manager, worker})),
        bodies(sim::World{}, {1, threads}),
        fleet(mission, programs, {binding::BodySpec{}, binding::BodySpec{}}, bodies, 1) {
    EXPECT_TRUE(fleet.start({1}, {{-30.0, -30.0}, 0.0}));
    for (std::uint32_t i = 0; i < workers.size(); ++i) EXPECT_TRUE(fleet.start({i + 2}, {workers[i], 0.0}));
  }

  static mission::Mission mission_of(std::size_t workers) {
    mission::Mission out;
    out.types.resize(2);
    mission::Unit unit;
    unit.name = "team";
    for (std::uint32_t i = 1; i <= workers + 1; ++i) {
      mission::Robot robot;
      robot.id = {i};
      robot.type = i == 1 ? 0 : 1;
      out.robots.push_back(robot);
      unit.members.push_back({i});
    }
    out.units.push_back(unit);
    return out;
  }
  static std::vector<robot::RobotProgram> programs_of(const std::vector<std::string>& movements) {
    std::vector<robot::RobotProgram> out;
    for (const std::string& movement : movements) {
      const auto source = std::make_shared<const text::Source>(
          "tried.cdl", "robot Tried is Scout { movement = " + movement + "; }\n");
      text::Diagnostics sink;
      const auto made = robot::configure(source, "", "", {}, {}, sink);
      EXPECT_TRUE(made && !sink.has_errors()) << text::render(sink);
      robot::RobotProgram program;
      program.name = "tried";
      program.program = made->built.program;
      program.initial = program.program->make_frame();
      out.push_back(std::move(program));
    }
    return out;
  }

  std::vector<Contract> contracts() const {
    const percept::Percepts told = fleet.perceive_at(*fleet.find({1}), {}, {}, kCycle);
    return {told.contracts.begin(), told.contracts.end()};
  }
  bool is_all_done() const {
    const std::vector<Contract> all = contracts();
    return !all.empty() &&
           std::ranges::all_of(all, [](const Contract& one) { return one.state == ContractState::kDone; });
  }
  // @return whether it came to that within so many seconds
  template <class Condition>
  bool run(double seconds, const Condition& is_so) {
    for (double t = 0.0; t < seconds; t += kCycle) {
      fleet.step(kCycle);
      if (is_so()) return true;
    }
    return false;
  }
  std::set<std::uint32_t> contractors() const {
    std::set<std::uint32_t> out;
    for (const Contract& one : contracts()) out.insert(one.contractor.value);
    return out;
  }
};

std::string announce(const std::vector<geom::Point>& places) {
  std::string out = "cooperate { ";
  int number = 0;
  for (const geom::Point place : places)
    out += "1: AnnounceTaskAt(task = \"Visit\", place = [" + std::to_string(place.x) + ", " +
           std::to_string(place.y) + "], number = " + std::to_string(++number) +
           ", patience = 2 s, repeats = true); ";
  return out + "}";
}

const std::vector<geom::Point> kPlaces = {{10, 0}, {14, 0}, {18, 2}, {-10, 0}, {-14, 0}, {-18, 2}};

TEST(ContractNet, RobotsDivideAndDoWhatWasAnnounced) {
  Team team(announce(kPlaces), "VisitTasks(most = 4)", {{4, 0}, {-4, 0}});
  EXPECT_TRUE(team.run(120.0, [&] { return team.is_all_done(); }));
  ASSERT_EQ(team.contracts().size(), kPlaces.size());
  for (const Contract& one : team.contracts())
    EXPECT_EQ(one.contractor.value, one.place.x > 0 ? 2U : 3U) << one.place.x;
}

TEST(ContractNet, IsTheSameForAnyNumberOfThreads) {
  Team one(announce(kPlaces), "VisitTasks(most = 2)", {{4, 0}, {-4, 0}, {0, 9}}, 1);
  Team four(announce(kPlaces), "VisitTasks(most = 2)", {{4, 0}, {-4, 0}, {0, 9}}, 4);
  for (int cycle = 0; cycle < 300; ++cycle) {
    one.fleet.step(kCycle);
    four.fleet.step(kCycle);
    const std::vector<Contract> a = one.contracts(), b = four.contracts();
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      ASSERT_EQ(a[i].state, b[i].state);
      ASSERT_EQ(a[i].contractor, b[i].contractor);
      ASSERT_EQ(a[i].time, b[i].time);
    }
  }
}

TEST(ContractNet, WhatALostRobotHadIsDoneByTheOthers) {
  Team team(announce(kPlaces), "VisitTasks(most = 4)", {{4, 0}, {-4, 0}});
  ASSERT_TRUE(team.run(10.0, [&] { return team.contractors() == std::set<std::uint32_t>{2, 3}; }));
  team.fleet.stop({3});
  EXPECT_TRUE(team.run(200.0, [&] { return team.is_all_done(); }));
  EXPECT_EQ(team.contractors(), (std::set<std::uint32_t>{2}));
}

TEST(ContractNet, ACheckpointGoesOnAsItWas) {
  Team team(announce(kPlaces), "VisitTasks(most = 4)", {{4, 0}, {-4, 0}});
  team.run(3.0, [] { return false; });
  const auto fleet = team.fleet.save();
  const auto bodies = team.bodies.save();
  ASSERT_TRUE(fleet && bodies);
  const auto goes_on = [&] {
    std::vector<Contract> out;
    for (int cycle = 0; cycle < 100; ++cycle) {
      team.fleet.step(kCycle);
      std::ranges::copy(team.contracts(), std::back_inserter(out));
    }
    return out;
  };
  const std::vector<Contract> first = goes_on();
  ASSERT_TRUE(team.bodies.restore(**bodies));
  team.fleet.restore(*fleet);
  const std::vector<Contract> again = goes_on();
  ASSERT_EQ(first.size(), again.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].state, again[i].state);
    EXPECT_EQ(first[i].contractor, again[i].contractor);
    EXPECT_EQ(first[i].time, again[i].time);
  }
}

// As the historic bidders do: wait for an auction, bid, execute what was won, tell that it is done.
TEST(ContractNet, TasksOfTheHistoricNamesAreBidForAndDone) {
  const std::string bidder =
      "sequence { start Waiting: Stand(); when IsTaskOpen() goto Bidding;"
      " Bidding: BidOnTask(); when IsAuctionEnded() goto Judging;"
      " Judging: Stand(); when IsTaskAwarded() goto Executing; when IsTaskLost() goto Waiting;"
      " Executing: ExecuteTask(); when IsTaskDone(by_self = true) goto Waiting; }";
  const std::string manager =
      "sequence { start Telling: SharePlace(place = [12, 5]); when Wait(delay = 0.5 s) goto Announcing;"
      " Announcing: AnnounceTask(task = \"SurveyTask\"); when IsTaskDone(task = \"SurveyTask\") goto Over;"
      " when IsAuctionFailed() goto Telling; final Over: Notify(message = \"all done\"); }";
  Team team(manager, bidder, {{4, 0}, {-4, 0}});
  EXPECT_TRUE(team.run(60.0, [&] {
    return std::ranges::binary_search(team.fleet.find({1})->notifications, base::hash_text("all done"));
  }));
  ASSERT_EQ(team.contracts().size(), 1U);
  EXPECT_EQ(team.contracts()[0].contractor.value, 2U) << "the nearer one";
  EXPECT_LT(geom::distance(team.fleet.pose(*team.fleet.find({2})).position, {12, 5}), 1.5);
}

}  // namespace
}  // namespace mlab::simulated
