#include "mlab/mission/testing/toy_fleet.h"

#include <algorithm>

namespace mlab::mission::testing {

MissionMaker::MissionMaker() {
  mission_.name = "test";
  mission_.types.push_back({.name = "ROBOT", .program = "robot", .host = {}, .parameters = {}, .place = {}});
}

std::uint32_t MissionMaker::unit(std::string name, int robots) {
  Unit unit;
  unit.name = std::move(name);
  for (int i = 0; i < robots; ++i) {
    const base::RobotId id{static_cast<std::uint32_t>(mission_.robots.size()) + 1};
    mission_.robots.push_back({.id = id, .type = 0, .place = {}});
    unit.members.push_back(id);
  }
  mission_.units.push_back(std::move(unit));
  return static_cast<std::uint32_t>(mission_.units.size()) - 1;
}

std::uint32_t MissionMaker::unit(std::string name, std::initializer_list<std::uint32_t> parts) {
  Unit unit;
  unit.name = std::move(name);
  unit.parts = parts;
  for (const std::uint32_t part : parts) {
    const auto& members = mission_.units[part].members;
    unit.members.insert(unit.members.end(), members.begin(), members.end());
  }
  mission_.units.push_back(std::move(unit));
  return static_cast<std::uint32_t>(mission_.units.size()) - 1;
}

MissionMaker& MissionMaker::step(std::vector<Command> commands) {
  return step(std::to_string(mission_.steps.size()), std::move(commands));
}

MissionMaker& MissionMaker::step(std::string label, std::vector<Command> commands) {
  mission_.steps.push_back({.label = std::move(label), .commands = std::move(commands), .place = {}});
  return *this;
}

UnitCommand command(std::uint32_t unit, Task task, std::string place, geom::Point goal) {
  UnitCommand c;
  c.unit = unit;
  c.task = task;
  c.place_name = std::move(place);
  c.goal = goal;
  return c;
}

UnitCommand start(std::uint32_t unit, geom::Point at, geom::Offset step) {
  UnitCommand c = command(unit, Task::kStart, "StartPlace", at);
  c.start_step = step;
  return c;
}
UnitCommand stop(std::uint32_t unit) {
  return command(unit, Task::kStop);
}
UnitCommand move_to(std::uint32_t unit, std::string place, geom::Point goal) {
  return command(unit, Task::kMoveTo, std::move(place), goal);
}
UnitCommand occupy(std::uint32_t unit, std::string place, geom::Point goal) {
  return command(unit, Task::kOccupy, std::move(place), goal);
}

ToyFleet::ToyFleet(std::shared_ptr<const Mission> mission, const ExecutiveOptions& options)
    : state_(initial_state(std::move(mission), options)) {
  for (const RobotState& robot : state_.robots) bodies_[robot.id.value].report.id = robot.id;
}

void ToyFleet::send(const Event& event) {
  Advance next = advance(std::move(state_), event);
  state_ = std::move(next.state);
  last_effects_ = std::move(next.effects);
  for (const Effect& effect : last_effects_) apply(effect);
  all_effects_.insert(all_effects_.end(), last_effects_.begin(), last_effects_.end());
}

void ToyFleet::answer(std::uint32_t question, bool proceed) {
  questions_.erase(question);
  send(event::Answer{question, proceed});
}

void ToyFleet::cycle() {
  time_ += kCycle;
  // All look at the same moment: first everybody decides, then everybody has moved.
  std::map<std::uint32_t, Body> moved = bodies_;
  for (auto& [id, body] : moved) drive(body);
  bodies_ = std::move(moved);
  event::Cycle cycle;
  cycle.time = time_;
  for (const auto& [id, body] : bodies_) {
    if (body.in_world && body.reports) cycle.robots.push_back(body.report);
  }
  send(cycle);
}

void ToyFleet::run_cycles(int count) {
  for (int i = 0; i < count; ++i) cycle();
}

void ToyFleet::hold(double seconds) {
  time_ += seconds;
  hold_until(state_, time_);
}

bool ToyFleet::run_until(const std::function<bool()>& holds, double seconds) {
  const double end = time_ + seconds;
  while (!holds()) {
    if (time_ >= end) return false;
    cycle();
  }
  return true;
}

bool ToyFleet::run(double seconds) {
  return run_until([this] { return state_.mode != State::Mode::kRunning; }, seconds);
}

geom::Point ToyFleet::centre(const std::vector<base::RobotId>& robots) const {
  geom::Offset sum;
  for (const base::RobotId id : robots) sum = sum + (position(id.value) - geom::Point{});
  return geom::Point{} + sum * (1.0 / static_cast<double>(robots.size()));
}

std::string ToyFleet::transcript() const {
  std::string text;
  for (const effect::Tell& tell : told_) text += tell.text + "\n";
  return text;
}

void ToyFleet::apply(const Effect& effect) {
  if (const auto* begin = std::get_if<effect::Start>(&effect)) {
    Body& body = bodies_[begin->robot.value];
    if (!body.starts) return;
    body.report.id = begin->robot;
    body.in_world = true;
    body.report.is_running = !body.faults;
    body.report.pose = begin->pose;
    body.report.sequence = 0;
    body.order = {};
  } else if (const auto* order = std::get_if<effect::Order>(&effect)) {
    take_order(*order);
  } else if (const auto* end = std::get_if<effect::Stop>(&effect)) {
    bodies_[end->robot.value].report.is_running = false;
  } else if (const auto* pause = std::get_if<effect::PauseRobots>(&effect)) {
    paused_ = pause->paused;
  } else if (const auto* ask = std::get_if<effect::Ask>(&effect)) {
    questions_[ask->question] = *ask;
  } else if (const auto* withdraw = std::get_if<effect::Withdraw>(&effect)) {
    questions_.erase(withdraw->question);
  } else if (const auto* tell = std::get_if<effect::Tell>(&effect)) {
    told_.push_back(*tell);
  }
}

void ToyFleet::take_order(const effect::Order& order) {
  for (const base::RobotId id : order.members) {
    Body& body = bodies_.at(id.value);
    if (body.order.order.sequence != order.order.sequence) {
      body.report.done = false;
      body.route_index = 0;
    }
    body.order = order;
  }
}

void ToyFleet::drive(Body& body) const {
  const percept::Order& order = body.order.order;
  body.step = {};
  if (!body.in_world || !body.report.is_running || order.sequence == 0) return;
  body.report.sequence = order.sequence;
  if (order.task == percept::Task::kTeleoperate) return;
  const geom::Point centre_now = centre(body.order.members);
  const bool follows = order.task == percept::Task::kFollow && body.route_index < order.route.size();
  geom::Point aim = follows ? order.route[body.route_index] : order.goal;
  if (follows && geom::distance(centre_now, aim) <= kSuccess && body.route_index + 1 < order.route.size()) {
    aim = order.route[++body.route_index];
  }
  const geom::Offset way = aim - centre_now;
  const double distance = geom::length(way);
  double remaining = distance;
  for (std::size_t i = body.route_index + 1; follows && i < order.route.size(); ++i) {
    remaining += geom::distance(order.route[i - 1], order.route[i]);
  }
  body.report.remaining = remaining;
  if (remaining <= kSuccess) body.report.done = true;
  if (paused_ || order.halted || body.is_stuck || distance <= 0.0) return;
  const double speed = order.speed > 0.0 ? order.speed : kSpeed;
  body.step = way * (std::min(speed * kCycle, distance) / distance);
  body.report.pose.position = body.report.pose.position + body.step;
}

}  // namespace mlab::mission::testing
