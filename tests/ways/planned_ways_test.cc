// The standard robot finds its way wherever there is one, alone and in formation, and says where there is
// none.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "mlab/base/random.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/run/mission_run.h"
#include "mlab/simulated/run.h"

namespace mlab {
namespace {

/// A run of a mission of one unit, and what was told in it.
class Planned : public testing::Test {
 protected:
  struct Rock {
    geom::Point center;
    double radius = 0.0;
  };

  /// A bow of rocks that is open to the west, which lies between the start and the goal.
  static std::vector<Rock> bow() {
    std::vector<Rock> out;
    for (int i = -6; i <= 6; ++i) {
      const double angle = std::numbers::pi / 14.0 * i;
      out.push_back({{260.0 + 60.0 * std::cos(angle), 200.0 + 60.0 * std::sin(angle)}, 8.0});
    }
    return out;
  }

  void make(const std::vector<Rock>& known, const std::string& parameters, int robots = 1,
            const std::string& formation = "Column", const std::vector<Rock>& unknown = {},
            const std::vector<overlay::ObstacleDisc>& moving = {}) {
    std::string text = "MISSION-AREA 600 400\n";
    for (const Rock& rock : known)
      text += fmt::format("OBSTACLE {} {} {}\n", rock.center.x, rock.center.y, rock.radius);
    text += fmt::format(
        "NEW-ROBOT planner \"robot\" blue \"\" (navigation_noise_gain = 0.1, {})\nUNIT <team>", parameters);
    for (int i = 0; i < robots; ++i) text += " planner";
    text += fmt::format(
        "\nCOMMAND LIST:\n0. UNIT team START 150 200 0 10\n1. UNIT team MOVETO 450 200 FORMATION {}\n",
        formation);
    make_run(text, unknown, moving);
  }

  void make_run(const std::string& text, const std::vector<Rock>& unknown = {},
                const std::vector<overlay::ObstacleDisc>& moving = {}) {
    text::Diagnostics sink;
    const auto source = std::make_shared<const text::Source>("test.mdl", text);
    mdl::LoadOptions options;
    options.files.is_file = [](const std::string& path) { return path == "road.odl"; };
    options.files.read = [this](const std::string& path) -> text::Result<text::SourcePtr> {
      return std::make_shared<const text::Source>(path, "CONTROL MEASURES:\n" + roads_);
    };
    const auto read = mdl::check_mission(source, "", sink, options);
    ASSERT_NE(read, nullptr) << text::render(sink);
    const auto mission = std::make_shared<mission::Mission>(*read);
    mission->overlay.obstacles.insert(mission->overlay.obstacles.end(), moving.begin(), moving.end());
    run::RunSettings settings;
    settings.executive.patience = 60.0;
    settings.executive.proceed_all = true;
    overlay::EnvironmentEvent event;
    event.start = 1.0;
    for (const Rock& rock : unknown) event.changes.push_back(overlay::AddObstacle{rock.center, rock.radius});
    if (!unknown.empty()) settings.environment.events.push_back(event);
    overlay::EnvironmentEvent clearing;
    clearing.start = 60.0;
    if (cleared_) {
      clearing.changes.push_back(overlay::RemoveObstacle{*cleared_});
      settings.environment.events.push_back(clearing);
    }
    text::Files files;
    files.is_file = [](const std::string& path) { return path == "mover.cdl"; };
    files.read = [this](const std::string& path) -> text::Result<text::SourcePtr> {
      return std::make_shared<const text::Source>(path, mover_);
    };
    robot::ProgramSources sources;
    sources.files = &files;
    run_ = simulated::make_run(mission, sources, settings, sink);
    ASSERT_NE(run_, nullptr) << text::render(sink);
    run_->set_observer([this](const mission::Effect& effect) {
      if (const auto* told = std::get_if<mission::effect::Tell>(&effect)) told_ += told->text + "\n";
    });
    run_->post(mission::event::Execute{});
  }

  /// Whether it is done.
  bool go(int cycles = 6000) {
    for (int i = 0; i < cycles && run_->step() != run::MissionRun::Progress::kOver; ++i) {
    }
    return run_->state().outcome == mission::Outcome::kDone;
  }
  /// Also those who were run over.
  unsigned contacts() const {
    unsigned out = 0;
    for (const fleet::FleetRobot& robot : run_->fleet().robots()) {
      const binding::BodyState body = run_->world().body(robot.body);
      out += body.contacts + body.run_over;
    }
    return out;
  }

