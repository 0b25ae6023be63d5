// What people make robots' programs do, in a run: from the next cycle on, told in the report, and gone when
// released.

#include <algorithm>
#include <memory>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "mlab/run/report.h"
#include "mlab/simulated/run.h"
#include "mlab/simulated/testing/values.h"

namespace mlab::run {
namespace {

// Two standard robots that travel.
std::unique_ptr<MissionRun> travelling(int threads = 1) {
  auto mission = std::make_shared<mission::Mission>();
  mission->types.push_back({"ROBOT", "robot", "blue", "", {}, {}});
  mission->robots = {{{1}, 0, {}}, {{2}, 0, {}}};
  mission->units.push_back({"pair", {{1}, {2}}, {}, {}});
  mission::UnitCommand start;
  start.task = mission::Task::kStart;
  start.goal = {100.0, 100.0};
  start.start_step = {0.0, 40.0};
  mission::UnitCommand go;
  go.goal = {700.0, 120.0};
  go.place_name = "700 120";
  mission->steps.push_back({"0", {start}, {}});
  mission->steps.push_back({"1", {go}, {}});
  RunSettings settings;
  settings.threads = threads;
  text::Diagnostics sink;
  auto run = simulated::make_run(mission, {}, settings, sink);
  EXPECT_NE(run, nullptr) << text::render(sink);
  run->post(mission::event::Execute{});
  for (int i = 0; i < 50; ++i) run->step();
  return run;
}

const fleet::FleetRobot& robot_of(const MissionRun& run, std::uint32_t id) {
  return *run.fleet().find({id});
}

// A vector that moves the robot.
std::string driven_port(const MissionRun& run) {
  const robot::Workings with = robot_of(run, 1).workings();
  const auto& ports = with.program->ports();
  const auto moves = std::ranges::find_if(ports, [&](const flow::Port& port) {
    return port.role == flow::Port::Role::kOutput && port.type->kind == flow::TypeKind::kVector &&
           flow::Program::vector(with.frame, port) != geom::Vector{};
  });
  EXPECT_NE(moves, ports.end());
  return moves->path;
}

bool are_alike(const MissionRun& a, const MissionRun& b) {
  for (const std::uint32_t id : {1U, 2U}) {
    const fleet::FleetRobot& mine = robot_of(a, id);
    const fleet::FleetRobot& theirs = robot_of(b, id);
    if (a.fleet().pose(mine) != b.fleet().pose(theirs)) return false;
    if (simulated::testing::values_of(mine) != simulated::testing::values_of(theirs)) return false;
  }
  return true;
}

TEST(Interventions, LeaveOtherRobotsAndRunsWithoutThemAlone) {
  const auto held = travelling();
  const auto free = travelling();
  ASSERT_TRUE(are_alike(*held, *free));
  const std::string port = driven_port(*held);
  ASSERT_EQ(held->hold_value({1}, port, "{0.5, 0.5}"), std::nullopt);
  held->step();
  free->step();
  const robot::Workings with = robot_of(*held, 1).workings();
  EXPECT_EQ(flow::Program::vector(with.frame, *with.program->find(port)), (geom::Vector{0.5, 0.5, 0.0}));
  // Later it sees its mate go another way.
  EXPECT_EQ(held->fleet().pose(robot_of(*held, 2)), free->fleet().pose(robot_of(*free, 2)));
  ASSERT_EQ(held->release_value({1}, ""), std::nullopt);
  held->step();
  EXPECT_EQ(robot_of(*held, 1).workings().interventions, nullptr) << "nothing of it is left";
}

TEST(Interventions, AreTheSameForAnyNumberOfThreads) {
  const auto one = travelling(1);
  const auto four = travelling(4);
  for (const auto* run : {&one, &four}) {
    ASSERT_EQ((*run)->hold_value({2}, driven_port(**run), "{1, 0}"), std::nullopt);
    for (int i = 0; i < 40; ++i) (*run)->step();
  }
  EXPECT_TRUE(are_alike(*one, *four));
}

TEST(Interventions, AHeldValueOutlivesANewStart) {
  const auto run = travelling();
  const std::string port = driven_port(*run);
  ASSERT_EQ(run->hold_value({1}, port, "{0.5, 0}"), std::nullopt);
  const fleet::FleetRobot& one = robot_of(*run, 1);
  ASSERT_EQ(one.runner->start(one.member), std::nullopt);
  run->step();
  EXPECT_EQ(flow::Program::vector(one.workings().frame, *one.workings().program->find(port)),
            (geom::Vector{0.5, 0.0, 0.0}));
}

TEST(Interventions, StandInTheReportWhereThereWereAny) {
  const auto run = travelling();
  const auto report = [&] { return nlohmann::json::parse(report_json(*run, {}, RunEnd::kInterrupted)); };
  EXPECT_FALSE(report().contains("interventions"));
  const std::string port = driven_port(*run);
  EXPECT_NE(run->hold_value({1}, port, "nonsense"), std::nullopt);
  EXPECT_NE(run->hold_value({7}, port, "{1, 0}"), std::nullopt);
  EXPECT_NE(run->release_value({1}, port), std::nullopt);
  EXPECT_EQ(run->release_value({1}, ""), std::nullopt) << "all of none";
  EXPECT_FALSE(report().contains("interventions")) << "what is refused has not happened";
  ASSERT_EQ(run->hold_value({1}, port, "{1, 0}"), std::nullopt);
  run->step();
  ASSERT_EQ(run->release_value({1}, port), std::nullopt);
  const nlohmann::json told = report()["interventions"];
  ASSERT_EQ(told.size(), 2U);
  EXPECT_EQ(told[0]["kind"], "hold");
  EXPECT_EQ(told[0]["robot"], 1);
  EXPECT_EQ(told[0]["path"], port);
  EXPECT_EQ(told[0]["value"], "{1, 0}");
  EXPECT_EQ(told[1]["kind"], "release");
  EXPECT_EQ(told[1]["cycle"].get<int>(), told[0]["cycle"].get<int>() + 1);
}

}  // namespace
}  // namespace mlab::run
