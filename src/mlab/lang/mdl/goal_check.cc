#include "mlab/lang/mdl/goal_check.h"

#include <algorithm>

#include <fmt/core.h>

#include "mlab/geom/outline.h"
#include "mlab/lang/mdl/quoted.h"

namespace mlab::mdl {
namespace {

// Obstacles and pieces of walls looked at over the whole mission: some tenths of a second.
constexpr std::uint64_t kMaxThingVisits = 20'000'000;

double distance_to_piece(geom::Point p, geom::Point a, geom::Point b) {
  const geom::Offset along = b - a;
  const double size = along.x * along.x + along.y * along.y;
  const geom::Offset to = p - a;
  const double share = size > 0.0 ? std::clamp((to.x * along.x + to.y * along.y) / size, 0.0, 1.0) : 0.0;
  return geom::distance(p, a + along * share);
}

}  // namespace

void GoalCheck::check(const mission::UnitCommand& c, double radius) {
  const std::string at = fmt::format("{:g} {:g}", c.goal.x, c.goal.y);
  const std::string where =
      in_backticks(c.place_name) + (c.place_name == at ? " is" : fmt::format(" is at {},", at));
  if (is_outside(c.goal)) {
    const overlay::Area area = mission_.overlay.mission_area();
    diagnostics_.warning(
        "goal-outside-area", c.goal_place,
        fmt::format("{} outside the mission area of {:g} by {:g} m", where, area.width, area.height));
  }
  if (const overlay::ObstacleDisc* obstacle = obstacle_at(c.goal, radius)) {
    auto& warning = diagnostics_.warning(
        "goal-in-obstacle", c.goal_place,
        fmt::format("{} in an obstacle of radius {:g} m: no robot can stand there", where, obstacle->radius));
    if (obstacle->place.source) warning.notes.push_back({"the obstacle is here", obstacle->place});
  }
  if (const overlay::ControlMeasure* minefield = minefield_at(c.goal)) {
    auto& warning = diagnostics_.warning(
        "goal-in-minefield", c.goal_place,
        fmt::format("{} in a minefield: robots keep out of it, and come no nearer than its edge", where));
    if (minefield->place.source) warning.notes.push_back({"the minefield is here", minefield->place});
  }
  if (const overlay::ControlMeasure* wall = wall_at(c.goal, radius)) {
    auto& warning = diagnostics_.warning(
        "goal-in-wall", c.goal_place,
        fmt::format("{} less than {:g} m from a wall: no robot can stand there", where, radius));
    if (wall->place.source) warning.notes.push_back({"the wall is here", wall->place});
  }
}

const overlay::ControlMeasure* GoalCheck::minefield_at(geom::Point p) {
  for (const overlay::ControlMeasure& measure : mission_.overlay.measures) {
    visits_ += 1 + measure.points.size();
    if (visits_ > kMaxThingVisits) return nullptr;
    if (overlay::info(measure.kind).substance != overlay::Substance::kAvoided || measure.points.empty())
      continue;
    if (measure.points.size() == 1) {
      if (geom::distance(p, measure.points.front()) < 0.5 * measure.size) return &measure;
      continue;
    }
    if (geom::is_within(measure.points, p)) return &measure;
  }
  return nullptr;
}

bool GoalCheck::is_outside(geom::Point p) const {
  return !mission_.overlay.mission_area().contains(p);
}

const overlay::ObstacleDisc* GoalCheck::obstacle_at(geom::Point p, double radius) {
  visits_ += mission_.overlay.obstacles.size();
  if (visits_ > kMaxThingVisits) return nullptr;
  const auto found = std::ranges::find_if(mission_.overlay.obstacles, [&](const overlay::ObstacleDisc& one) {
    return !one.is_moving() && geom::distance(p, one.center) < one.radius + radius;
  });
  return found == mission_.overlay.obstacles.end() ? nullptr : &*found;
}

const overlay::ControlMeasure* GoalCheck::wall_at(geom::Point p, double radius) {
  for (const overlay::ControlMeasure& measure : mission_.overlay.measures) {
    if (++visits_ > kMaxThingVisits) return nullptr;
    if (overlay::info(measure.kind).substance != overlay::Substance::kSolid) continue;
    for (std::size_t i = 0; i + 1 < measure.points.size() && ++visits_ <= kMaxThingVisits; ++i) {
      if (distance_to_piece(p, measure.points[i], measure.points[i + 1]) < radius) return &measure;
    }
  }
  return nullptr;
}

}  // namespace mlab::mdl
