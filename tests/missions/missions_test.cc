// Every mission of the project arrives, with twenty seeds unless its expected.json names fewer, without a
// contact, as that file says.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "fleet_of_threads.h"
#include "mlab/base/testing/source_folder.h"
#include "mlab/cell/testing/permission.h"
#include "mlab/history/replay.h"
#include "mlab/history/testing/written_run.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/robot/program/configuration_file.h"
#include "mlab/run/mission_run.h"
#include "mlab/run/report.h"
#include "mlab/simulated/run.h"
#include "two_agents.h"

namespace mlab {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::uint64_t kSeeds = 20;
const fs::path kMissions = fs::path(base::source_folder()) / "missions";
const fs::path kCorpus = fs::path(base::source_folder()) / ".." / "shared" / "corpus" / "missions";

// Where robots' programs are computed.
enum class Home { kRun, kOwnProcesses, kAgents, kFleet, kLossyFleet };

// With the standard clock, all questions answered with yes.
std::unique_ptr<run::MissionRun> prepare(const fs::path& file, std::uint64_t seed, int threads,
                                         Home home = Home::kRun) {
  text::Diagnostics sink;
  robot::ProgramSources sources = {cell::testing::code_permitted(), file.parent_path().string()};
  sources.in_own_processes = home == Home::kOwnProcesses;
  mdl::LoadOptions options;
  options.seed = seed;
  options.societies = robot::society_reader(sources);
  const auto mission = mdl::load_mission(file.string(), sink, options);
  if (!mission) {
    ADD_FAILURE() << text::render(sink);
    return nullptr;
  }
  run::RunSettings settings;
  settings.seed = seed;
  settings.threads = threads;
  settings.executive.proceed_all = true;
  if (home == Home::kAgents)
    settings.robots_elsewhere = [](std::uint64_t seed_of_run, double /*cycle_duration*/) {
      return testing::two_agents(seed_of_run);
    };
  if (home == Home::kFleet)
    settings.robots_elsewhere = [](std::uint64_t seed_of_run, double /*cycle_duration*/) {
      return testing::FleetOfThreads::shared().make_runner(seed_of_run);
    };
  if (home == Home::kLossyFleet)
    settings.robots_elsewhere = [](std::uint64_t seed_of_run, double /*cycle_duration*/) {
      return testing::FleetOfThreads::shared_and_lossy().make_runner(seed_of_run);
    };
  auto run = simulated::make_run(mission, sources, settings, sink);
  EXPECT_TRUE(run) << text::render(sink);
  return run;
}

void carry_out(run::MissionRun& run, double most_seconds) {
  run.post(mission::event::Execute{});
  while (run.time() < most_seconds && run.step() == run::MissionRun::Progress::kStepped) {
  }
}

Json read_json(const fs::path& file) {
  std::ifstream stream(file);
  return Json::parse(stream, nullptr, false);
}

geom::Point center_of(const run::MissionRun& run, const std::string& unit_name) {
  geom::Offset sum;
  std::size_t count = 0;
  for (const mission::Unit& unit : run.mission().units) {
    if (unit.name != unit_name) continue;
    for (const base::RobotId id : unit.members) {
      sum = sum + (run.fleet().pose(*run.fleet().find(id)).position - geom::Point{});
      ++count;
    }
  }
  return geom::Point{} + sum * (1.0 / static_cast<double>(count));
}

class Mission : public ::testing::TestWithParam<std::string> {};

TEST_P(Mission, ArrivesWithAnySeedWithoutAContact) {
  const fs::path folder = kMissions / GetParam();
  const Json expected = read_json(folder / "expected.json");
  ASSERT_TRUE(expected.is_object()) << "no readable expected.json in " << folder;
  for (std::uint64_t seed = 1; seed <= expected.value("seeds", kSeeds); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto run = prepare(folder / (GetParam() + ".mdl"), seed, 1);
    ASSERT_TRUE(run);
    carry_out(*run, expected["at_most_s"]);
    EXPECT_EQ(run::outcome_name(*run, run::RunEnd::kInterrupted), expected["outcome"].get<std::string>());
    EXPECT_EQ(run->state().steps.size(), expected["steps"].get<std::size_t>());
    for (const fleet::FleetRobot& robot : run->fleet().robots()) {
      ASSERT_NE(robot.life, fleet::RobotLife::kNotStarted);
      EXPECT_EQ(run->world().body(robot.body).contacts, 0U) << "robot " << robot.id.value;
      EXPECT_EQ(run->world().body(robot.body).run_over, 0U) << "robot " << robot.id.value;
    }
    EXPECT_EQ(run->deliveries().size(), expected.value("deliveries", std::size_t{0}));
    for (const auto& [unit, place] : expected["units_end"].items()) {
      const geom::Point center = center_of(*run, unit);
      const geom::Point wanted{place["x_m"], place["y_m"]};
      EXPECT_LE(geom::distance(center, wanted), place["within_m"])
          << unit << " at " << center.x << ", " << center.y;
    }
  }
}

TEST_P(Mission, GivesTheSameReportForAnyNumberOfThreads) {
  const auto report_with = [&](int threads) {
    const auto run = prepare(kMissions / GetParam() / (GetParam() + ".mdl"), 7, threads);
    carry_out(*run, 3600.0);
    Json report = Json::parse(run::report_json(*run, {}, run::RunEnd::kByItself));
    report.erase("performance");
    return report.dump();
  };
  const std::string one = report_with(1);
  EXPECT_EQ(one, report_with(1));
  EXPECT_EQ(one, report_with(2));
  EXPECT_EQ(one, report_with(8));
}

// Another run, out of what was written of the first one.
TEST_P(Mission, IsComputedAgainFromItsHistory) {
  history::testing::WrittenRun written(GetParam() + "/" + GetParam() + ".mdl", 3, true);
  written.run().post(mission::event::Execute{});
  while (written.run().time() < 600.0 && written.step()) {
  }
  written.end();
  text::Diagnostics sink;
  const auto replay = history::Replay::make(written.history(), {cell::testing::code_permitted()}, sink);
  ASSERT_NE(replay, nullptr) << text::render(sink);
  std::size_t cycles = 0;
  while (replay->step()) {
    ASSERT_EQ(history::testing::all_of(replay->run()), written.values()[cycles]) << "cycle " << cycles + 1;
    ++cycles;
  }
  ASSERT_FALSE(replay->divergence()) << replay->divergence()->cycle << ": " << replay->divergence()->why;
  EXPECT_EQ(cycles, written.values().size());
  EXPECT_GT(cycles, 100U);
}

std::string report_with(const std::string& mission, Home home, double most_seconds = 3600.0) {
  const auto run = prepare(kMissions / mission / (mission + ".mdl"), 7, 2, home);
  carry_out(*run, most_seconds);
  Json report = Json::parse(run::report_json(*run, {}, run::RunEnd::kByItself));
  report.erase("performance");
  return report.dump();
}

TEST_P(Mission, GivesTheSameReportWhereverItsRobotsAre) {
  const std::string embedded = report_with(GetParam(), Home::kRun);
  EXPECT_EQ(embedded, report_with(GetParam(), Home::kOwnProcesses));
  EXPECT_EQ(embedded, report_with(GetParam(), Home::kAgents));
  EXPECT_EQ(embedded, report_with(GetParam(), Home::kFleet));
}

// Whole missions where somebody wants to wait for them: each packet that is lost costs milliseconds.
TEST_P(Mission, GivesTheSameReportThoughEveryFifthPacketIsLost) {
  // NOLINTNEXTLINE(concurrency-mt-unsafe): nothing sets variables
  const double most_seconds = std::getenv("MLAB_WHOLE_LOSSY_MISSIONS") != nullptr ? 3600.0 : 5.0;
  EXPECT_EQ(report_with(GetParam(), Home::kRun, most_seconds),
            report_with(GetParam(), Home::kLossyFleet, most_seconds));
}

// In the order of the alphabet.
const std::string kAllMissions[] = {
    "crossing",     "demo_c",    "forage", "formation_study", "formations",   "gap",
    "herd",         "minefield", "mrv2",   "out_of_reach",    "patrol",       "rally",
    "random_field", "robot_lab", "rover",  "search",          "split_rejoin", "squeeze",
    "survey",       "ugv",       "visit",  "watch",           "worlds"};

INSTANTIATE_TEST_SUITE_P(OfTheProject, Mission, ::testing::ValuesIn(kAllMissions),
                         [](const auto& test) { return test.param; });

TEST(Missions, EveryFolderIsTried) {
  std::vector<std::string> folders;
  for (const auto& entry : fs::directory_iterator(kMissions)) {
    if (entry.is_directory()) folders.push_back(entry.path().filename().string());
  }
  std::sort(folders.begin(), folders.end());
  EXPECT_EQ(folders, std::vector<std::string>(std::begin(kAllMissions), std::end(kAllMissions)));
}

// What the foragers that are after an attractor go for, by object.
std::map<std::uint32_t, int> targets_of(const run::MissionRun& run) {
  std::map<std::uint32_t, int> out;
  for (const fleet::FleetRobot& robot : run.fleet().robots()) {
    const flow::Program& program = *robot.workings().program;
    const flow::Port* const port = program.find("movement.target");
    if (port == nullptr || robot.life != fleet::RobotLife::kRunning) continue;
    const std::vector<std::string> states = program.active_states(robot.workings().frame);
    if (std::ranges::find(states, "movement.Acquiring") == states.end()) continue;
    percept::ObjectReading target;
    std::memcpy(&target, robot.workings().frame + port->offset, sizeof target);
    if (target.id.value != 0) ++out[target.id.value];
  }
  return out;
}

TEST(Forage, NoTwoRobotsGoForTheSameAttractorForLongerThanACycle) {
  int cycles_with_target = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto run = prepare(kMissions / "forage" / "forage.mdl", seed, 1);
    ASSERT_TRUE(run);
    run->post(mission::event::Execute{});
    std::map<std::uint32_t, int> shared_for;  // by object [cycles]
    while (run->time() < 300.0 && run->step() == run::MissionRun::Progress::kStepped) {
      const std::map<std::uint32_t, int> targets = targets_of(*run);
      cycles_with_target += targets.empty() ? 0 : 1;
      std::erase_if(shared_for, [&](const auto& one) {
        const auto at = targets.find(one.first);
        return at == targets.end() || at->second < 2;
      });
      for (const auto& [object, robots] : targets) {
        if (robots < 2) continue;
        ASSERT_LE(++shared_for[object], 1) << "object " << object << " at " << run->time() << " s";
      }
    }
  }
  EXPECT_GT(cycles_with_target, 1000);
}

