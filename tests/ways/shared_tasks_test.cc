// Commands that a unit shares among its robots, by what these tell each other: VISIT and PATROL.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "begun_run.h"
#include "mlab/base/random.h"
#include "mlab/lang/mdl/mdl.h"

namespace mlab {
namespace {

using Places = std::vector<geom::Point>;

// Places side by side in a rectangle that are free of rocks, and whether somebody has come near enough to see
// them, on their side of all walls.
class Seen {
 public:
  struct Rock {
    geom::Point center;
    double radius;
  };
  Seen(geom::Point low, geom::Point high, const std::vector<Rock>& rocks, double swath, double step = 2.0)
      : reach_(swath / 2.0), step_(step) {
    for (double y = low.y + step / 2.0; y < high.y; y += step) {
      for (double x = low.x + step / 2.0; x < high.x; x += step) {
        const geom::Point p{x, y};
        if (std::ranges::all_of(rocks,
                                [&](const Rock& one) { return geom::distance(one.center, p) > one.radius; }))
          unseen_.push_back(p);
      }
    }
    all_ = static_cast<double>(unseen_.size());
  }
  void add_wall(geom::Segment wall) { walls_.push_back(wall); }
  void look(geom::Segment from) {
    std::erase_if(unseen_, [&](geom::Point p) {
      const geom::Point near = geom::nearest_point(from, p);
      return geom::distance(near, p) <= reach_ &&
             std::ranges::none_of(
                 walls_, [&](const geom::Segment& wall) { return geom::intersects({near, p}, wall); });
    });
  }
  double area() const { return step_ * step_ * all_; }  // [m^2]
  double share() const { return 1.0 - static_cast<double>(unseen_.size()) / all_; }

 private:
  double reach_;
  double step_;  // from place to place [m]
  std::vector<geom::Point> unseen_;
  std::vector<geom::Segment> walls_;
  double all_ = 0.0;
};

/// A run of a mission of one unit.
class SharedTasks : public testing::Test {
 protected:
  static constexpr double kTolerance = 2.0;  // of the standard robot: so near to a place it was there [m]

  /// @param measures  control measures of the map
  /// @param unknown   rocks that no map shows
  void make(int robots, const std::string& preamble, const std::string& command,
            const std::string& measures = "", const std::vector<Seen::Rock>& unknown = {}) {
    std::string text = "OVERLAY map.odl\nMISSION-AREA 600 400\n" + preamble + "UNIT <team>";
    for (int i = 0; i < robots; ++i) text += " ROBOT";
    text += "\nCOMMAND LIST:\n0. UNIT team START 20 150 0 10\n1. UNIT team " + command + "\n";
    text::Diagnostics sink;
    mdl::LoadOptions options;
    options.files.is_file = [](const std::string& path) { return path == "map.odl"; };
    options.files.read = [&](const std::string& path) -> text::Result<text::SourcePtr> {
      return std::make_shared<const text::Source>(path, "CONTROL MEASURES:\n" + measures);
    };
    const auto mission =
        mdl::check_mission(std::make_shared<const text::Source>("test.mdl", text), "", sink, options);
    ASSERT_NE(mission, nullptr) << text::render(sink);
    overlay::EnvironmentEvent rocks;
    rocks.start = 1.0;
    for (const Seen::Rock& one : unknown)
      rocks.changes.push_back(overlay::AddObstacle{one.center, one.radius});
    run_ = begun_run(mission, 120.0, told_, {rocks});
    ASSERT_NE(run_, nullptr);
  }

  bool is_done() const { return run_->state().outcome == mission::Outcome::kDone; }
  /// Until it is over, or so much time has passed [s].
  template <class Look>
  void go(double seconds, const Look& look) {
    while (run_->time() < seconds && run_->step() != run::MissionRun::Progress::kOver) look();
  }
  void go(double seconds) {
    go(seconds, [] {});
  }

  /// @return  how near some robot came to each of the places [m]
  std::vector<double> go_and_look(double seconds, const Places& places) {
    std::vector<double> nearest(places.size(), std::numeric_limits<double>::infinity());
    go(seconds, [&] {
      for (std::size_t i = 0; i < places.size(); ++i) {
        for (std::uint32_t robot = 1; robot <= robots(); ++robot)
          nearest[i] = std::min(nearest[i], geom::distance(places[i], place_of(robot)));
      }
    });
    return nearest;
  }

