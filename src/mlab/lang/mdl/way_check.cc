#include "mlab/lang/mdl/way_check.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/core.h>

#include "mlab/lang/mdl/quoted.h"
#include "mlab/mission/command.h"
#include "mlab/mission/wording.h"
#include "mlab/overlay/barriers.h"

namespace mlab::mdl {
namespace {

// Maps with more discs or pieces of walls are left alone.
constexpr std::size_t kMostThings = 2'000;
// Tangents looked at over the whole mission: some tenths of a second.
constexpr std::uint64_t kMostEffort = 4'000'000;
// Of a body that is only there to find out whether there is a gap at all [m].
constexpr double kThin = 1e-3;

}  // namespace

WayCheck::WayCheck(const mission::Mission& mission, text::Diagnostics& diagnostics)
    : mission_(mission), diagnostics_(diagnostics) {
  const overlay::Area area = mission.overlay.mission_area();
  ground_.bounds = {0.0, 0.0, area.width, area.height};
  for (const overlay::ObstacleDisc& one : mission.overlay.obstacles) {
    if (one.is_moving()) continue;
    obstacles_.push_back(&one);
    ground_.discs.push_back({one.center, one.radius});
    if (ground_.discs.size() > kMostThings) return;
  }
  open_ = ground_;
  for (const overlay::Barrier& one : overlay::barriers(mission.overlay)) {
    if (one.is_solid) open_.walls.push_back(one.segment);
    ground_.walls.push_back(one.segment);
    measures_.push_back(&mission.overlay.measures[one.measure]);
  }
}

bool WayCheck::is_too_much() const {
  return ground_.discs.size() > kMostThings || ground_.walls.size() > kMostThings;
}

ways::Planner& WayCheck::planner(double clearance, bool keeps_out) {
  auto& out = planners_[{keeps_out, clearance}];
  if (!out) out = std::make_unique<ways::Planner>(keeps_out ? ground_ : open_, clearance);
  return *out;
}

bool WayCheck::has_effort_left() const {
  return effort_ < kMostEffort;
}

/// Nothing: there is a way, or nothing that one could begin or end at, or it would take too long to know.
std::optional<ways::Planner::NoWay> WayCheck::no_way(ways::Planner& planner, geom::Point from,
                                                     geom::Point goal, double success) {
  const ways::Clearing& clearing = planner.clearing();
  const auto begin = clearing.nearest_free(from);
  const auto end = clearing.nearest_free(goal);
  if (!begin || !end) return std::nullopt;
  const auto find = [&](geom::Point to) {
    const std::uint64_t before = planner.effort();
    auto out = planner.find(*begin, to, kMostEffort - std::min(effort_, kMostEffort));
    effort_ += planner.effort() - before;
    return out;
  };
  const auto way = find(*end);
  if (way || !way.error().is_certain) return std::nullopt;
  // Somewhere else it may be near enough.
  constexpr int kSides = 16;
  for (int i = 0; i < kSides; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kSides;
    const geom::Point beside = goal + geom::Offset{std::cos(angle), std::sin(angle)} * (0.95 * success);
    if (!clearing.is_free(beside)) continue;
    const auto other = find(beside);
    if (other || !other.error().is_certain) return std::nullopt;
  }
  return way.error();
}

bool WayCheck::check(const mission::UnitCommand& command, const From& from, Room room, double success) {
  const geom::Point goal = mission::goal_of(command);
  if (is_too_much()) return true;
  if (ground_.discs.empty() && ground_.walls.empty()) return true;
  if (!ground_.bounds.contains(from.place) || !ground_.bounds.contains(goal)) return true;
  if (distance(from.place, goal) <= success || !(room.radius > kThin)) return true;
  if (!has_effort_left()) return true;
  const auto none = no_way(planner(room.half(), room.keeps_out), from.place, goal, success);
  if (none) warn(command, from, room, success, none->nearest);
  return !none;
}

void WayCheck::note_thing(std::uint32_t thing, text::Diagnostic& warning) const {
  if (thing < ground_.discs.size()) {
    const text::Place& place = obstacles_[thing]->place;
    if (place.source) warning.notes.push_back({"this obstacle is in the way", place});
    return;
  }
  const overlay::ControlMeasure& measure = *measures_[thing - ground_.discs.size()];
  if (!measure.place.source) return;
  const bool is_avoided = overlay::info(measure.kind).substance == overlay::Substance::kAvoided;
  warning.notes.push_back(
      {is_avoided ? "this minefield is in the way" : "this wall is in the way", measure.place});
}

void WayCheck::warn(const mission::UnitCommand& command, const From& from, Room room, double success,
                    geom::Point nearest) {
  const geom::Point goal = mission::goal_of(command);
  const std::string name = in_backticks(command.place_name);
  const std::string where =
      fmt::format("no way leads to {} from {:g} {:g}, where {} is by then",
                  from.to_corner ? fmt::format("the corner {:g} {:g} of {}", goal.x, goal.y, name) : name,
                  from.place.x, from.place.y, from.who);
  // The widest gap that there is, if any: too narrow for the body, wide enough for the thin one.
  if (!no_way(planner(kThin, room.keeps_out), from.place, goal, success)) {
    double passes = kThin;
    double stuck = room.half();
    for (int i = 0; i < 10 && has_effort_left(); ++i) {
      const double half = 0.5 * (passes + stuck);
      ways::Planner tried(room.keeps_out ? ground_ : open_, half);
      effort_ += tried.effort();
      (no_way(tried, from.place, goal, success) ? stuck : passes) = half;
    }
    const std::string body =
        passes < room.radius
            ? fmt::format("the body {:g} m", 2.0 * room.radius)
            : fmt::format("the body of {:g} m wants {:g} m to either side", 2.0 * room.radius, room.margin);
    diagnostics_.warning(
        "no-way", command.goal_place,
        has_effort_left()
            ? fmt::format("{}: the widest gap is {:.2f} m wide, and {}", where, 2.0 * passes, body)
            : fmt::format("{}: all gaps are too narrow for a body of {:g} m", where, 2.0 * room.radius));
    return;
  }
  auto& warning =
      diagnostics_.warning("no-way", command.goal_place,
                           fmt::format("{}: it is closed off, and the robots come no nearer than {:.0f} m",
                                       where, distance(nearest, goal)));
  if (const auto thing = planner(room.half(), room.keeps_out).clearing().first_hit({nearest, goal}))
    note_thing(*thing, warning);
}

}  // namespace mlab::mdl