// Whoever is inside sees the corners go once around.
bool is_inside(const std::vector<geom::Point>& corners, geom::Point at) {
  double turned = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const geom::Offset a = corners[i] - at;
    const geom::Offset b = corners[(i + 1) % corners.size()] - at;
    turned += std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
  }
  return std::abs(turned) > 1.0;
}

TEST(Minefield, NoRobotIsEverInside) {
  const auto run = prepare(kMissions / "minefield" / "minefield.mdl", 1, 1);
  ASSERT_TRUE(run);
  const overlay::ControlMeasure* outline = overlay::find_measure(run->mission().overlay, "Old Road");
  const overlay::ControlMeasure* round = overlay::find_measure(run->mission().overlay, "MINEFIELD-Crossing");
  ASSERT_TRUE(outline && round);
  ASSERT_TRUE(is_inside(outline->points, outline->center()));
  double nearest = std::numeric_limits<double>::infinity();
  run->post(mission::event::Execute{});
  while (run->time() < 900.0 && run->step() == run::MissionRun::Progress::kStepped) {
    for (const fleet::FleetRobot& robot : run->fleet().robots()) {
      if (robot.life == fleet::RobotLife::kNotStarted) continue;
      const geom::Point at = run->fleet().pose(robot).position;
      ASSERT_FALSE(is_inside(outline->points, at))
          << "robot " << robot.id.value << " at " << run->time() << " s";
      ASSERT_GT(geom::distance(at, round->center()), round->size / 2.0);
      nearest = std::min(nearest, geom::distance(at, outline->center()));
    }
  }
  EXPECT_LT(nearest, 100.0) << "it lies on the way";
}