  geom::Point place_of(std::uint32_t robot) const {
    return run_->fleet().pose(*run_->fleet().find({robot})).position;
  }
  std::uint32_t robots() const { return static_cast<std::uint32_t>(run_->fleet().robots().size()); }
  double driven() const {
    double out = 0.0;
    for (const fleet::FleetRobot& robot : run_->fleet().robots())
      out += run_->world().body(robot.body).distance_driven;
    return out;
  }
  unsigned contacts() const {
    unsigned out = 0;
    for (const fleet::FleetRobot& robot : run_->fleet().robots())
      out += run_->world().body(robot.body).contacts;
    return out;
  }

  std::vector<std::uint32_t> lost() const {
    std::vector<std::uint32_t> out;
    for (const fleet::FleetRobot& robot : run_->fleet().robots()) {
      if (robot.life == fleet::RobotLife::kFaulted) out.push_back(robot.id.value);
    }
    return out;
  }

  static Places random_places(base::Random& random, int count) {
    Places out;
    while (static_cast<int>(out.size()) < count) {
      const geom::Point p{random.uniform(40, 560), random.uniform(20, 380)};
      if (std::ranges::all_of(out, [&](geom::Point q) { return geom::distance(p, q) > 15.0; }))
        out.push_back(p);
    }
    return out;
  }
  void search(Seen& seen) {
    int cycle = 0;
    Places before;
    go(3000, [&] {
      if (++cycle % 3 != 0) return;
      Places now;
      for (std::uint32_t robot = 1; robot <= robots(); ++robot) now.push_back(place_of(robot));
      if (before.empty()) before = now;  // not yet where they start
      for (std::size_t i = 0; i < now.size(); ++i) seen.look({before[i], now[i]});
      before = now;
    });
  }
  static std::vector<Seen::Rock> random_rocks(std::uint64_t seed, geom::Point low, geom::Point high,
                                              std::size_t count) {
    base::Random random(seed);
    std::vector<Seen::Rock> out;
    while (out.size() < count) {
      const Seen::Rock rock{
          {random.uniform(low.x + 20, high.x - 20), random.uniform(low.y + 20, high.y - 20)},
          random.uniform(2, 10)};
      if (std::ranges::all_of(out, [&](const Seen::Rock& one) {
            return geom::distance(one.center, rock.center) > one.radius + rock.radius + 12.0;
          }))
        out.push_back(rock);
    }
    return out;
  }
  static std::string written(const std::vector<Seen::Rock>& rocks) {
    std::string out;
    for (const Seen::Rock& one : rocks)
      out += fmt::format("OBSTACLE {:.3f} {:.3f} {:.3f}\n", one.center.x, one.center.y, one.radius);
    return out;
  }
  static std::string written(const Places& places) {
    std::string out;
    for (const geom::Point p : places) out += fmt::format(" {:.3f} {:.3f}", p.x, p.y);
    return out;
  }

