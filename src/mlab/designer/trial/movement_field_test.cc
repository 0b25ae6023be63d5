#include "mlab/designer/trial/movement_field.h"

#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "mlab/robot/host/hosted_program.h"
#include "mlab/simulated/run.h"

namespace mlab::designer {
namespace {

// A standard robot that has travelled for a while, with other numbers than it started with.
std::unique_ptr<run::MissionRun> travelling() {
  auto mission = std::make_shared<mission::Mission>();
  mission->types.push_back({"ROBOT", "robot", "blue", "", {}, {}});
  mission->robots = {{{1}, 0, {}}};
  mission->units.push_back({"one", {{1}}, {}, {}});
  mission::UnitCommand start;
  start.task = mission::Task::kStart;
  start.goal = {100.0, 100.0};
  start.start_step = {0.0, 40.0};
  mission::UnitCommand go;
  go.goal = {700.0, 120.0};
  go.place_name = "700 120";
  mission->steps.push_back({"0", {start}, {}});
  mission->steps.push_back({"1", {go}, {}});
  text::Diagnostics sink;
  auto run = simulated::make_run(mission, {}, {}, sink);
  EXPECT_NE(run, nullptr) << text::render(sink);
  run->post(mission::event::Execute{});
  for (int i = 0; i < 50; ++i) run->step();
  for (const flow::Port& port : run->fleet().robots().front().program->program->ports()) {
    if (port.role != flow::Port::Role::kOutput && port.type->kind == flow::TypeKind::kReal)
      static_cast<void>(run->set_parameter({1}, port.path, "0.15"));  // not all can be that
  }
  return run;
}

struct Field {
  std::string arrows;
  bool is_as_is = false;
};

// Of the whole program, as it moves the robot at `port`.
Field read(const run::MissionRun& run, const fleet::FleetRobot& body, const std::string& port, bool as_is) {
  const FieldProgram part{run.fleet().robots().front().program->program, port};
  FieldReading reading(part, {90.0, 90.0, 400.0, 200.0, 6, 4, 0.0}, as_is);
  EXPECT_TRUE(reading.read(run, body, 1e9));
  EXPECT_EQ(reading.problem(), "");
  return {reading.arrows(), reading.is_as_is()};
}

TEST(MovementField, StateOfAProcessOfItsOwnIsNotTakenIntoThisOne) {
  const auto run = travelling();
  const fleet::FleetRobot& robot = run->fleet().robots().front();
  robot::RobotProgram elsewhere = *robot.program;
  elsewhere.hosted = std::make_shared<robot_host::HostedProgram>();
  fleet::FleetRobot stranger = robot;
  stranger.program = &elsewhere;
  int that_differ = 0;
  for (const flow::Port& port : robot.program->program->ports()) {
    if (port.role != flow::Port::Role::kOutput || port.type->kind != flow::TypeKind::kVector) continue;
    const Field own = read(*run, robot, port.path, true);
    EXPECT_TRUE(own.is_as_is);
    const Field fresh = read(*run, robot, port.path, false);
    EXPECT_FALSE(fresh.is_as_is);
    if (own.arrows != fresh.arrows) ++that_differ;
    const Field theirs = read(*run, stranger, port.path, true);
    EXPECT_FALSE(theirs.is_as_is);
    EXPECT_EQ(theirs.arrows, fresh.arrows) << port.path;
  }
  EXPECT_GT(that_differ, 0) << "state makes a difference";
}

}  // namespace
}  // namespace mlab::designer
