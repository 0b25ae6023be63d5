#include "mlab/mission/parts.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

#include "mlab/geom/pose.h"
#include "mlab/mission/command.h"
#include "mlab/percept/formation.h"

namespace mlab::mission {
namespace {

using percept::Formation;
using percept::Task;

constexpr double kDefaultSpacing = 50.0;  ///< the standard robot's formation_spacing [m]
constexpr double kShareOfLeg = 0.25;   ///< parts end at most this share of the leg away from the unit's goal
constexpr double kBoundsPerLeg = 3.0;  ///< a short leg is still done in several bounds
constexpr std::size_t kMaxStations = 64;  ///< of larger parts the extent is estimated

double spacing_of(const State& state, base::RobotId first) {
  if (state.options.spacing > 0.0) return state.options.spacing;
  const Mission& mission = *state.mission;
  const auto robot = std::ranges::find(mission.robots, first, &Robot::id);
  if (robot == mission.robots.end() || robot->type >= mission.types.size()) return kDefaultSpacing;
  double spacing = kDefaultSpacing;
  for (const RobotParameter& parameter : mission.types[robot->type].parameters) {
    if (parameter.key != "formation_spacing") continue;
    double value = 0.0;
    const std::string_view text = parameter.value;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc{} && std::isfinite(value) && value > 0.0) spacing = value;
  }
  return spacing;
}

std::vector<std::vector<base::RobotId>> halves(const std::vector<base::RobotId>& members) {
  const auto middle = members.begin() + static_cast<std::ptrdiff_t>((members.size() + 1) / 2);
  return {{members.begin(), middle}, {middle, members.end()}};
}

std::vector<std::vector<base::RobotId>> divide(const State& state, const Run& run) {
  std::vector<std::vector<base::RobotId>> parts;
  const Mission& mission = *state.mission;
  for (const std::uint32_t part : mission.units[run.unit].parts) {
    if (part >= mission.units.size()) continue;
    std::vector<base::RobotId> members;
    for (const base::RobotId id : mission.units[part].members) {
      if (find_robot(state, id) != nullptr) members.push_back(id);
    }
    if (!members.empty()) parts.push_back(std::move(members));
  }
  return parts.size() >= 2 ? parts : halves(run.needed);
}

// Half the length that the formation takes up along (`forward`) or across its heading [m].
double half_extent(Formation formation, std::size_t count, double spacing, bool forward) {
  if (formation == Formation::kNone || formation == Formation::kSweep) return 0.0;
  if (count > kMaxStations) return static_cast<double>(count) * spacing / 2.0;
  double extent = 0.0;
  for (int rank = 0; rank < static_cast<int>(count); ++rank) {
    const geom::Vector at = percept::station(formation, rank, static_cast<int>(count), spacing);
    extent = std::max(extent, std::abs(forward ? at.x : at.y));
  }
  return extent;
}

struct Leg {
  geom::Point start;
  geom::Point goal;
  geom::Offset axis;  ///< direction of arrival, length 1; zero where the leg has no length
  double length = 0.0;
};

Leg leg_of(const State& state, const Run& run) {
  const UnitCommand& c = *run.command;
  Leg leg;
  leg.goal = goal_of(c);
  leg.start = centre(state, run.needed).value_or(leg.goal);
  geom::Offset arrival = leg.goal - leg.start;
  leg.length = geom::length(arrival);
  if (c.task == Task::kFollow && !c.route.empty()) {
    leg.length = geom::distance(leg.start, c.route.front());
    for (std::size_t i = 1; i < c.route.size(); ++i) leg.length += geom::distance(c.route[i - 1], c.route[i]);
    if (c.route.size() > 1) arrival = c.route.back() - c.route[c.route.size() - 2];
  }
  const double l = geom::length(arrival);
  if (l > geom::kZeroLength) leg.axis = arrival * (1.0 / l);
  return leg;
}

// How far each part ends from the unit's goal along one direction; weighted by their robots, the mean is 0
// [m].
std::vector<double> spread(const std::vector<PlannedPart>& parts, const std::vector<std::size_t>& order,
                           const std::vector<double>& half_extents, double spacing) {
  std::vector<double> places(parts.size());
  double place = 0.0;
  double mean = 0.0;
  double robots = 0.0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i > 0) place -= half_extents[order[i - 1]] + spacing + half_extents[order[i]];
    places[order[i]] = place;
    const auto weight = static_cast<double>(parts[order[i]].members.size());
    mean += place * weight;
    robots += weight;
  }
  for (double& at : places) at -= mean / robots;
  return places;
}

