#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include <fmt/core.h>

#include "mlab/base/angle.h"
#include "mlab/run/mission_run.h"
#include "mlab/schema/contracts.h"
#include "mlab/schema/errands.h"
#include "mlab/schema/turns.h"

namespace mlab::run {
namespace {

// What adds less than this to the motion is left out [share of full strength].
constexpr double kWorthTelling = 0.02;
constexpr double kNear = 50.0;   // [m]
constexpr double kAtEdge = 0.1;  // farther from where the edge holds a robot than this, it does not [m]

std::string direction_word(geom::Vector v) {
  const double angle = base::degrees(geom::direction(v));
  if (std::abs(angle) <= 22.5) return "ahead";
  if (std::abs(angle) >= 157.5) return "back";
  const char* side = angle > 0 ? "left" : "right";
  if (std::abs(angle) < 67.5) return fmt::format("ahead {}", side);
  if (std::abs(angle) > 112.5) return fmt::format("back {}", side);
  return side;
}

std::string compass_word(geom::Offset o) {
  constexpr const char* kWords[] = {"east", "north-east", "north", "north-west",
                                    "west", "south-west", "south", "south-east"};
  const auto sector = static_cast<int>(std::lround(geom::direction(o) / (std::numbers::pi / 4.0)));
  return kWords[(sector + 8) % 8];
}

std::string what_moves(const fleet::FleetRobot& robot) {
  std::string motion;
  // What a process of its own sums up, it keeps to itself.
  std::vector<flow::Contribution> parts;
  if (const robot::Workings workings = robot.workings())
    parts = workings.program->contributions(workings.frame);
  for (const flow::Contribution& part : parts) {
    const double strength = geom::length(part.weighted);
    if (strength < kWorthTelling) continue;
    const std::string size = strength > 1e6 ? "absolute" : fmt::format("{:.2f}", strength);
    motion += fmt::format("{}{} {} {}", motion.empty() ? "" : ", ", part.member, size,
                          direction_word(part.weighted));
  }
  if (!motion.empty()) return motion;
  const geom::Vector v = robot.action.velocity;
  const double speed = geom::length(v);
  return speed > 0.0 ? fmt::format("its program drives it at {:.2f} m/s {}", speed, direction_word(v))
                     : "nothing moves it";
}

void add_nearest_disc(const binding::WorldView& world, geom::Point at, double radius,
                      std::vector<std::string>& out) {
  std::optional<binding::MovingDisc> nearest;
  double nearest_gap = kNear;
  const auto consider = [&](const binding::MovingDisc& disc) {
    const double gap = geom::distance(disc.center, at) - disc.radius - radius;
    if (gap >= nearest_gap) return;
    nearest_gap = gap;
    nearest = disc;
  };
  for (const binding::Disc& disc : world.discs()) consider({disc.center, disc.radius, {}});
  for (const binding::MovingDisc& disc : world.moving_discs()) consider(disc);
  if (!nearest) return;
  const double speed = geom::length(nearest->velocity);
  const std::string motion =
      speed > 0.0 ? fmt::format(", moving at {:.1f} m/s {}", speed, compass_word(nearest->velocity)) : "";
  out.push_back(fmt::format("  obstacle of radius {:.1f} m at ({:.1f}, {:.1f}), {:.1f} m away to the {}{}",
                            nearest->radius, nearest->center.x, nearest->center.y, nearest_gap,
                            compass_word(nearest->center - at), motion));
}

void add_nearest_wall(const binding::WorldView& world, geom::Point at, std::vector<std::string>& out) {
  double nearest = kNear;
  geom::Point place;
  for (const binding::Wall& wall : world.walls()) {
    if (!wall.is_solid) continue;
    const geom::Point p = geom::nearest_point(wall.segment, at);
    if (geom::distance(p, at) < nearest) {
      nearest = geom::distance(p, at);
      place = p;
    }
  }
  if (nearest < kNear)
    out.push_back(fmt::format("  wall {:.1f} m away to the {}", nearest, compass_word(place - at)));
}

// The edge holds whoever wants to go on through it.
void add_edges(const overlay::Area& area, geom::Point at, std::vector<std::string>& out) {
  const auto at_edge = [&](double gap, const char* where) {
    if (std::abs(gap - binding::kAreaMargin) < kAtEdge)
      out.push_back(fmt::format("  edge of the mission area to the {}", where));
  };
  at_edge(at.x, "west");
  at_edge(area.width - at.x, "east");
  at_edge(at.y, "south");
  at_edge(area.height - at.y, "north");
}

// Who has which part of a command that the unit shares, and what this robot has of it.
void add_errands(const fleet::Fleet& fleet, const fleet::FleetRobot& robot, std::vector<std::string>& out) {
  const percept::Percepts percepts = fleet.perceive_at(robot, fleet.pose(robot), {}, 0.0);
  if (percepts.order.task != percept::Task::kVisit && percepts.order.task != percept::Task::kSearch) return;
  const schema::Errands errands(percepts);
  std::map<std::uint32_t, std::string> taken;
  std::size_t offered = 0;
  for (std::size_t i = 0; i < errands.count(); ++i) {
    const percept::Contract* contract = errands.contract(i);
    if (contract == nullptr || contract->state == percept::ContractState::kOpen) ++offered;
    if (contract == nullptr || !schema::is_held(*contract, contract->contractor)) continue;
    std::string& text = taken[contract->contractor.value];
    text += fmt::format("{}number {} at ({:.1f}, {:.1f}) since {:.1f} s", text.empty() ? "" : ", ", i + 1,
                        contract->place.x, contract->place.y, contract->time);
  }
  out.push_back(fmt::format(
      "  {} of {} parts {} done, {} on offer; each goes to the robot whose way it makes least longer",
      errands.done(), errands.count(), errands.done() == 1 ? "is" : "are", offered));
  for (const auto& [id, text] : taken) out.push_back(fmt::format("  robot {} has {}", id, text));
}

// That it waits to be let through, or makes way for another one.
void add_turn(const fleet::Fleet& fleet, const fleet::FleetRobot& robot, std::vector<std::string>& out) {
  const geom::Pose pose = fleet.pose(robot);
  const auto wish = schema::wish_of(fleet.perceive_at(robot, pose, {}, 0.0), robot.id);
  if (!wish) return;
  const std::uint32_t first = wish->priority.robot().value;
  const std::string there = fmt::format("({:.1f}, {:.1f})", wish->to.x, wish->to.y);
  if (wish->priority.is_cornered())
    out.push_back(
        fmt::format("  can't make way for robot {}, and asks to be let through, towards {}", first, there));
  else if (first == robot.id.value)
    out.push_back(fmt::format("  asks those in its way to let it through, towards {}", there));
  else if (schema::is_waiting(*wish, pose.position))
    out.push_back(fmt::format("  waits here until robot {} has passed", first));
  else
    out.push_back(fmt::format("  makes way for robot {}, towards {}", first, there));
}

}  // namespace

std::vector<std::string> MissionRun::explain(const fleet::FleetRobot& robot) const {
  const geom::Point at = fleet_->pose(robot).position;
  const std::string who = fmt::format("robot {} at ({:.1f}, {:.1f})", robot.id.value, at.x, at.y);
  if (robot.life == fleet::RobotLife::kParked) {
    return {
        fmt::format("{} stands parked: nothing here answers to its program `{}`", who, robot.program->name)};
  }
  if (const std::string failure = failure_of(robot); !failure.empty())
    return {fmt::format("{} stands: {}", who, failure)};
  if (robot.life != fleet::RobotLife::kRunning) return {fmt::format("{} is {}", who, name(robot.life))};

  std::vector<std::string> out = {fmt::format("{}: {}", who, what_moves(robot))};
  if (const std::string failsafe = fleet_->failsafe(robot); !failsafe.empty())
    out.front() = fmt::format("{}: `{}` acts, until another order or the stick; its program wants: {}", who,
                              failsafe, what_moves(robot));
  add_turn(*fleet_, robot, out);
  add_errands(*fleet_, robot, out);
  add_nearest_disc(world(), at, robot.capabilities.radius, out);
  add_nearest_wall(world(), at, out);
  add_edges(mission().overlay.mission_area(), at, out);
  for (const fleet::FleetRobot& other : fleet_->robots()) {
    if (&other == &robot || other.life == fleet::RobotLife::kNotStarted) continue;
    const geom::Offset to = fleet_->pose(other).position - at;
    if (geom::length(to) < 5.0 * (robot.capabilities.radius + other.capabilities.radius)) {
      out.push_back(fmt::format("  robot {} {:.1f} m away to the {}", other.id.value, geom::length(to),
                                compass_word(to)));
    }
  }
  return out;
}

}  // namespace mlab::run
