#include <string>
#include <utility>

#include <fmt/core.h>

#include "mlab/fleet/fleet.h"

namespace mlab::fleet {
namespace {

constexpr double kCruiseSpeed = 1.0;  // of programs that have no speed of their own [m/s]

}  // namespace

// Kept until its program has answered: lists of percepts are another robot's by then.
void Fleet::note_seen(std::size_t robot, const percept::Percepts& percepts) {
  SeenByFailsafes& seen = now_.seen[robot];
  seen.touches = percepts.touch != geom::Vector{};
  seen.obstacles.clear();
  seen.others.clear();
  if (!now_.failsafes->returns(now_.robots[robot].failsafe)) return;
  seen.obstacles.assign(percepts.obstacles.begin(), percepts.obstacles.end());
  seen.others.assign(percepts.robots.begin(), percepts.robots.end());
}

// What is so near to the robot that it may lead it aside. Other bodies, and obstacles that move, count where
// they are now.
void Fleet::look_for_passage(const FleetRobot& robot, double reach) {
  passage_.clear();
  if (reach <= 0.0) return;
  const geom::Point here = now_.poses[index_of(robot)].position;
  const binding::WorldView& view = binding_.view();
  for (const binding::Disc& disc : view.discs()) {
    if (geom::distance(disc.center, here) <= reach + disc.radius) passage_.add(disc);
  }
  for (const binding::MovingDisc& disc : view.moving_discs()) {
    if (geom::distance(disc.center, here) <= reach + disc.radius)
      passage_.add(binding::Disc{disc.center, disc.radius});
  }
  for (const binding::Wall& wall : view.walls()) {
    if (wall.is_solid && geom::distance(nearest_point(wall.segment, here), here) <= reach)
      passage_.add(wall.segment);
  }
  for (std::size_t i = 0; i < now_.robots.size(); ++i) {
    const FleetRobot& other = now_.robots[i];
    if (other.life == RobotLife::kNotStarted || &other == &robot) continue;
    const double radius = other.capabilities.radius;
    if (geom::distance(now_.poses[i].position, here) <= reach + radius)
      passage_.add(binding::Disc{now_.poses[i].position, radius});
  }
  constexpr double kMargin = binding::kAreaMargin;
  const geom::Point low{kMargin, kMargin};
  const geom::Point high{now_.area.width - kMargin, now_.area.height - kMargin};
  const geom::Point start = robot.start.position;
  const bool is_held = start.x >= low.x && start.y >= low.y && start.x <= high.x && start.y <= high.y;
  if (is_held) passage_.keep_within(low, high);
}

Situation Fleet::situation(const FleetRobot& robot) const {
  Situation out;
  out.rows = robot.failsafes;
  out.kinematics = &robot.kinematics;
  out.radius = robot.capabilities.radius;
  out.cruise_speed = robot.program->number("base_velocity").value_or(kCruiseSpeed);
  if (robot.life == RobotLife::kNotStarted) return out;
  const binding::BodyState body = binding_.view().body(robot.body);
  out.motion = {now_.poses[index_of(robot)], {body.velocity, body.speed, body.turn_rate}};
  out.home = robot.start.position;
  out.vehicle = body.upkeep;
  if (index_of(robot) >= now_.seen.size() || robot.runner == nullptr) return out;
  const SeenByFailsafes& seen = now_.seen[index_of(robot)];
  out.is_in_contact = seen.touches;
  out.silence = robot.runner->silence(robot.member);
  out.percept_age = robot.runner->percept_age(robot.member);
  out.lacks_operator = robot.is_teleoperated && !robot.is_stick_held;
  out.order = robot.group == FleetRobot::kNoGroup ? 0 : now_.groups[robot.group].order.sequence;
  out.is_steered = robot.joystick.magnitude > 0.0;
  out.obstacles = seen.obstacles;
  out.others = seen.others;
  return out;
}

Situation Fleet::situation_of(const FleetRobot& robot, double dt) {
  Situation out = situation(robot);
  look_for_passage(robot, now_.failsafes->passage_reach(out, robot.action, dt));
  out.passage = &passage_;
  return out;
}

std::string Fleet::failsafe(const FleetRobot& robot) const {
  const std::size_t row = robot.failsafe.active;
  return row < now_.failsafes->rows().size() ? mission::words_of(now_.failsafes->rows()[row]) : "";
}

// A row that acts is told of whatever has become of the robot.
std::vector<RowStanding> Fleet::standings(const FleetRobot& robot, double dt) const {
  using State = RowStanding::State;
  std::vector<RowStanding> out;
  if (robot.failsafes == 0) return {now_.failsafes->rows().size(), RowStanding{}};
  const Situation now = situation(robot);
  const bool is_guarded = robot.life == RobotLife::kRunning ||
                          (robot.life == RobotLife::kFaulted && now_.failsafes->drives(robot.failsafe));
  const bool is_in_real_time = robot.runner != nullptr && robot.runner->punctuality() != nullptr;
  const auto may_come = [&](mission::FailsafeCondition condition) {
    switch (mission::info(condition).watch) {
      case mission::FailsafeWatch::kRunning:
        return true;
      case mission::FailsafeWatch::kRealTime:
        // What a vehicle says is looked at wherever the program is computed.
        return is_in_real_time || (condition == mission::FailsafeCondition::kPerceptsStale && now.vehicle);
      case mission::FailsafeWatch::kTeleoperated:
        return robot.is_teleoperated;
      case mission::FailsafeWatch::kVehicle:
        return now.vehicle.has_value();
    }
    return false;
  };
  for (std::size_t i = 0; i < now_.failsafes->rows().size(); ++i) {
    RowStanding& row = out.emplace_back(now_.failsafes->standing(i, now, robot.action, dt, robot.failsafe));
    const bool is_looked_at = is_guarded && may_come(now_.failsafes->rows()[i].condition);
    if (!is_looked_at && row.state != State::kOthers && row.state != State::kActive)
      row = {.state = State::kOff};
  }
  return out;
}

bool Fleet::guard(FleetRobot& robot, double dt) {
  const std::size_t before = robot.failsafe.active;
  const Failsafes::Outcome outcome =
      now_.failsafes->guard(situation_of(robot, dt), dt, robot.failsafe, robot.action);
  const auto words = [&](std::size_t row) { return mission::words_of(now_.failsafes->rows()[row]); };
  const auto call = [&](std::string text) {
    now_.calls.push_back({robot.id, RobotCall::Kind::kFailsafe, std::move(text)});
  };
  if (outcome.outside)
    call(fmt::format("`{}` lets it in first: it begins outside, and may only come nearer",
                     words(*outcome.outside)));
  if (outcome.is_over) call(fmt::format("`{}` is over", words(before)));
  if (!outcome.triggered) return true;
  call(fmt::format("`{}` acts{}", words(*outcome.triggered),
                   outcome.gave_way ? fmt::format(", before `{}`", words(*outcome.gave_way)) : ""));
  if (now_.failsafes->rows()[*outcome.triggered].action != mission::FailsafeAction::kStop) return true;
  stop(robot.id);
  return false;
}

// Its body senses all the same.
void Fleet::go_on_by_failsafe(FleetRobot& robot, double dt) {
  robot.action = {};
  if (!robot.ailment.empty()) return;
  const percept::Needs needs = now_.failsafes->needs(robot.failsafes, robot.failsafe);
  percept::Percepts percepts;
  const binding::Sensing sensing = {robot.body, &needs, &percepts};
  binding_.percepts({&sensing, 1}, 0);
  note_seen(index_of(robot), percepts);
  if (guard(robot, dt)) actions_[robot.body.value] = robot.action;
}

}  // namespace mlab::fleet
