// Robots that go on with other programs while a mission runs.

#include <algorithm>
#include <cstring>
#include <memory>
#include <random>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "mlab/robot/host/hosted_program.h"
#include "mlab/robot/program/robot_values.h"
#include "mlab/run/report.h"
#include "mlab/simulated/run.h"
#include "mlab/simulated/testing/values.h"

namespace mlab::run {
namespace {

std::shared_ptr<const Crew> crew_for(const std::shared_ptr<const mission::Mission>& mission) {
  text::Diagnostics sink;
  auto out = make_crew(mission, {}, sink);
  EXPECT_NE(out, nullptr) << text::render(sink);
  return out;
}

// Three standard robots that travel.
std::shared_ptr<const mission::Mission> three_travellers() {
  auto out = std::make_shared<mission::Mission>();
  out->types.push_back({"ROBOT", "robot", "blue", "", {}, {}});
  out->robots = {{{1}, 0, {}}, {{2}, 0, {}}, {{3}, 0, {}}};
  out->units.push_back({"trio", {{1}, {2}, {3}}, {}, {}});
  mission::UnitCommand start;
  start.task = mission::Task::kStart;
  start.goal = {100.0, 100.0};
  start.start_step = {0.0, 40.0};
  mission::UnitCommand go;
  go.goal = {700.0, 120.0};
  go.place_name = "700 120";
  out->steps.push_back({"0", {start}, {}});
  out->steps.push_back({"1", {go}, {}});
  return out;
}

std::unique_ptr<MissionRun> started(const std::shared_ptr<const mission::Mission>& mission) {
  auto out = simulated::make_run(crew_for(mission), {});
  out->post(mission::event::Execute{});
  return out;
}

void step_run(MissionRun& run, int cycles) {
  for (int i = 0; i < cycles; ++i) run.step();
}

bool have_same_values(const MissionRun& a, const MissionRun& b) {
  for (const fleet::FleetRobot& mine : a.fleet().robots()) {
    const fleet::FleetRobot& theirs = *b.fleet().find(mine.id);
    if (a.fleet().pose(mine) != b.fleet().pose(theirs)) return false;
    if (simulated::testing::values_of(mine) != simulated::testing::values_of(theirs)) return false;
  }
  return a.time() == b.time();
}

TEST(TakeOver, OfAnEqualProgramAtAnyCycleChangesNothingBitForBit) {
  const auto mission = three_travellers();
  std::mt19937 random(11);
  for (int round = 0; round < 5; ++round) {
    const auto with = started(mission);
    const auto without = started(mission);
    for (int swap = 0; swap < 3; ++swap) {
      const int cycles = static_cast<int>(random() % 60);
      step_run(*with, cycles);
      step_run(*without, cycles);
      const auto taken = with->take_over(crew_for(mission));
      ASSERT_TRUE(taken) << taken.error();
      EXPECT_TRUE(taken->restarts.empty()) << text_of(*taken);
      ASSERT_TRUE(have_same_values(*with, *without)) << "round " << round;
    }
    step_run(*with, 60);
    step_run(*without, 60);
    EXPECT_TRUE(have_same_values(*with, *without)) << "round " << round;
  }
}

TEST(TakeOver, StandsInTheReportAndIsTold) {
  const auto mission = three_travellers();
  const auto run = started(mission);
  std::string told;
  run->set_observer([&](const mission::Effect& effect) {
    if (const auto* tell = std::get_if<mission::effect::Tell>(&effect)) told = tell->text;
  });
  step_run(*run, 40);
  const auto report = [&] { return nlohmann::json::parse(report_json(*run, {}, RunEnd::kInterrupted)); };
  EXPECT_FALSE(report().contains("takeovers"));
  ASSERT_TRUE(run->take_over(crew_for(mission)));
  EXPECT_EQ(told, "robots 1-3 took over a change; nothing begins anew");
  const nlohmann::json all = report()["takeovers"];
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0]["cycle"], run->cycle());
  EXPECT_EQ(all[0]["robots"], (std::vector<int>{1, 2, 3}));
  EXPECT_TRUE(all[0]["restarts"].empty());
}

