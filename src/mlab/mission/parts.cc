#include "mlab/mission/parts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>

#include "mlab/geom/pose.h"
#include "mlab/mission/command.h"
#include "mlab/mission/lanes.h"
#include "mlab/mission/parameter.h"
#include "mlab/mission/search.h"
#include "mlab/mission/tasks.h"

namespace mlab::mission {
namespace {

constexpr double kShareOfLeg = 0.25;   ///< parts end at most this share of the leg away from the unit's goal
constexpr double kBoundsPerLeg = 3.0;  ///< a short leg is still done in several bounds
constexpr double kRoomToPass =
    0.5;  ///< lanes closer than this share of what is wanted: no part passes another

double spacing_of(const State& state, base::RobotId first) {
  if (state.options.spacing > 0.0) return state.options.spacing;
  const RobotType* type = type_of(*state.mission, first);
  const double spacing =
      type == nullptr ? 0.0 : number_parameter(*type, "formation_spacing", kDefaultSpacing);
  return spacing > 0.0 ? spacing : kDefaultSpacing;
}

std::vector<std::vector<base::RobotId>> halves(const std::vector<base::RobotId>& members) {
  const auto middle = members.begin() + static_cast<std::ptrdiff_t>((members.size() + 1) / 2);
  return {{members.begin(), middle}, {middle, members.end()}};
}

std::vector<std::vector<base::RobotId>> divide(const State& state, const Run& run) {
  std::vector<std::vector<base::RobotId>> parts;
  const Mission& mission = *state.mission;
  const bool is_known = run.unit < mission.units.size();
  for (const std::uint32_t part : is_known ? mission.units[run.unit].parts : std::vector<std::uint32_t>()) {
    if (part >= mission.units.size()) continue;
    std::vector<base::RobotId> members;
    for (const base::RobotId id : mission.units[part].members) {
      if (std::ranges::find(run.needed, id) != run.needed.end()) members.push_back(id);
    }
    if (!members.empty()) parts.push_back(std::move(members));
  }
  return parts.size() >= 2 ? parts : halves(run.needed);
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

// The way of the whole unit.
Track track_of(const UnitCommand& command) {
  const bool follows = command.task == Task::kFollow && !command.route.empty();
  return follows ? command.route : Track{command.goal};
}

// Gives each part the lane that `lane_at` says for its place: as wide apart as the leg and the map allow.
// @return  the share of the wanted width
template <class LaneAt>
double spread_out(const State& state, const Leg& leg, const std::vector<double>& places, double spacing,
                  const Track& track, const LaneAt& lane_at, std::vector<Track>& lanes) {
  double widest = 0.0;
  for (const double place : places) widest = std::max(widest, std::abs(place));
  const double fit = widest > 0.0 ? std::min(1.0, leg.length * kShareOfLeg / widest) : 0.0;
  const double clearance = std::min(spacing, leg.length * kShareOfLeg) / 5.0;
  for (const double share : {1.0, 0.75, 0.5, 0.25}) {
    for (std::size_t i = 0; i < lanes.size(); ++i) lanes[i] = lane_at(places[i] * fit * share);
    const auto clear = [&](const Track& lane) {
      return is_clear(state.mission->overlay, track, lane, clearance);
    };
    if (std::ranges::all_of(lanes, clear)) return fit * share;
  }
  for (Track& lane : lanes) lane = lane_at(0.0);
  return 0.0;
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

std::vector<double> half_extents(const Run& run, const std::vector<PlannedPart>& parts, double spacing,
                                 bool along) {
  std::vector<double> extents;
  for (const PlannedPart& part : parts) {
    extents.push_back(half_extent(formation_of(*run.command), part.members.size(), spacing, along));
  }
  return extents;
}

// Lanes side by side, so that a part can pass another. @return false where there is no room for that
bool plan_lanes(const State& state, const Run& run, const Leg& leg, double spacing,
                std::vector<PlannedPart>& parts) {
  const Track track = track_of(*run.command);
  const auto places =
      spread(parts, from_left(state, leg, parts), half_extents(run, parts, spacing, false), spacing);
  std::vector<Track> lanes(parts.size());
  const auto lane_at = [&](double left) { return beside(track, leg.axis, left); };
  if (spread_out(state, leg, places, spacing, track, lane_at, lanes) < kRoomToPass) return false;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    parts[i].goal = parts[i].end = lanes[i].back();
    if (run.command->task != Task::kFollow) continue;
    UnitCommand own = *run.command;
    own.route = lanes[i];
    parts[i].command = CommandRef{std::make_shared<const UnitCommand>(std::move(own))};
  }
  return true;
}

// One behind the other, the first part foremost.
void plan_file(const State& state, const Run& run, const Leg& leg, double spacing,
               std::vector<PlannedPart>& parts) {
  const auto places = spread(parts, in_order(parts.size()), half_extents(run, parts, spacing, true), spacing);
  std::vector<Track> ends(parts.size());
  const auto end_at = [&](double ahead) { return Track{leg.goal + leg.axis * ahead}; };
  spread_out(state, leg, places, spacing, {leg.goal}, end_at, ends);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    parts[i].end = ends[i].back();
    parts[i].ahead = geom::dot(parts[i].end - leg.goal, leg.axis);
    parts[i].goal = run.command->task == Task::kFollow ? leg.goal : parts[i].end;
  }
}

void plan_places(const State& state, Run& run, std::vector<PlannedPart>& parts) {
  const Leg leg = leg_of(state, run);
  const bool bounds = run.technique == Technique::kBoundingOverwatch;
  const double spacing = spacing_of(state, run.needed.front());
  const bool passes = bounds && plan_lanes(state, run, leg, spacing, parts);
  run.in_file = !passes;
  if (!passes) plan_file(state, run, leg, spacing, parts);

  double longest = leg.length;
  for (const PlannedPart& part : parts) {
    longest = std::max(longest, geom::distance(centre(state, part.members).value_or(part.end), part.end));
  }
  const auto depths = half_extents(run, parts, spacing, true);
  run.distance = bounds ? std::min(state.options.bound_length, longest / kBoundsPerLeg)
                        : std::min(spacing + depths[0] + depths[1], longest * kShareOfLeg);
}

bool can_divide(const Run& run) {
  return takes(run.command->task, ClauseKind::kTechnique) && run.needed.size() >= 2 &&
         run.command->technique != Technique::kTraveling;
}

// Where each of them is, as far as it is known: else where the first one is that is in sight.
std::vector<geom::Point> places_of(const State& state, const std::vector<base::RobotId>& robots) {
  std::vector<geom::Point> out;
  for (const base::RobotId id : robots) {
    if (const auto place = centre(state, {id})) out.push_back(*place);
  }
  if (!out.empty()) out.resize(robots.size(), out.front());
  return out;
}

}  // namespace

std::optional<geom::Point> centre(const State& state, const std::vector<base::RobotId>& members,
                                  Whose whose) {
  geom::Offset sum;
  double count = 0.0;
  for (const base::RobotId id : members) {
    const RobotState* robot = find_robot(state, id);
    if (robot == nullptr || !in_sight(state, *robot) || (whose == Whose::kRunning && !robot->is_running))
      continue;
    sum = sum + (robot->pose.position - geom::Point{});
    count += 1.0;
  }
  if (count == 0.0) return std::nullopt;
  return geom::Point{} + sum * (1.0 / count);
}

std::vector<PlannedPart> plan_parts(const State& state, Run& run) {
  if (run.needed.empty()) return {};
  const geom::Point goal = goal_of(*run.command);
  if (run.command->task == Task::kRally) {
    std::vector<PlannedPart> alone;
    for (const base::RobotId id : run.needed)
      alone.push_back({.members = {id}, .command = run.command, .goal = goal, .end = goal});
    return alone;
  }
  if (run.command->task == Task::kSearch) {
    SearchWay way = plan_search(*state.mission, *run.command, run.needed, places_of(state, run.needed));
    UnitCommand own = *run.command;
    own.route = std::move(way.route);
    own.margin = way.margin;
    return {{.members = run.needed,
             .command = CommandRef{std::make_shared<const UnitCommand>(std::move(own))},
             .goal = goal,
             .end = goal,
             .warning = std::move(way.warning)}};
  }
  if (info(run.command->task).is_shared) {
    // Who comes first looks at all places for the others: somebody who can.
    std::vector<base::RobotId> members = run.needed;
    std::ranges::stable_partition(members, [&](base::RobotId id) {
      const RobotState* robot = find_robot(state, id);
      return robot != nullptr && robot->is_running;
    });
    return {{.members = std::move(members), .command = run.command, .goal = goal, .end = goal}};
  }
  if (!can_divide(run)) return {{.members = run.needed, .command = run.command, .goal = goal, .end = goal}};
  run.technique = run.command->technique;
  std::vector<PlannedPart> parts;
  for (auto& members : divide(state, run)) {
    // Under bounding overwatch all are halted until all are at rest; then the first bound begins.
    const bool halted = run.technique == Technique::kBoundingOverwatch || !parts.empty();
    parts.push_back(
        {.members = std::move(members), .command = run.command, .goal = goal, .end = goal, .halted = halted});
  }
  plan_places(state, run, parts);
  return parts;
}

}  // namespace mlab::mission