// A place where a part can stand: inside the area, clear of obstacles, not behind a wall as seen from the
// goal.
bool is_clear(const overlay::Overlay& map, geom::Point goal, geom::Point place, double clearance) {
  const overlay::Area area = map.mission_area();
  if (place.x < clearance || place.y < clearance || place.x > area.width - clearance ||
      place.y > area.height - clearance)
    return false;
  for (const overlay::ObstacleDisc& disc : map.obstacles) {
    if (geom::distance(disc.center, place) < disc.radius + clearance) return false;
  }
  for (const overlay::ControlMeasure& measure : map.measures) {
    if (measure.kind != overlay::MeasureKind::kWall) continue;
    for (std::size_t i = 1; i < measure.points.size(); ++i) {
      if (geom::intersects({goal, place}, {measure.points[i - 1], measure.points[i]})) return false;
    }
  }
  return true;
}

// Gives each part its own place around the goal: as wide apart as the leg and the map allow.
void place_parts(const State& state, const Leg& leg, geom::Offset direction,
                 const std::vector<double>& places, double spacing, std::vector<PlannedPart>& parts) {
  double widest = 0.0;
  for (const double place : places) widest = std::max(widest, std::abs(place));
  const double fit = widest > 0.0 ? std::min(1.0, leg.length * kShareOfLeg / widest) : 0.0;
  const double clearance = std::min(spacing, leg.length * kShareOfLeg) / 5.0;
  for (const double share : {1.0, 0.75, 0.5, 0.25, 0.0}) {
    for (std::size_t i = 0; i < parts.size(); ++i)
      parts[i].end = leg.goal + direction * (places[i] * fit * share);
    const auto clear = [&](const PlannedPart& p) {
      return is_clear(state.mission->overlay, leg.goal, p.end, clearance);
    };
    if (std::ranges::all_of(parts, clear)) return;
  }
}

std::vector<std::size_t> in_order(std::size_t count) {
  std::vector<std::size_t> order(count);
  for (std::size_t i = 0; i < count; ++i) order[i] = i;
  return order;
}

std::vector<std::size_t> from_left(const State& state, const Leg& leg,
                                   const std::vector<PlannedPart>& parts) {
  std::vector<double> left(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    left[i] = geom::cross(leg.axis, centre(state, parts[i].members).value_or(leg.start) - leg.start);
  }
  std::vector<std::size_t> order = in_order(parts.size());
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return left[a] > left[b]; });
  return order;
}

void plan_places(const State& state, Run& run, std::vector<PlannedPart>& parts) {
  const Leg leg = leg_of(state, run);
  const bool bounds = run.technique == Technique::kBoundingOverwatch;
  const double spacing = spacing_of(state, run.needed.front());
  std::vector<double> half_extents;
  for (const PlannedPart& part : parts) {
    half_extents.push_back(half_extent(formation_of(*run.command), part.members.size(), spacing, !bounds));
  }
  std::vector<std::size_t> order = in_order(parts.size());
  if (bounds) order = from_left(state, leg, parts);
  const geom::Offset left{-leg.axis.y, leg.axis.x};
  place_parts(state, leg, bounds ? left : leg.axis, spread(parts, order, half_extents, spacing), spacing,
              parts);

  double longest = leg.length;
  for (PlannedPart& part : parts) {
    part.goal = run.command->task == Task::kFollow ? leg.goal : part.end;
    longest = std::max(longest, geom::distance(centre(state, part.members).value_or(part.end), part.end));
  }
  run.distance = bounds ? std::min(state.options.bound_length, longest / kBoundsPerLeg)
                        : std::min(spacing + half_extents[0] + half_extents[1], longest * kShareOfLeg);
}

bool can_divide(const Run& run) {
  const Task task = run.command->task;
  const bool moves = task == Task::kMoveTo || task == Task::kSweepTo || task == Task::kFollow;
  return moves && run.needed.size() >= 2 && run.command->technique != Technique::kTraveling;
}

}  // namespace

std::optional<geom::Point> centre(const State& state, const std::vector<base::RobotId>& members) {
  geom::Offset sum;
  double count = 0.0;
  for (const base::RobotId id : members) {
    const RobotState* robot = find_robot(state, id);
    if (robot == nullptr || !in_sight(state, *robot)) continue;
    sum = sum + (robot->pose.position - geom::Point{});
    count += 1.0;
  }
  if (count == 0.0) return std::nullopt;
  return geom::Point{} + sum * (1.0 / count);
}

std::vector<PlannedPart> plan_parts(const State& state, Run& run) {
  if (run.needed.empty()) return {};
  const geom::Point goal = goal_of(*run.command);
  if (!can_divide(run)) return {{.members = run.needed, .goal = goal, .end = goal, .halted = false}};
  run.technique = run.command->technique;
  std::vector<PlannedPart> parts;
  for (auto& members : divide(state, run)) {
    // Under bounding overwatch all are halted until all are at rest; then the first bound begins.
    const bool halted = run.technique == Technique::kBoundingOverwatch || !parts.empty();
    parts.push_back({.members = std::move(members), .goal = goal, .end = goal, .halted = halted});
  }
  plan_places(state, run, parts);
  return parts;
}

}  // namespace mlab::mission
