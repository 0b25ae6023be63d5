#include <fmt/core.h>

#include "mlab/fleet/fleet.h"

namespace mlab::fleet {
namespace {

constexpr double kCruiseSpeed = 1.0;  // of programs that have no speed of their own [m/s]

}  // namespace

Situation Fleet::situation_of(const FleetRobot& robot) const {
  const binding::WorldView& view = binding_.view();
  const binding::BodyState body = view.body(robot.body);
  Situation out;
  out.rows = robot.failsafes;
  out.motion = {poses_[index_of(robot)], body.velocity, body.turn_rate};
  out.home = robot.start.position;
  out.kinematics = &robot.body_spec.kinematics;
  out.radius = robot.capabilities.radius;
  out.cruise_speed = robot.program->number("base_velocity").value_or(kCruiseSpeed);
  out.is_in_contact = body.in_contact;
  out.silence = robot.runner->silence(robot.member);
  out.order = robot.group == FleetRobot::kNoGroup ? 0 : groups_[robot.group].order.sequence;
  out.is_steered = robot.joystick.magnitude > 0.0;
  if (failsafes_.returns(robot.failsafe)) {
    const percept::Percepts sensed = view.sense(robot.body, {{percept::Sensor::kObstacles, Situation::kSight},
                                                             {percept::Sensor::kRobots, Situation::kSight}});
    out.obstacles = sensed.obstacles;
    out.others = sensed.robots;
  }
  return out;
}

std::string Fleet::failsafe(const FleetRobot& robot) const {
  const std::size_t row = robot.failsafe.active;
  return row < failsafes_.rows().size() ? mission::words_of(failsafes_.rows()[row]) : "";
}

bool Fleet::guard(FleetRobot& robot, double dt) {
  const std::size_t before = robot.failsafe.active;
  const Failsafes::Outcome outcome = failsafes_.guard(situation_of(robot), dt, robot.failsafe, robot.action);
  const auto call = [&](std::size_t row, const char* what) {
    calls_.push_back({robot.id, RobotCall::Kind::kFailsafe,
                      fmt::format("`{}` {}", mission::words_of(failsafes_.rows()[row]), what)});
  };
  if (outcome.is_over) call(before, "is over");
  if (!outcome.triggered) return true;
  call(*outcome.triggered, "acts");
  if (failsafes_.rows()[*outcome.triggered].action != mission::FailsafeAction::kStop) return true;
  stop(robot.id);
  return false;
}

void Fleet::go_on_by_failsafe(FleetRobot& robot, double dt) {
  robot.action = {};
  if (robot.ailment.empty() && guard(robot, dt)) actions_[robot.body.value] = robot.action;
}

}  // namespace mlab::fleet