TEST(Rally, IsDoneWhenAllAreThereAndFromThenOnTheyAreAUnitAgain) {
  const auto run = prepare(kMissions / "rally" / "rally.mdl", 1, 1);
  ASSERT_TRUE(run);
  const overlay::ControlMeasure* place = overlay::find_measure(run->mission().overlay, "OBJ-Tango");
  ASSERT_NE(place, nullptr);
  std::set<std::size_t> sizes;
  double at_rally = 0.0;
  run->set_observer([&](const mission::Effect& effect) {
    if (const auto* order = std::get_if<mission::effect::Order>(&effect)) sizes.insert(order->members.size());
    const auto* told = std::get_if<mission::effect::Tell>(&effect);
    if (told == nullptr || told->kind != mission::effect::Tell::Kind::kCommandEnded) return;
    if (told->text.find("RALLY") == std::string::npos) return;
    EXPECT_EQ(sizes, (std::set<std::size_t>{1, 3})) << "in line together, then each by itself";
    sizes.clear();
    at_rally = run->time();
    for (const fleet::FleetRobot& robot : run->fleet().robots())
      EXPECT_LE(geom::distance(run->fleet().pose(robot).position, place->center()), place->size / 2.0);
  });
  carry_out(*run, 900.0);
  EXPECT_GT(at_rally, 0.0);
  EXPECT_EQ(sizes, std::set<std::size_t>{3});
}

