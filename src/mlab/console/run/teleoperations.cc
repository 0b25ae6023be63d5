#include "mlab/console/run/teleoperations.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "mlab/console/published/overview.h"
#include "mlab/mission/wording.h"

namespace mlab::console {

void Teleoperations::let_go(run::MissionRun& run, Unit& unit) {
  unit.is_held = false;
  for (const base::RobotId id : unit.robots) run.let_go_of_stick(id);
}

void Teleoperations::let_go(run::MissionRun& run) {
  for (Unit& unit : units_) let_go(run, unit);
}

bool Teleoperations::update(run::MissionRun& run) {
  std::vector<std::pair<std::string, std::vector<base::RobotId>>> now;
  for (const mission::Run& command : run.state().runs) {
    if (command.phase == mission::Run::Phase::kTeleoperation)
      now.emplace_back(run.state().commands[command.record].unit, command.needed);
  }
  const bool same = std::ranges::equal(
      now, units_, [](const auto& a, const Unit& b) { return a.first == b.name && a.second == b.robots; });
  if (same) return false;
  std::vector<Unit> units;
  for (auto& [name, robots] : now) {
    const auto known = std::ranges::find(units_, name, &Unit::name);
    if (known != units_.end() && known->robots == robots)
      units.push_back(std::exchange(*known, {}));
    else
      units.push_back({name, std::move(robots)});
  }
  let_go(run);
  units_ = std::move(units);
  robots_.clear();
  for (const Unit& unit : units_) robots_.insert(robots_.end(), unit.robots.begin(), unit.robots.end());
  std::ranges::sort(robots_);
  return true;
}

std::optional<std::string> Teleoperations::push(run::MissionRun& run, const Stick& stick, double wall) {
  const auto unit = std::ranges::find(units_, stick.unit(), &Unit::name);
  if (unit == units_.end()) return fmt::format("{} is not under teleoperation", clean(stick.unit()));
  if (!std::isfinite(stick.x()) || !std::isfinite(stick.y())) return "the stick's place is no number";
  percept::Joystick joystick;
  joystick.x = std::clamp(stick.x(), -1.0, 1.0);
  joystick.y = std::clamp(stick.y(), -1.0, 1.0);
  joystick.magnitude = std::min(1.0, std::sqrt(joystick.x * joystick.x + joystick.y * joystick.y));
  joystick.is_robot_frame = stick.robot_frame();
  unit->is_held = true;
  unit->held_at = wall;
  for (const base::RobotId id : unit->robots) run.set_joystick(id, joystick);
  return std::nullopt;
}

bool Teleoperations::relax(run::MissionRun& run, double wall) {
  bool any = false;
  for (Unit& unit : units_) {
    if (!unit.is_held || wall - unit.held_at < kDeadMan) continue;
    let_go(run, unit);
    any = true;
  }
  return any;
}

std::optional<double> Teleoperations::next_release() const {
  std::optional<double> next;
  for (const Unit& unit : units_) {
    if (unit.is_held) next = std::min(next.value_or(unit.held_at + kDeadMan), unit.held_at + kDeadMan);
  }
  return next;
}

bool Teleoperations::is_open(const std::string& unit) const {
  return std::ranges::find(units_, unit, &Unit::name) != units_.end();
}

std::vector<std::string> Teleoperations::units() const {
  std::vector<std::string> out;
  for (const Unit& unit : units_) out.push_back(unit.name);
  return out;
}

void Teleoperations::encode(Status& out) const {
  for (const Unit& unit : units_) {
    Status::Teleoperation& told = *out.add_teleoperations();
    told.set_unit(clean(unit.name));
    for (const base::RobotId id : unit.robots) told.add_robots(id.value);
  }
}

}  // namespace mlab::console
