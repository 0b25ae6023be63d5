// Commands that a unit shares among its robots, by what these tell each other: VISIT and PATROL.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "mlab/base/random.h"
#include "shared_tasks.h"

namespace mlab {
namespace {

double length_of(geom::Point start, const Places& way) {
  double out = 0.0;
  for (const geom::Point p : way) out += geom::distance(std::exchange(start, p), p);
  return out;
}

// Ways from each start over all places together, as short as a long local search makes them: places and parts
// of ways are moved at random, from many beginnings.
double shortest_ways(const Places& starts, const Places& places, base::Random& random) {
  double best = std::numeric_limits<double>::infinity();
  for (int beginning = 0; beginning < 5; ++beginning) {
    std::vector<Places> ways(starts.size());
    for (const geom::Point p : places) ways[random.below(ways.size())].push_back(p);
    const auto total = [&] {
      double out = 0.0;
      for (std::size_t i = 0; i < ways.size(); ++i) out += length_of(starts[i], ways[i]);
      return out;
    };
    double length = total();
    for (int tried = 0; tried < 12'000; ++tried) {
      const std::vector<Places> before = ways;
      Places& from = ways[random.below(ways.size())];
      if (from.empty()) continue;
      const std::size_t at = random.below(from.size());
      if (random.below(2) == 0) {
        const geom::Point moved = from[at];
        from.erase(from.begin() + static_cast<std::ptrdiff_t>(at));
        Places& to = ways[random.below(ways.size())];
        to.insert(to.begin() + static_cast<std::ptrdiff_t>(random.below(to.size() + 1)), moved);
      } else {
        const std::size_t end = at + random.below(from.size() - at + 1);
        std::reverse(from.begin() + static_cast<std::ptrdiff_t>(at),
                     from.begin() + static_cast<std::ptrdiff_t>(end));
      }
      const double now = total();
      if (now < length)
        length = now;
      else
        ways = before;
    }
    best = std::min(best, length);
  }
  return best;
}

TEST_F(SharedTasks, FiveRobotsVisitTwentyPlacesOnShortWays) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    base::Random random(seed);
    const Places places = random_places(random, 20);
    make(5, "", "VISIT" + written(places));
    const std::vector<double> nearest = go_and_look(1000, places);
    EXPECT_TRUE(is_done()) << told_;
    EXPECT_LE(std::ranges::max(nearest), kTolerance);
    EXPECT_EQ(contacts(), 0U);
    Places starts;
    for (int i = 0; i < 5; ++i) starts.push_back({20.0, 150.0 + 10.0 * i});
    const double shortest = shortest_ways(starts, places, random);
    EXPECT_LE(driven(), 1.25 * shortest);
  }
}

TEST_F(SharedTasks, WhatALostRobotHadIsVisitedByTheOthers) {
  base::Random random(7);
  const Places places = random_places(random, 20);
  make(5, "SET FAILING-ROBOTS 1\nSET FAILURES-WITHIN 30\n", "VISIT" + written(places));
  const std::vector<double> nearest = go_and_look(1000, places);
  EXPECT_TRUE(is_done()) << told_;
  EXPECT_LE(std::ranges::max(nearest), kTolerance);
  EXPECT_EQ(lost().size(), 1U);
  EXPECT_NE(told_.find(" is not running, `unit team VISIT"), std::string::npos) << told_;
  EXPECT_NE(told_.find("goes on without it"), std::string::npos) << told_;
}

TEST_F(SharedTasks, APlaceThatNoWayLeadsToIsNamedAndTheOthersAreVisited) {
  std::string room;
  for (int i = 0; i < 16; ++i) {
    const double angle = 2.0 * 3.14159265358979 * i / 16;
    room += fmt::format("OBSTACLE {:.3f} {:.3f} 8\n", 300 + 30 * std::cos(angle), 200 + 30 * std::sin(angle));
  }
  const Places places = {{100, 100}, {300, 200}, {500, 300}};
  make(2, room, "VISIT" + written(places));
  const std::vector<double> nearest = go_and_look(600, places);
  EXPECT_EQ(run_->state().outcome, mission::Outcome::kFailed);
  EXPECT_LE(nearest[0], kTolerance);
  EXPECT_LE(nearest[2], kTolerance);
  EXPECT_NE(told_.find("no way to (300, 200) is known"), std::string::npos) << told_;
}

