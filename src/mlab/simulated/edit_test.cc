#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/run/mission_run.h"
#include "mlab/simulated/run.h"

namespace mlab::run {
namespace {

using mission::UnitCommand;

// Two standard robots that are told to go 200 m to the east.
std::shared_ptr<mission::Mission> two_robots() {
  auto out = std::make_shared<mission::Mission>();
  out->types.push_back({"ROBOT", "robot", "blue", "", {}, {}});
  out->robots = {{{1}, 0, {}}, {{2}, 0, {}}};
  out->units.push_back({"pair", {{1}, {2}}, {}, {}});
  UnitCommand start;
  start.task = mission::Task::kStart;
  start.goal = {100.0, 100.0};
  start.start_step = {0.0, 50.0};
  UnitCommand go;
  go.goal = {300.0, 125.0};
  go.place_name = "300 125";
  out->steps.push_back({"0", {start}, {}});
  out->steps.push_back({"1", {go}, {}});
  return out;
}

std::unique_ptr<MissionRun> running(const std::shared_ptr<const mission::Mission>& mission) {
  text::Diagnostics sink;
  auto run = simulated::make_run(mission, {}, {}, sink);
  EXPECT_NE(run, nullptr) << text::render(sink);
  run->post(mission::event::Execute{});
  for (int i = 0; i < 50; ++i) run->step();
  return run;
}

void edit(MissionRun& run, const std::shared_ptr<const mission::Mission>& mission) {
  text::Diagnostics sink;
  const auto crew = make_crew(mission, {}, sink);
  ASSERT_NE(crew, nullptr) << text::render(sink);
  run.edit(crew);
}

double x_of(const MissionRun& run, std::uint32_t id) {
  return run.fleet().pose(*run.fleet().find({id})).position.x;
}

TEST(EmergencyStop, LetsEveryRobotStandFromTheNextCycleOn) {
  const auto run = running(two_robots());
  run->set_emergency_stop(true);
  EXPECT_EQ(run->step(), MissionRun::Progress::kStepped) << "bodies brake";
  EXPECT_EQ(run->state().time, run->time()) << "no command is late by it";
  const double x = x_of(*run, 1);
  const double time = run->time();
  for (int i = 0; i < 20; ++i) EXPECT_EQ(run->step(), MissionRun::Progress::kWaits);
  EXPECT_EQ(x_of(*run, 1), x);
  EXPECT_EQ(run->time(), time) << "nothing moves, so no time passes";
  run->post(mission::event::Execute{});
  run->step();
  EXPECT_EQ(x_of(*run, 1), x) << "an order does not end it";
  run->set_emergency_stop(false);
  for (int i = 0; i < 20; ++i) run->step();
  EXPECT_GT(x_of(*run, 1), x + 1.0);
}

TEST(Edit, ARobotThatIsAddedCanBeStartedAndTheOthersGoOn) {
  const auto run = running(two_robots());
  const double x = x_of(*run, 2);
  auto more = two_robots();
  more->robots.push_back({{3}, 0, {}});
  more->units.push_back({"third", {{3}}, {}, {}});
  edit(*run, more);
  ASSERT_EQ(run->fleet().robots().size(), 3U);
  EXPECT_EQ(x_of(*run, 2), x);
  run->step();
  EXPECT_GT(x_of(*run, 2), x) << "its order still stands";
  UnitCommand start;
  start.unit = 1;
  start.task = mission::Task::kStart;
  start.goal = {10.0, 20.0};
  run->post(mission::event::Typed{{start}});
  for (int i = 0; i < 5; ++i) run->step();
  EXPECT_EQ(run->fleet().find({3})->life, fleet::RobotLife::kRunning);
}

std::vector<std::uint32_t> mates_of(const MissionRun& run, std::uint32_t id) {
  const percept::Percepts percepts =
      run.world().sense(run.fleet().find({id})->body, {{percept::Sensor::kRobots, 1000.0}});
  std::vector<std::uint32_t> out;
  for (const percept::RobotReading& robot : percepts.robots) {
    if (robot.is_unit_mate) out.push_back(robot.id.value);
  }
  std::ranges::sort(out);
  return out;
}

TEST(UnitMates, AreTheRobotsOfTheOutermostUnitWhateverEachOfThemIsToldToDo) {
  auto mission = two_robots();
  mission->robots.push_back({{3}, 0, {}});
  mission->units.push_back({"third", {{3}}, {}, {}});
  mission->units.push_back({"all", {{1}, {2}}, {0}, {}});
  UnitCommand other;
  other.unit = 1;
  other.task = mission::Task::kStart;
  other.goal = {100.0, 200.0};
  mission->steps[0].commands.emplace_back(other);
  const auto run = running(mission);
  EXPECT_EQ(mates_of(*run, 1), (std::vector<std::uint32_t>{2}));
  EXPECT_EQ(mates_of(*run, 3), std::vector<std::uint32_t>{});
  UnitCommand alone;
  alone.unit = mission::kNoUnit;
  alone.robots = {{1}};
  alone.goal = {500.0, 100.0};
  run->post(mission::event::Typed{{alone}});
  for (int i = 0; i < 5; ++i) run->step();
  EXPECT_EQ(mates_of(*run, 1), (std::vector<std::uint32_t>{2})) << "under an order of its own";
  auto joined = std::make_shared<mission::Mission>(*mission);
  joined->units.push_back({"everybody", {{1}, {2}, {3}}, {1, 2}, {}});
  edit(*run, joined);
  EXPECT_EQ(mates_of(*run, 3), (std::vector<std::uint32_t>{1, 2}));
}

TEST(Edit, ARobotThatIsTakenOutOfThePlanStaysInTheWorld) {
  const auto run = running(two_robots());
  auto fewer = two_robots();
  fewer->robots.erase(fewer->robots.begin());
  fewer->units[0].members.erase(fewer->units[0].members.begin());
  edit(*run, fewer);
  ASSERT_NE(run->fleet().find({1}), nullptr);
  EXPECT_EQ(run->fleet().find({1})->life, fleet::RobotLife::kRunning);
  run->step();
}

TEST(Edit, ChangesOfParametersReachRobotsThatAreUnderWay) {
  text::Diagnostics sink;
  const auto crew = make_crew(two_robots(), {}, sink);
  const auto simulated = simulated::make_run(crew, {});
  MissionRun& run = *simulated;
  run.post(mission::event::Execute{});
  for (int i = 0; i < 5; ++i) run.step();
  auto slow = two_robots();
  slow->types[0].parameters.push_back({"base_velocity", "0.5", {}, {}});
  const auto slow_crew = make_crew(slow, {}, sink, crew.get());
  ASSERT_NE(slow_crew, nullptr);
  EXPECT_EQ(slow_crew->programs[0].program, crew->programs[0].program) << "not built again";
  run.edit(slow_crew);
  const fleet::FleetRobot& robot = *run.fleet().find({1});
  const flow::Program& program = *robot.workings().program;
  EXPECT_EQ(flow::Program::number(robot.workings().frame, *program.find("base_velocity")), 0.5);
  EXPECT_EQ(flow::Program::number(robot.workings().frame, *program.find("max_velocity")), 7.0);
}

TEST(Edit, ObstaclesComeAndGoWithTheOverlay) {
  const auto mission = two_robots();
  mission->overlay.obstacles.push_back({{500.0, 500.0}, 3.0, 0.0, {}});
  const auto run = running(mission);
  ASSERT_EQ(run->world().discs().size(), 1U);
  auto other = two_robots();
  other->overlay.obstacles.push_back({{400.0, 500.0}, 3.0, 0.0, {}});
  other->overlay.obstacles.push_back({{600.0, 500.0}, 4.0, 0.0, {}});
  edit(*run, other);
  ASSERT_EQ(run->world().discs().size(), 2U);
  for (const binding::Disc& disc : run->world().discs()) EXPECT_NE(disc.center.x, 500.0);
}

TEST(Edit, WallsAndObjectsComeAndGoWithTheOverlay) {
  const auto mission = two_robots();
  mission->overlay.objects.push_back({{20.0, 30.0}, 0.5, overlay::ObjectStyle::kMovable, "orange", {}});
  const auto run = running(mission);
  const auto other = two_robots();
  overlay::ControlMeasure wall;
  wall.kind = overlay::MeasureKind::kWall;
  wall.points = {{200.0, 0.0}, {200.0, 1000.0}};
  other->overlay.measures.push_back(wall);
  other->overlay.objects.push_back({{40.0, 30.0}, 0.5, overlay::ObjectStyle::kFixed, "white", {}});
  other->overlay.objects.push_back(mission->overlay.objects[0]);
  edit(*run, other);
  EXPECT_EQ(run->world().walls().size(), 1U);
  ASSERT_EQ(run->world().objects().size(), 2U);
  EXPECT_EQ(run->world().objects()[1].center, (geom::Point{20.0, 30.0}));
  for (int i = 0; i < 600; ++i) run->step();
  EXPECT_LT(x_of(*run, 1), 200.0) << "nobody gets past the new wall";
  edit(*run, two_robots());
  EXPECT_TRUE(run->world().walls().empty());
  EXPECT_TRUE(run->world().objects().empty());
}

// Three of missions/forage, who bring what lies about to a basket.
std::shared_ptr<mission::Mission> foragers() {
  auto out = std::make_shared<mission::Mission>();
  out->types.push_back({"forager", "forager.cdl", "blue", "", {}, {}});
  out->robots = {{{1}, 0, {}}, {{2}, 0, {}}, {{3}, 0, {}}};
  out->units.push_back({"foragers", {{1}, {2}, {3}}, {}, {}});
  UnitCommand start;
  start.task = mission::Task::kStart;
  start.goal = {20.0, 12.0};
  start.start_step = {2.0, 0.0};
  UnitCommand go;
  go.goal = {20.0, 12.0};
  go.place_name = "20 12";
  out->steps.push_back({"0", {start}, {}});
  out->steps.push_back({"1", {go}, {}});
  for (const geom::Point place : {geom::Point{9, 25}, {14, 8}, {5, 14}, {25, 4}, {29, 22}, {33, 9}})
    out->overlay.objects.push_back({place, 0.2, overlay::ObjectStyle::kMovable, "orange", {}});
  out->overlay.objects.push_back({{20, 15}, 0.6, overlay::ObjectStyle::kContainer, "green", {}});
  return out;
}

TEST(Edit, WhoCarriedAnObjectHasNotDeliveredTheOneThatHasItsNumberNow) {
  robot::ProgramSources sources;
  sources.folder = base::source_folder() + "/missions/forage";
  const auto mission = foragers();
  text::Diagnostics sink;
  const auto run = simulated::make_run(mission, sources, {}, sink);
  ASSERT_NE(run, nullptr) << text::render(sink);
  run->post(mission::event::Execute{});
  const auto place_of = [&](bool is_it(const binding::Object&)) {
    const auto objects = run->world().objects();
    return static_cast<std::size_t>(std::ranges::find_if(objects, is_it) - objects.begin());
  };
  const auto carried = [](const binding::Object& one) { return one.carrier.value != 0; };
  const auto delivered = [](const binding::Object& one) { return one.basket.value != 0; };
  const std::size_t none = mission->overlay.objects.size();
  for (int i = 0; i < 6000 && (place_of(carried) == none || place_of(delivered) == none); ++i) run->step();
  ASSERT_LT(std::max(place_of(carried), place_of(delivered)), none);
  const std::size_t deliveries = run->deliveries().size();
  EXPECT_GT(deliveries, 0U);
  auto other = std::make_shared<mission::Mission>(*mission);
  std::swap(other->overlay.objects[place_of(carried)], other->overlay.objects[place_of(delivered)]);
  const auto crew = make_crew(other, sources, sink);
  ASSERT_NE(crew, nullptr) << text::render(sink);
  run->edit(crew);
  run->step();
  EXPECT_EQ(run->deliveries().size(), deliveries);
}

TEST(SetParameter, ChangesOneRobotAndOutlivesItsStart) {
  const auto run = running(two_robots());
  EXPECT_TRUE(run->set_parameter({1}, "base_velocity", "fast").has_value());
  EXPECT_TRUE(run->set_parameter({9}, "base_velocity", "1").has_value());
  EXPECT_FALSE(run->set_parameter({1}, "base_velocity", "0.25").has_value());
  const double x1 = x_of(*run, 1);
  const double x2 = x_of(*run, 2);
  for (int i = 0; i < 50; ++i) run->step();
  EXPECT_LT(x_of(*run, 1) - x1, x_of(*run, 2) - x2);
  run->post(mission::event::Abort{});
  run->post(mission::event::Execute{});
  run->step();
  const fleet::FleetRobot& robot = *run->fleet().find({1});
  const flow::Program& program = *robot.workings().program;
  EXPECT_EQ(flow::Program::number(robot.workings().frame, *program.find("base_velocity")), 0.25);
}

}  // namespace
}  // namespace mlab::run