TEST(TakeOver, WhatPeopleSetAndHoldStays) {
  const auto mission = three_travellers();
  const auto run = started(mission);
  step_run(*run, 40);
  ASSERT_EQ(run->set_parameter({2}, "base_velocity", "0.3"), std::nullopt);
  const fleet::FleetRobot& two = *run->fleet().find({2});
  const auto& ports = two.workings().program->ports();
  const auto port = std::ranges::find_if(ports, [&](const flow::Port& one) {
    return one.role == flow::Port::Role::kOutput && one.type->kind == flow::TypeKind::kVector &&
           flow::Program::vector(two.workings().frame, one) != geom::Vector{};
  });
  ASSERT_NE(port, ports.end());
  const std::string held = port->path;
  ASSERT_EQ(run->hold_value({2}, held, "{0.5, 0}"), std::nullopt);
  ASSERT_TRUE(run->take_over(crew_for(mission)));
  step_run(*run, 2);
  const robot::Workings with = run->fleet().find({2})->workings();
  EXPECT_EQ(flow::Program::number(with.frame, *with.program->find("base_velocity")), 0.3);
  ASSERT_NE(with.interventions, nullptr);
  EXPECT_EQ(with.interventions->held().size(), 1U);
  EXPECT_EQ(flow::Program::vector(with.frame, *with.program->find(held)), (geom::Vector{0.5, 0.0, 0.0}));
  EXPECT_EQ(run->release_value({2}, held), std::nullopt);
}

TEST(TakeOver, OfAStrangersStateBeginsAnewAndWhatPeopleHoldStays) {
  const auto run = started(three_travellers());
  const robot::RobotProgram& own = *run->fleet().find({1})->program;
  robot::RobotProgram elsewhere = own;
  elsewhere.hosted = std::make_shared<robot_host::HostedProgram>();
  const auto port = std::ranges::find_if(own.program->ports(), [](const flow::Port& one) {
    return one.role == flow::Port::Role::kOutput && one.type->kind == flow::TypeKind::kVector;
  });
  ASSERT_NE(port, own.program->ports().end());
  robot::RobotValues before({1}, elsewhere);
  before.start();
  ASSERT_EQ(before.hold(port->path, "{0.5, 0}"), std::nullopt);
  std::memset(before.frame(), 0x5a, own.program->frame_size());
  robot::RobotValues after({1}, own);
  EXPECT_EQ(after.go_on_from(before),
            (std::vector<flow::Restart>{
                {"ROBOT", "begins anew as a whole: a process of its own has computed it"}}));
  EXPECT_TRUE(after.saved() == own.initial);
  ASSERT_NE(after.interventions(), nullptr);
  ASSERT_EQ(after.interventions()->held().size(), 1U);
  EXPECT_EQ(after.release(port->path), std::nullopt);
  EXPECT_TRUE(after.saved() == own.initial);
}

TEST(TakeOver, OfOtherRobotsOrBodiesIsRefusedAndNothingHasChanged) {
  const auto run = started(three_travellers());
  const auto without = started(three_travellers());
  step_run(*run, 30);
  step_run(*without, 30);
  const auto fewer = std::make_shared<mission::Mission>(*three_travellers());
  fewer->robots.pop_back();
  fewer->units[0].members.pop_back();
  const auto refused = run->take_over(crew_for(fewer));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error(), "there are other robots now");
  const auto larger = std::make_shared<mission::Mission>(*three_travellers());
  auto crew = std::make_shared<Crew>(*crew_for(larger));
  for (binding::BodySpec& body : crew->bodies) body.radius = 0.7;
  const auto other_body = run->take_over(crew);
  ASSERT_FALSE(other_body);
  EXPECT_EQ(other_body.error(), "the body of ROBOT has changed");
  step_run(*run, 30);
  step_run(*without, 30);
  EXPECT_TRUE(have_same_values(*run, *without));
}

}  // namespace
}  // namespace mlab::run