TEST(Herd, RunsFromTheWolfAndKeepsTogether) {
  const auto run = prepare(kMissions / "herd" / "herd.mdl", 1, 1);
  ASSERT_TRUE(run);
  const fleet::FleetRobot* wolf = run->fleet().find({5});
  ASSERT_NE(wolf, nullptr);
  std::set<std::string> seen;
  double nearest = std::numeric_limits<double>::infinity();
  run->post(mission::event::Execute{});
  while (run->time() < 900.0 && run->step() == run::MissionRun::Progress::kStepped) {
    for (const fleet::FleetRobot& robot : run->fleet().robots()) {
      if (robot.id == wolf->id || robot.life != fleet::RobotLife::kRunning) continue;
      const robot::Workings workings = robot.workings();
      for (const std::string& state : workings.program->active_states(workings.frame)) seen.insert(state);
      if (wolf->life == fleet::RobotLife::kRunning)
        nearest = std::min(
            nearest, geom::distance(run->fleet().pose(robot).position, run->fleet().pose(*wolf).position));
    }
  }
  EXPECT_EQ(seen, (std::set<std::string>{"movement.Fleeing", "movement.Grazing"}));
  EXPECT_LT(nearest, 20.0) << "they let it come so near";
  EXPECT_GT(nearest, 8.0) << "and no nearer";
  const geom::Point center = center_of(*run, "herd");
  for (std::uint32_t id = 1; id <= 4; ++id)
    EXPECT_LT(geom::distance(run->fleet().pose(*run->fleet().find({id})).position, center), 40.0);
}

TEST(DemoC, RunsItsStepsInTheOrderOfTheReport) {
  const auto run = prepare(kMissions / "demo_c" / "demo_c.mdl", 1, 1);
  std::vector<std::string> asked;
  run->set_observer([&](const mission::Effect& effect) {
    const auto* told = std::get_if<mission::effect::Tell>(&effect);
    if (told != nullptr && told->kind == mission::effect::Tell::Kind::kCommandStarted)
      asked.push_back(told->text);
  });
  carry_out(*run, 3600.0);
  ASSERT_EQ(asked.size(), 14U);
  EXPECT_EQ(asked[0], "step 0: unit scouts START AA-AA1");
  EXPECT_EQ(asked[3], "step 3: unit scouts OCCUPY ATK-AP1 (Diamond)");
  EXPECT_EQ(asked[7], "step 7: unit scouts-1 MOVETO ATK-BP1");
  EXPECT_EQ(asked[8], "step 7: unit scouts-2 MOVETO ATK-BP2");
  EXPECT_EQ(asked[13], "step 11: unit scouts STOP");
}

TEST(DemoC, DifferentSeedsGiveDifferentRuns) {
  const auto path_of = [&](std::uint64_t seed) {
    const auto run = prepare(kMissions / "demo_c" / "demo_c.mdl", seed, 1);
    carry_out(*run, 3600.0);
    return run->world().body(run->fleet().robots().front().body).distance_driven;
  };
  EXPECT_NE(path_of(1), path_of(2));
}

TEST(Checkpoint, ThereIsNoneOfRobotsThatAgentsCarry) {
  const auto run = prepare(kMissions / "demo_c" / "demo_c.mdl", 1, 1, Home::kAgents);
  ASSERT_TRUE(run);
  carry_out(*run, 1.0);
  const auto checkpoint = run->save();
  ASSERT_FALSE(checkpoint);
  EXPECT_EQ(checkpoint.error(), "robot 1: another machine carries it, and goes on with its program");
  const auto here = prepare(kMissions / "demo_c" / "demo_c.mdl", 1, 1);
  const auto of_here = here->save();
  ASSERT_TRUE(of_here) << of_here.error();
  EXPECT_EQ(run->restore(*of_here), "robots that are carried elsewhere can't be put back");
}

// The historic operator had to help these two by joystick. They arrive, or say where they are stuck and why.
TEST(HistoricMissions, ArriveOrSayWhereTheyAreStuck) {
  if (!fs::exists(kCorpus)) GTEST_SKIP() << "the historic files are not beside the project";
  for (const auto& entry : fs::directory_iterator(kCorpus)) {
    if (entry.path().extension() == ".ovl") continue;
    SCOPED_TRACE(entry.path().filename().string());
    const auto run = prepare(entry.path(), 1, 1);
    ASSERT_TRUE(run);
    std::string said;
    run->set_observer([&](const mission::Effect& effect) {
      if (const auto* told = std::get_if<mission::effect::Tell>(&effect)) said += told->text + "\n";
    });
    carry_out(*run, 20'000.0);
    const std::string outcome = run::outcome_name(*run, run::RunEnd::kInterrupted);
    if (outcome == "done") continue;
    EXPECT_EQ(outcome, "failed");
    EXPECT_NE(said.find("no progress"), std::string::npos) << said;
    EXPECT_NE(said.find("from_obstacles"), std::string::npos) << "what holds the robots is said";
  }
}

}  // namespace
}  // namespace mlab