TEST_F(SharedTasks, PlacesThatNoWayLeadsToAreNamedAtOnceAndOnce) {
  const std::string room = "WALL room 400 300 440 300 440 340 400 340 400 300\n";
  for (const char* command : {"VISIT", "PATROL"}) {
    told_.clear();
    make(3, "", fmt::format("{} 100 100 300 100 420 320 500 60 UNTIL TIMEOUT 300", command), room);
    go(5);
    EXPECT_NE(told_.find("no way to (420, 320) is known"), std::string::npos) << told_;
    go(600);
    EXPECT_EQ(told_.find("no way to (420, 320)"), told_.rfind("no way to (420, 320)")) << told_;
  }
}

TEST_F(SharedTasks, APlaceToWhichALongWayRoundLeadsIsVisited) {
  // More than a minute long it leads away from the place.
  make(1, "", "VISIT 60 5", "WALL Long 40 0 40 390\n");
  go(400.0);
  EXPECT_TRUE(is_done()) << told_;
  EXPECT_EQ(told_.find("gives back"), std::string::npos) << told_;
}

TEST_F(SharedTasks, APlaceUnderAnObstacleIsVisitedBesideIt) {
  for (const bool is_known : {true, false}) {
    SCOPED_TRACE(is_known);
    told_.clear();
    if (is_known)
      make(2, "", "VISIT 300 200 100 100", "OBSTACLE 300 200 20\n");
    else
      make(2, "", "VISIT 300 200 100 100", "", {{{300, 200}, 20.0}});
    go(400.0);
    EXPECT_TRUE(is_done()) << told_;
    EXPECT_NE(told_.find("is the nearest place to it"), std::string::npos) << told_;
    if (is_known) {
      EXPECT_EQ(told_.find("gives back"), std::string::npos) << told_;
    }
    EXPECT_EQ(contacts(), 0U);
  }
}

TEST_F(SharedTasks, APlaceOnWhichAnotherRobotStandsIsVisitedBesideIt) {
  make(2, "UNIT <parked> ROBOT\n", "VISIT 100 100 300 200 AND UNIT parked START 300 200");
  go(600);
  EXPECT_TRUE(is_done()) << told_;
}

TEST_F(SharedTasks, WhatAllHaveGivenBackEndsTheCommandSoon) {
  const std::string room = "WALL room 400 300 440 300 440 340 400 340 400 300\n";
  make(2, "", "VISIT 100 100 420 320", room);
  go(600);
  EXPECT_EQ(run_->state().outcome, mission::Outcome::kFailed);
  EXPECT_NE(told_.find("failed: its robots can do no more of it; robot 1 at"), std::string::npos) << told_;
  // Both have been there; so long it was alone.
  EXPECT_LT(run_->time(), 250.0);
}

TEST_F(SharedTasks, APatrolWhoseRobotsComeToNoPlaceEndsSoon) {
  make(2, "", "PATROL 300 100 300 300", "WALL room 10 140 60 140 60 190 10 190 10 140\n");
  go(600);
  EXPECT_EQ(run_->state().outcome, mission::Outcome::kFailed);
  EXPECT_NE(told_.find("no way leads out of where robot 1 is: a wall at"), std::string::npos) << told_;
  EXPECT_NE(told_.find("no way leads out of where robot 2 is"), std::string::npos) << told_;
  EXPECT_LT(run_->time(), 60.0);
}

TEST_F(SharedTasks, WhoIsShutInLeavesItToTheOthersToTellOfPlaces) {
  make(2, "", "VISIT 100 100 420 320",
       "WALL cell 15 145 25 145 25 155 15 155 15 145\n"
       "WALL room 400 300 440 300 440 340 400 340 400 300\n");
  go(5);
  EXPECT_NE(told_.find("no way leads out of where robot 1 is: a wall at"), std::string::npos) << told_;
  EXPECT_NE(told_.find("no way to (420, 320) is known"), std::string::npos) << told_;
  EXPECT_EQ(told_.find("no way to (100, 100)"), std::string::npos) << told_;
  go(600);
  EXPECT_EQ(told_.find("no way to (420, 320)"), told_.rfind("no way to (420, 320)")) << told_;
}