  std::unique_ptr<run::MissionRun> run_;
  std::string told_;
};

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

TEST_F(SharedTasks, ASearchLeavesOutTheCornerOnWhichAnotherRobotStands) {
  // Where the first lane begins, and another one ends.
  for (const char* place : {"65 65", "65 135", "135 65", "135 135"}) {
    SCOPED_TRACE(place);
    make(2, "UNIT <parked> ROBOT\n", fmt::format("SEARCH Field SWATH 10 AND UNIT parked START {}", place),
         "OBJ Field 60 60 140 60 140 140 60 140\n");
    Seen seen({60, 60}, {140, 140}, {}, 10.0);
    search(seen);
    EXPECT_TRUE(is_done()) << told_;
    EXPECT_GE(seen.share(), 0.99);
    EXPECT_LT(run_->time(), 450.0);
  }
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

TEST_F(SharedTasks, ASearchSeesAllInSharesOfEqualLength) {
  const double swath = 16.0;
  const std::vector<Seen::Rock> rocks = random_rocks(1, {60, 60}, {420, 340}, 12);
  make(4, written(rocks), fmt::format("SEARCH Field SWATH {}", swath),
       "OBJ Field 60 60 420 60 420 340 60 340\n");
  Seen seen({60, 60}, {420, 340}, rocks, swath);
  search(seen);
  EXPECT_TRUE(is_done()) << told_;
  EXPECT_EQ(contacts(), 0U);
  EXPECT_GE(seen.share(), 0.995);
  // The way there and to the next piece included.
  EXPECT_LE(driven(), 1.3 * seen.area() / swath);
  for (const fleet::FleetRobot& robot : run_->fleet().robots())
    EXPECT_LE(run_->world().body(robot.body).distance_driven, 1.25 * driven() / 4.0);
}

TEST_F(SharedTasks, LanesOfANarrowSwathAreKeptToo) {
  for (const double swath : {1.0, 2.0, 6.0}) {
    SCOPED_TRACE(fmt::format("a swath of {} m", swath));
    make(3, "", fmt::format("SEARCH Field SWATH {}", swath), "OBJ Field 100 100 140 100 140 140 100 140\n");
    Seen seen({100, 100}, {140, 140}, {}, swath, 0.25);
    search(seen);
    EXPECT_TRUE(is_done()) << told_;
    EXPECT_GE(seen.share(), 0.995);
  }
}

TEST_F(SharedTasks, WhatRocksThatNobodyKnewOfHideFromALaneIsLookedAtAfterwards) {
  for (const double swath : {10.0, 15.0}) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      SCOPED_TRACE(fmt::format("seed {}, a swath of {} m", seed, swath));
      const std::vector<Seen::Rock> rocks = random_rocks(seed, {80, 80}, {320, 320}, 30);
      make(4, "", fmt::format("SEARCH Field SWATH {}", swath), "OBJ Field 100 100 300 100 300 300 100 300\n",
           rocks);
      Seen seen({100, 100}, {300, 300}, rocks, swath);
      search(seen);
      EXPECT_TRUE(is_done()) << told_;
      EXPECT_EQ(contacts(), 0U);
      EXPECT_GE(seen.share(), 0.994);  // a rock on each 1,300 m^2
    }
  }
}

TEST_F(SharedTasks, WhatIsLeftUnseenOfALostRobotsPieceIsLookedAtByTheOthers) {
  const std::vector<Seen::Rock> rocks = random_rocks(4, {80, 80}, {320, 320}, 30);
  make(3, "SET FAILING-ROBOTS 1\nSET FAILURES-WITHIN 120\n", "SEARCH Field SWATH 15",
       "OBJ Field 100 100 300 100 300 300 100 300\n", rocks);
  Seen seen({100, 100}, {300, 300}, rocks, 15.0);
  search(seen);
  EXPECT_TRUE(is_done()) << told_;
  EXPECT_EQ(lost().size(), 1U);
  EXPECT_GE(seen.share(), 0.99);
}

TEST_F(SharedTasks, WhatNobodyKnewToBeOutOfReachEndsNoSearch) {
  // A ring of rocks round a part of the area: nobody sees its middle.
  std::vector<Seen::Rock> ring;
  for (int i = 0; i < 16; ++i) {
    const double angle = 2.0 * 3.14159265358979 * i / 16;
    ring.push_back({{200 + 30 * std::cos(angle), 200 + 30 * std::sin(angle)}, 8.0});
  }
  make(2, "", "SEARCH Field SWATH 10", "OBJ Field 140 140 260 140 260 260 140 260\n", ring);
  Seen seen({140, 140}, {260, 260}, ring, 10.0);
  search(seen);
  EXPECT_TRUE(is_done()) << told_;
  EXPECT_EQ(contacts(), 0U);
  EXPECT_GE(seen.share(), 0.84);  // all outside of it
  EXPECT_LT(run_->time(), 1000.0);
}

TEST_F(SharedTasks, WhatLiesUnderSomethingWideIsNotSearchedForLong) {
  // Five of eight pieces lie under a rock that nobody knew of.
  make(2, "", "SEARCH Field SWATH 20", "OBJ Field 150 100 350 100 350 200 150 200\n", {{{270, 150}, 80.0}});
  Seen seen({150, 100}, {350, 200}, {{{270, 150}, 80.0}}, 20.0);
  search(seen);
  EXPECT_TRUE(is_done()) << told_;
  EXPECT_GE(seen.share(), 0.99);
  EXPECT_NE(told_.find("leaves out part"), std::string::npos) << told_;
  EXPECT_NE(told_.find("something stands on all of it"), std::string::npos) << told_;
  EXPECT_EQ(contacts(), 0U);
}

TEST_F(SharedTasks, ASearchUnderSomethingThatLeavesNothingOfItFreeFailsSoon) {
  make(2, "", "SEARCH Field SWATH 20", "OBJ Field 150 100 250 100 250 200 150 200\n", {{{200, 150}, 85.0}});
  go(200.0);
  EXPECT_EQ(run_->state().outcome, mission::Outcome::kFailed) << told_;
  EXPECT_NE(told_.find("its robots can do no more of it"), std::string::npos) << told_;
  EXPECT_LT(run_->time(), 120.0);
}

TEST_F(SharedTasks, WhatIsBehindADoorIsSearched) {
  for (const double door : {2.0, 9.0}) {
    SCOPED_TRACE(fmt::format("a door of {} m", door));
    make(
        3, "", "SEARCH Field",
        "OBJ Field 60 60 200 60 200 180 60 180\n" +
            fmt::format("WALL low 130 0 130 {}\nWALL high 130 {} 130 400\n", 120 - door / 2, 120 + door / 2));
    Seen seen({60, 60}, {200, 180}, {}, 10.0);
    seen.add_wall({{130, 0}, {130, 120 - door / 2}});
    seen.add_wall({{130, 120 + door / 2}, {130, 400}});
    search(seen);
    EXPECT_TRUE(is_done()) << told_;
    EXPECT_EQ(told_.find("will see"), std::string::npos) << told_;
    EXPECT_EQ(contacts(), 0U);
    EXPECT_GE(seen.share(), 0.995);
  }
}

TEST_F(SharedTasks, WhatIsBehindAWallIsLookedAtFromItsOtherSide) {
  // Half a swath from the wall, lanes on its one side are near enough to what is behind it.
  make(2, "", "SEARCH Field SWATH 20", "OBJ Field 60 60 200 60 200 100 60 100\nWALL fence 66 92 194 92\n");
  Seen seen({60, 60}, {200, 100}, {}, 20.0);
  seen.add_wall({{66, 92}, {194, 92}});
  search(seen);
  EXPECT_TRUE(is_done()) << told_;
  EXPECT_EQ(contacts(), 0U);
  EXPECT_GE(seen.share(), 0.995);
}

TEST_F(SharedTasks, WhatALostRobotHadIsSearchedByTheOthers) {
  const std::vector<Seen::Rock> rocks = random_rocks(2, {60, 60}, {260, 220}, 4);
  make(3, "SET FAILING-ROBOTS 1\nSET FAILURES-WITHIN 90\n" + written(rocks), "SEARCH Field",
       "OBJ Field 60 60 260 60 260 220 60 220\n");
  Seen seen({60, 60}, {260, 220}, rocks, 10.0);
  search(seen);
  EXPECT_TRUE(is_done()) << told_;
  EXPECT_EQ(lost().size(), 1U);
  EXPECT_GE(seen.share(), 0.99);  // 5.2 m are kept from rocks, 5 m are seen
}

TEST_F(SharedTasks, ASwathWiderThanTheAreaSeesAllOfIt) {
  make(1, "", "SEARCH U SWATH 10000", "OBJ U 60 40 160 40 160 160 130 160 130 80 90 80 90 160 60 160\n");
  go(600);
  EXPECT_TRUE(is_done()) << told_;
  EXPECT_EQ(told_.find("can be searched"), std::string::npos) << told_;
}

TEST_F(SharedTasks, AnOutlineWithoutAreaIsToldAsSuch) {
  for (const char* corners : {"60 60 70 70 100 100", "60 60 60 60 60 60"}) {
    told_.clear();
    make(1, "", "SEARCH Line", fmt::format("OBJ Line {}\n", corners));
    go(600);
    EXPECT_EQ(run_->state().outcome, mission::Outcome::kFailed) << told_;
    EXPECT_NE(told_.find("Line has no area"), std::string::npos) << told_;
    EXPECT_LT(run_->time(), 20.0);
  }
}

TEST_F(SharedTasks, AnAreaThatCanNotBeSeenIsToldBeforehand) {
  make(1, "", "SEARCH Far", "OBJ Far 700 500 800 500 800 600\n");
  go(600);
  EXPECT_EQ(run_->state().outcome, mission::Outcome::kFailed) << told_;
  EXPECT_NE(told_.find("nothing of Far can be searched"), std::string::npos) << told_;
}

}  // namespace
}  // namespace mlab