  std::unique_ptr<run::MissionRun> run_;
  std::string roads_ = "ROAD Street 150 200 250 200 400 200 400 100 400 350 8\n";
  std::string told_;
  std::string mover_;                   ///< a configuration that missions may name
  std::optional<geom::Point> cleared_;  ///< the obstacle there goes after a minute
};

TEST_F(Planned, ABowOfRocksHoldsOnlyWhoReacts) {
  make(bow(), "plans_ways = false");
  EXPECT_FALSE(go());
  EXPECT_NE(told_.find("Trap: "), std::string::npos) << told_;
  told_.clear();
  make(bow(), "plans_ways = true");
  EXPECT_TRUE(go()) << told_;
  EXPECT_EQ(contacts(), 0U);
  EXPECT_EQ(told_.find("Trap: "), std::string::npos) << told_;
}

// The robots of a configuration, by what the library has for going.
TEST_F(Planned, SoDoRobotsThatGoByTheLibrary) {
  std::string rocks;
  for (const Rock& rock : bow())
    rocks += fmt::format("OBSTACLE {} {} {}\n", rock.center.x, rock.center.y, rock.radius);
  const auto arrives = [&](const std::string& going, const std::string& known,
                           const std::vector<Rock>& unknown) {
    mover_ =
        "class Cart { body { radius = 0.3 m; } sensor eyes: DetectObstacles() binds sense_obstacles; "
        "actuator base: "
        "Drive(base_velocity = 4 m/s, max_velocity = 4 m/s) binds movement; }\nrobot Mover is Cart { "
        "movement = " +
        going + "; }\n";
    make_run("MISSION-AREA 600 400\n" + known +
                 "NEW-ROBOT mover \"mover.cdl\"\nUNIT <team> mover\n"
                 "COMMAND LIST:\n0. UNIT team START 150 200\n1. UNIT team MOVETO 450 200\n",
             unknown);
    return go() && contacts() == 0;
  };
  const std::string kGo =
      "cooperate {{ 1: GoTo(goal = GetOrderGoal(), avoid_obstacle_gain = 1{}); "
      "1: ReportArrival(goal = DetectGoal(GetOrderGoal()), success_radius = 1 m); }}";
  EXPECT_TRUE(arrives(fmt::format(fmt::runtime(kGo), ""), rocks, {})) << told_;
  EXPECT_TRUE(arrives(fmt::format(fmt::runtime(kGo), ""), "", bow())) << "nobody knew of it\n" << told_;
  EXPECT_FALSE(arrives(fmt::format(fmt::runtime(kGo), ", plans_way = false"), rocks, {}));
  EXPECT_TRUE(arrives("FollowCommands()", rocks, {})) << told_;
}

TEST_F(Planned, TheMissionSaysWhoReactsUnlessATypeDoes) {
  std::string rocks = "MISSION-AREA 600 400\n";
  for (const Rock& rock : bow())
    rocks += fmt::format("OBSTACLE {} {} {}\n", rock.center.x, rock.center.y, rock.radius);
  const std::string steps = "\nCOMMAND LIST:\n0. UNIT team START 150 200\n1. UNIT team MOVETO 450 200\n";
  make_run(rocks + "UNIT <team> ROBOT" + steps);
  EXPECT_TRUE(go()) << told_;
  make_run(rocks + "SET NAVIGATION REACTIVE\nUNIT <team> ROBOT" + steps);
  EXPECT_FALSE(go());
  make_run(
      rocks +
      "SET NAVIGATION REACTIVE\nNEW-ROBOT planner robot blue \"\" (plans_ways = on)\nUNIT <team> planner" +
      steps);
  EXPECT_TRUE(go()) << told_;
}

TEST_F(Planned, ARouteIsFollowedRoundWhatStandsOnIt) {
  for (const char* formation : {"Column", "Wedge"}) {
    make_run(fmt::format(
        "MISSION-AREA 600 400\nOVERLAY road.odl\nOBSTACLE 250 200 30\nOBSTACLE 400 100 12\n"
        "NEW-ROBOT planner robot blue \"\" (formation_spacing = 15)\nUNIT <team> planner planner planner "
        "planner\n"
        "COMMAND LIST:\n0. UNIT team START 100 200 0 10\n1. UNIT team FOLLOW Street FORMATION {}\n",
        formation));
    EXPECT_TRUE(go()) << formation << "\n" << told_;
    EXPECT_EQ(contacts(), 0U);
    EXPECT_LT(distance(run_->fleet().group(run_->fleet().robots().front())->center, {400.0, 350.0}), 10.0);
  }
}

// Drawn by hand, as by the console: more corners than a way can tell at once, dense ones, some by a wall, and
// pieces that lead back or come by again, of which none may be left out.
TEST_F(Planned, ALineIsFollowedToItsEndHoweverItIsDrawn) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  const auto line = [](const char* name, int count, const auto& at) {
    std::string out = fmt::format("AXIS {}", name);
    for (int i = 0; i < count; ++i) out += fmt::format(" {:.2f} {:.2f}", at(i).x, at(i).y);
    return out + "\n";
  };
  roads_ = line("Winding", 120,
                [](int i) { return geom::Point{50.0 + 7.0 * i, 200.0 + 50.0 * std::sin(i / 8.0)}; });
  roads_ += line("Spiral", 80, [](int i) {
    const double radius = 20.0 + 2.0 * i;
    return geom::Point{450.0 + radius * std::cos(0.4 * i), 200.0 + radius * std::sin(0.4 * i)};
  });
  roads_ += line("Rounds", 201, [&](int i) {
    return geom::Point{450.0 + 80.0 * std::cos(i * kTurn / 100), 200.0 + 80.0 * std::sin(i * kTurn / 100)};
  });
  roads_ += line("There_And_Back", 6, [](int i) { return geom::Point{i % 2 == 0 ? 100.0 : 400.0, 200.0}; });
  roads_ += line("Eight", 61, [&](int i) {
    return geom::Point{450.0 + 130.0 * std::sin(i * kTurn / 60),
                       200.0 + 90.0 * std::sin(2.0 * i * kTurn / 60)};
  });
  roads_ += line("Comb", 66, [](int i) {
    const int tooth = i / 3;
    return geom::Point{100.0 + 20.0 * tooth, i % 3 == 1 ? 314.0 : 300.0};
  });
  roads_ += line("Dense", 700, [](int i) { return geom::Point{100.0 + i, 300.0}; });
  const auto follow = [&](const char* name, const char* formation, int robots, double metres,
                          double spacing = 25.0) {
    std::string unit;
    for (int i = 0; i < robots; ++i) unit += " planner";
    make_run(fmt::format(
        "MISSION-AREA 900 400\nOVERLAY road.odl\nNEW-ROBOT planner robot blue \"\" "
        "(formation_spacing = {})\nUNIT <team>{}\n"
        "COMMAND LIST:\n0. UNIT team START 60 200 0 10\n1. UNIT team FOLLOW AXIS-{} FORMATION {}\n",
        spacing, unit, name, formation));
    EXPECT_TRUE(go(14'000)) << name << ", " << formation << "\n" << told_;
    EXPECT_LT(run_->time(), 1.5 * metres / 4.0 + 60.0) << name << ", " << formation;
    EXPECT_GT(run_->time(), 0.8 * metres / 4.0) << name << ", " << formation;
    told_.clear();
  };
  for (const char* formation : {"Column", "Line", "Wedge", "Diamond"}) follow("Winding", formation, 4, 975.0);
  follow("Spiral", "Column", 4, 3100.0);
  follow("Rounds", "Column", 1, 1005.0);
  follow("Rounds", "Column", 4, 1005.0);
  follow("There_And_Back", "Column", 1, 1500.0);
  follow("There_And_Back", "Column", 4, 1500.0, 10.0);
  follow("Eight", "Column", 1, 1075.0);
  follow("Comb", "Wedge", 4, 1060.0, 10.0);
  follow("Eight", "Wedge", 4, 1075.0, 10.0);
  roads_ += "WALL Long 90 303 810 303\n";
  follow("Dense", "Wedge", 4, 700.0, 10.0);
}

// Between shelves: the way has more corners than one can tell at once, and is ten times as long as it looks.
TEST_F(Planned, AWayOfManyCornersIsGoneToItsEndHoweverSlowly) {
  for (int i = 1; i < 20; ++i)
    roads_ += i % 2 == 1 ? fmt::format("WALL w{0} 0 {1} 294 {1}\n", i, 12 * i)
                         : fmt::format("WALL w{0} 6 {1} 300 {1}\n", i, 12 * i);
  const std::string walls = roads_;
  for (const char* rock : {"", "OBSTACLE 150 234 2\n"}) {
    roads_ = walls + rock;
    make_run(
        "MISSION-AREA 300 240\nOVERLAY road.odl\nUNIT <team> ROBOT ROBOT\nCOMMAND LIST:\n"
        "0. UNIT team START 10 6 0 2\n1. UNIT team MOVETO 150 234 FORMATION Column SPEED 1\n");
    EXPECT_TRUE(go(80'000)) << rock << "\n" << told_;
    EXPECT_EQ(contacts(), 0U);
    told_.clear();
  }
}

// Whose stations are by the wall all along go in file there, and leave nothing out.
TEST_F(Planned, ALineRoundAHouseIsFollowedByThoseOnTheSideOfItsWallToo) {
  roads_ =
      "WALL House 150 100 250 100 250 200 150 200 150 100\nROAD Round 120 94 256 94 256 206 144 206 144 "
      "110\n";
  for (const char* formation : {"Diamond", "Wedge", "Column"}) {
    make_run(fmt::format(
        "MISSION-AREA 400 300\nOVERLAY road.odl\nNEW-ROBOT planner robot blue \"\" (formation_spacing = 5)\n"
        "UNIT <team> planner planner planner planner\n"
        "COMMAND LIST:\n0. UNIT team START 100 60\n1. UNIT team FOLLOW Round FORMATION {}\n",
        formation));
    EXPECT_TRUE(go(6'000)) << formation << "\n" << told_;
    EXPECT_EQ(contacts(), 0U);
    for (const fleet::FleetRobot& robot : run_->fleet().robots())
      EXPECT_GT(run_->world().body(robot.body).distance_driven, 350.0)
          << formation << ", robot " << robot.id.value;
    told_.clear();
  }
}

// The last one has to come out of a bow; without being told to, nobody waits for it.
TEST_F(Planned, AUnitKeepsTogetherWhereItIsToldTo) {
  const auto longest = [&](const std::string& set) {
    make_run(
        "MISSION-AREA 1000 400\n" + set +
        "NEW-ROBOT planner robot blue \"\" (formation_spacing = 10)\n"
        "NEW-ROBOT slow robot blue \"\" (formation_spacing = 10, max_velocity = 2)\n"
        "UNIT <team> planner planner planner slow\n"
        "COMMAND LIST:\n0. UNIT team START 100 200 0 10\n1. UNIT team MOVETO 900 200 FORMATION Column\n");
    double out = 0.0;
    while (run_->step() != run::MissionRun::Progress::kOver) {
      for (const fleet::FleetRobot& one : run_->fleet().robots())
        for (const fleet::FleetRobot& other : run_->fleet().robots())
          out = std::max(out, distance(run_->fleet().pose(one).position, run_->fleet().pose(other).position));
    }
    EXPECT_EQ(run_->state().outcome, mission::Outcome::kDone) << told_;
    return out;
  };
  EXPECT_GT(longest(""), 200.0);
  EXPECT_LT(longest("SET COHESION 10\n"), 100.0);
}

TEST_F(Planned, WhatNobodyKnewOfIsRemembered) {
  make({}, "plans_ways = true", 1, "Column", bow());
  EXPECT_TRUE(go()) << told_;
  EXPECT_EQ(contacts(), 0U);
}

// Whoever took it for something that stands there would have seen the gap closed, after a while.
TEST_F(Planned, AGapIsNotClosedByWhatMovesInIt) {
  std::vector<Rock> rocks;
  for (int i = 0; i < 6; ++i) {
    rocks.push_back({{300.0, 174.0 - 36.0 * i}, 20.0});
    rocks.push_back({{300.0, 226.0 + 36.0 * i}, 20.0});
  }
  const overlay::ObstacleDisc moving = {.center = {300.0, 196.5},
                                        .radius = 2.5,
                                        .height = 0.0,
                                        .place = {},
                                        .route = {{300.0, 203.5}},
                                        .speed = 1.0};
  make(rocks, "plans_ways = true", 3, "Column", {}, {moving});
  EXPECT_TRUE(go()) << told_;
  EXPECT_EQ(told_.find("no way"), std::string::npos) << told_;
  EXPECT_EQ(contacts(), 0U);
}

// Things of 1 to 3 m radius that cross the way at 1 to 3 m/s, there and back and round and round.
std::vector<overlay::ObstacleDisc> traffic(std::uint64_t seed) {
  base::Random random(seed);
  const auto place = [&] { return geom::Point{random.uniform(200.0, 400.0), random.uniform(80.0, 320.0)}; };
  std::vector<overlay::ObstacleDisc> out;
  for (int i = 0; i < 8; ++i) {
    overlay::ObstacleDisc& one = out.emplace_back();
    one.center = place();
    one.radius = random.uniform(1.0, 3.0);
    one.speed = random.uniform(1.0, 3.0);
    one.route = {place()};
    if (i % 2 == 0) one.route = {one.route[0], place(), one.center};
  }
  return out;
}

TEST_F(Planned, EverybodyPassesThroughTrafficAndMeetsNothing) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    make({}, "plans_ways = true, formation_spacing = 10", 5, "Wedge", {}, traffic(seed));
    EXPECT_TRUE(go()) << seed << "\n" << told_;
    EXPECT_EQ(contacts(), 0U) << seed;
    EXPECT_EQ(run_->world().moving_discs().size(), 8U);
  }
  unsigned met = 0;  // by those who don't see it
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    make({}, "plans_ways = true, formation_spacing = 10, detect_obs_range = 0", 5, "Wedge", {},
         traffic(seed));
    go();
    met += contacts();
  }
  EXPECT_GT(met, 0U);
}

// Rocks close a pass, and one of them is cleared away.
TEST_F(Planned, WhatIsGoneIsForgotten) {
  cleared_ = {300.0, 45.0};
  make_run(
      "MISSION-AREA 600 60\nUNIT <team> ROBOT ROBOT\nCOMMAND LIST:\n0. UNIT team START 150 25 0 10\n"
      "1. UNIT team MOVETO 450 30 FORMATION Column\n",
      {{{300.0, 15.0}, 16.0}, {{300.0, 45.0}, 16.0}});
  EXPECT_FALSE(go(500));
  EXPECT_NE(told_.find("no way to (450, 30) is known"), std::string::npos) << told_;
  EXPECT_TRUE(go()) << told_;
  EXPECT_EQ(contacts(), 0U);
}

TEST_F(Planned, AFormationGoesRoundAndOpensAgain) {
  for (const char* formation : {"Column", "Line", "Wedge", "Diamond", "No-Formation", "Sweep"}) {
    make(bow(), "plans_ways = true, formation_spacing = 20", 4, formation);
    EXPECT_TRUE(go()) << formation << "\n" << told_;
    EXPECT_EQ(contacts(), 0U) << formation;
    const fleet::Group* const group = run_->fleet().group(run_->fleet().robots().front());
    ASSERT_NE(group, nullptr);
    EXPECT_LT(distance(group->center, {450.0, 200.0}), 10.0) << formation;
  }
}

TEST_F(Planned, AClosedOffGoalIsToldAtOnceWithWhatIsInFront) {
  std::vector<Rock> ring;
  for (int i = 0; i < 24; ++i) {
    const double angle = 2.0 * std::numbers::pi / 24.0 * i;
    ring.push_back({{450.0 + 60.0 * std::cos(angle), 200.0 + 60.0 * std::sin(angle)}, 8.0});
  }
  make(ring, "plans_ways = true", 2);
  EXPECT_FALSE(go(50));
  EXPECT_NE(told_.find("no way to (450, 200) is known: an obstacle of radius 8.0 m at (39"),
            std::string::npos)
      << told_;
  EXPECT_FALSE(go()) << "nobody gets in";
  EXPECT_EQ(contacts(), 0U);
  EXPECT_LT(distance(run_->fleet().pose(run_->fleet().robots().front()).position, {450.0, 200.0}), 110.0)
      << "as near as they can";
}

TEST_F(Planned, AGoalThatSomethingStandsOnIsReachedBesideIt) {
  make({{{450.0, 204.0}, 20.0}}, "plans_ways = true");
  EXPECT_TRUE(go()) << told_;
  EXPECT_NE(told_.find("something stands at (450, 200)"), std::string::npos) << told_;
}

TEST_F(Planned, ACheckpointKeepsWhatWasSensed) {
  make({}, "plans_ways = true", 3, "Wedge", bow());
  go(400);
  const auto kept = run_->save();
  ASSERT_TRUE(kept) << kept.error();
  const auto places = [&] {
    std::vector<geom::Point> out;
    for (const fleet::FleetRobot& robot : run_->fleet().robots())
      out.push_back(run_->fleet().pose(robot).position);
    return out;
  };
  go(600);
  const std::vector<geom::Point> first = places();
  EXPECT_EQ(run_->restore(*kept), std::nullopt);
  go(600);
  EXPECT_EQ(places(), first);
}

}  // namespace
}  // namespace mlab