TEST_F(SharedTasks, APatrolComesOnThoughNoWayLeadsToOneOfItsPlaces) {
  make(1, "", "PATROL 20 150 420 320 560 20 SPEED 0.5",
       "WALL room 400 300 440 300 440 340 400 340 400 300\n");
  go(400);
  EXPECT_EQ(run_->state().outcome, mission::Outcome::kRunning) << told_;
}

TEST_F(SharedTasks, UntilEndsAVisit) {
  make(2, "", "VISIT 100 100 500 300 550 20 UNTIL TIMEOUT 30");
  go(600);
  EXPECT_TRUE(is_done()) << told_;
  EXPECT_NEAR(run_->time(), 30.0, 2.0);
}

// How long it was between two visits of the first place of a PATROL, by any robot, from that time on [s].
class Rounds {
 public:
  explicit Rounds(geom::Point place) : place_(place) {}
  void look(double time, std::uint32_t robot, geom::Point at) {
    was_there_.resize(std::max<std::size_t>(was_there_.size(), robot + 1));
    const bool is_there = geom::distance(at, place_) < 6.0;
    if (is_there && was_there_[robot] == 0) {
      if (last_ >= 0.0) gaps_.push_back({time, time - last_});
      last_ = time;
    }
    was_there_[robot] = is_there ? 1 : 0;
  }
  std::vector<double> gaps(double from, double to) const {
    std::vector<double> out;
    for (const auto& [time, gap] : gaps_) {
      if (time - gap >= from && time <= to) out.push_back(gap);
    }
    return out;
  }

 private:
  geom::Point place_;
  std::vector<char> was_there_;
  std::vector<std::pair<double, double>> gaps_;
  double last_ = -1.0;
};

TEST_F(SharedTasks, APatrolSpreadsEvenlyAndAgainAfterALoss) {
  const Places tour = {{100, 100}, {300, 100}, {300, 300}, {100, 300}};
  make(4, "SET FAILING-ROBOTS 1\nSET FAILURES-WITHIN 1900\nOBSTACLE 200 100 6\nOBSTACLE 300 200 5\n",
       "PATROL" + written(tour) + " UNTIL TIMEOUT 2400");
  Rounds rounds(tour[2]);
  double lost_at = 0.0;
  go(3000, [&] {
    if (lost().empty()) lost_at = run_->time();
    for (std::uint32_t robot = 1; robot <= 4; ++robot) {
      if (run_->fleet().find({robot})->life == fleet::RobotLife::kRunning)
        rounds.look(run_->time(), robot, place_of(robot));
    }
  });
  EXPECT_TRUE(is_done()) << told_;
  EXPECT_EQ(contacts(), 0U);
  ASSERT_EQ(lost().size(), 1U);
  ASSERT_GT(lost_at, 700.0) << "choose another seed";
  for (const auto& [from, to, robots] : {std::tuple{300.0, lost_at, 4}, {lost_at + 300.0, 2400.0, 3}}) {
    const std::vector<double> gaps = rounds.gaps(from, to);
    ASSERT_GE(gaps.size(), 6U) << robots;
    double mean = 0.0;
    for (const double gap : gaps) mean += gap / static_cast<double>(gaps.size());
    EXPECT_GE(std::ranges::min(gaps), 0.8 * mean) << robots;
    EXPECT_LE(std::ranges::max(gaps), 1.2 * mean) << robots;
    // A round of 800 m at 4 m/s.
    EXPECT_NEAR(mean * robots, 200.0, 30.0);
  }
}

TEST_F(SharedTasks, APatrolWithoutUntilAsksWhenItHasGoneRound) {
  make(2, "", "PATROL 50 150 150 150 100 220");
  go(600);
  EXPECT_TRUE(is_done()) << told_;
  EXPECT_NE(told_.find("is patrolling 50 150 150 150 100 220. Proceed?"), std::string::npos) << told_;
  EXPECT_GT(run_->time(), 60.0);
}

}  // namespace
}  // namespace mlab
