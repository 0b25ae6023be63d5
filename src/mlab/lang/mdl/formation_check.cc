#include "mlab/lang/mdl/formation_check.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

#include <fmt/core.h>

#include "mlab/lang/mdl/quoted.h"
#include "mlab/mission/command.h"
#include "mlab/mission/parameter.h"

namespace mlab::mdl {
namespace {

// A formation of more robots is checked as if it had this many: it doesn't get smaller.
constexpr int kRobotsLookedAt = 200;
constexpr std::uint64_t kMaxGapVisits = 10'000'000;  // legs times gaps of the whole mission
constexpr double kGap = 0.6;           // between robots that plan ways, as AvoidReciprocally [m]
constexpr double kSettled = 0.5;       // of a disc: so densely they come to rest in it
constexpr double kDensest = 0.9069;    // equal discs cover no larger share of a plane
constexpr double kShortestLeg = 1e-6;  // below it there is no direction [m]

bool has_stations(percept::Formation formation) {
  return formation != percept::Formation::kNone && formation != percept::Formation::kSweep;
}

// The first members tell for the others: units of different types are small.
std::size_t looked_at(const std::vector<base::RobotId>& members) {
  return std::min<std::size_t>(members.size(), kRobotsLookedAt);
}

std::string described(const std::vector<base::RobotId>& members, percept::Formation formation) {
  return fmt::format("{} robots in {}", members.size(), percept::name(formation));
}

}  // namespace

bool leads_through(geom::Segment way, const overlay::ControlMeasure& gap) {
  if (gap.points.size() != 2) return false;
  const geom::Offset axis = gap.points[1] - gap.points[0];
  const double length = geom::length(axis);
  if (length <= 0.0) return false;
  const geom::Offset ahead = axis * (1.0 / length);
  // Along and across the gap. The way's part inside the rectangle between the rails is [from, to].
  const auto in_gap = [&](geom::Point p) {
    const geom::Offset o = p - gap.points[0];
    return geom::Offset{geom::dot(o, ahead), geom::cross(ahead, o)};
  };
  const geom::Offset begin = in_gap(way.a);
  const geom::Offset step = in_gap(way.b) - begin;
  double from = 0.0;
  double to = 1.0;
  const auto clip = [&](double at, double change, double low, double high) {
    if (change == 0.0) {
      if (at < low || at > high) from = 2.0;
      return;
    }
    const double a = (low - at) / change;
    const double b = (high - at) / change;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  };
  clip(begin.x, step.x, 0.0, length);
  clip(begin.y, step.y, -gap.size / 2.0, gap.size / 2.0);
  return from <= to && std::abs(step.x) >= std::abs(step.y);
}

FormationCheck::FormationCheck(const mission::Mission& mission, text::Diagnostics& diagnostics)
    : mission_(mission), diagnostics_(diagnostics) {
  for (const overlay::ControlMeasure& measure : mission.overlay.measures) {
    if (measure.kind == overlay::MeasureKind::kGap) gaps_.push_back(&measure);
  }
  for (const mission::RobotType& type : mission.types) {
    spacing_of_type_.push_back(
        mission::number_parameter(type, "formation_spacing", mission::kDefaultSpacing));
    radius_of_type_.push_back(mission::number_parameter(type, "robot_radius", mission::kDefaultBodyRadius));
  }
  for (const mission::Robot& robot : mission.robots) type_of_robot_[robot.id.value] = robot.type;
}

const std::vector<geom::Offset>& FormationCheck::stations(percept::Formation formation, int count) {
  const auto [entry, is_new] = stations_.try_emplace({formation, count});
  for (int rank = 0; is_new && rank < count; ++rank) {
    const geom::Vector v = percept::station(formation, rank, count, 1.0);
    entry->second.push_back({v.x, v.y});
  }
  return entry->second;
}

double FormationCheck::spacing_of(const std::vector<base::RobotId>& members) {
  double out = 0.0;
  for (std::size_t i = 0; i < looked_at(members); ++i) {
    out = std::max(out, spacing_of_type_[type_of_robot_.at(members[i].value)]);
  }
  return out;
}

Extent FormationCheck::extent(const mission::UnitCommand& command, double heading) {
  const std::vector<base::RobotId>& members = mission::members_of(mission_, command);
  const double spacing = spacing_of(members);
  double radius = 0.0;
  for (std::size_t i = 0; i < looked_at(members); ++i) {
    radius = std::max(radius, radius_of_type_[type_of_robot_.at(members[i].value)]);
  }
  const double c = std::cos(heading);
  const double s = std::sin(heading);
  Extent out;
  for (const geom::Offset station : stations(command.formation, static_cast<int>(looked_at(members)))) {
    const double x = (station.x * c - station.y * s) * spacing;
    const double y = (station.x * s + station.y * c) * spacing;
    out = {std::min(out.min_x, x), std::max(out.max_x, x), std::min(out.min_y, y), std::max(out.max_y, y)};
  }
  return {out.min_x - radius, out.max_x + radius, out.min_y - radius, out.max_y + radius};
}

void FormationCheck::check_leg(const mission::UnitCommand& command, geom::Segment leg) {
  const std::vector<base::RobotId>& members = mission::members_of(mission_, command);
  if (command.task == mission::Task::kRally) check_meeting(command);
  if (!has_stations(command.formation) || members.size() < 2) return;
  check_room(command);
  const geom::Offset way = leg.b - leg.a;
  const bool has_way = geom::length(way) > kShortestLeg;
  const double heading = command.heading.value_or(has_way ? geom::direction(way) : 0.0);
  const Extent needed = extent(command, heading);
  const overlay::Area area = mission_.overlay.mission_area();
  if (needed.width() > area.width || needed.height() > area.height) {
    diagnostics_
        .warning("formation-larger-than-area", command.place,
                 fmt::format("{} need {:.6g} by {:.6g} m, the mission area has {:.6g} by {:.6g} m",
                             described(members, command.formation), needed.width(), needed.height(),
                             area.width, area.height))
        .hints.push_back(fmt::format("neighbours stand `formation_spacing` apart, a parameter of NEW-ROBOT "
                                     "({} m where it is not given)",
                                     mission::kDefaultSpacing));
    return;
  }
  if (!has_way) return;
  gap_visits_ += gaps_.size();
  if (gap_visits_ > kMaxGapVisits) return;
  for (const overlay::ControlMeasure* gap : gaps_) {
    if (leads_through(leg, *gap)) check_gap(command, leg, heading, *gap);
  }
}

bool FormationCheck::plans_ways(const mission::RobotType& type) const {
  const bool is_planned = mission_.options.plans_ways.value_or(true);
  return type.program == "robot" &&
         mission::number_parameter(type, "plans_ways", is_planned ? 1.0 : 0.0) != 0.0;
}

// Two or three robots that only react find their places all the same; more push each other off their stations
// for ever. Only a spacing that was written is the author's doing.
void FormationCheck::check_room(const mission::UnitCommand& command) {
  const std::vector<base::RobotId>& members = mission::members_of(mission_, command);
  if (command.task != mission::Task::kOccupy || members.size() < 4) return;
  const mission::RobotType& type = mission_.types[type_of_robot_.at(members[0].value)];
  const double spacing = mission::number_parameter(type, "formation_spacing", mission::kDefaultSpacing);
  const double sphere =
      mission::number_parameter(type, "occupy_avoid_robot_sphere", mission::kDefaultRobotSphere);
  const bool is_written =
      std::any_of(type.parameters.begin(), type.parameters.end(),
                  [](const auto& parameter) { return parameter.key == "formation_spacing"; });
  if (!is_written || spacing >= sphere || plans_ways(type) || !crowded_units_.insert(command.unit).second)
    return;
  diagnostics_
      .warning("formation-tighter-than-robots", command.place,
               fmt::format("{} stand {:.6g} m apart, but push each other away within {:.6g} m",
                           described(members, command.formation), spacing, sphere))
      .hints.emplace_back(
          fmt::format("set `occupy_avoid_robot_sphere` and `navigation_avoid_robot_sphere` below {:.6g} "
                      "too, and both `..._min_range` below them",
                      spacing));
}

// Standard robots that plan ways keep a little apart also where they meet, and come to rest before they are
// packed as densely as can be.
void FormationCheck::check_crowd(const mission::UnitCommand& command, std::size_t robots, double radius) {
  const double across = 2.0 * radius + kGap;
  const double bodies_across = 2.0 * command.radius / across + 1.0;
  if (static_cast<double>(robots) <= kSettled * bodies_across * bodies_across) return;
  diagnostics_
      .warning(
          "rally-too-narrow", command.goal_place,
          fmt::format(
              "{} robots keep {:.6g} m apart: there may be no room for all of them within {:.6g} m of {}",
              robots, kGap, command.radius, in_backticks(command.place_name)))
      .hints.emplace_back("give the place a larger diameter");
}

// Standard robots that only react keep their distance also where they meet.
void FormationCheck::check_meeting(const mission::UnitCommand& command) {
  const std::vector<base::RobotId>& members = mission::members_of(mission_, command);
  if (members.size() < 2) return;
  const std::uint32_t type_number = type_of_robot_.at(members[0].value);
  const mission::RobotType& type = mission_.types[type_number];
  if (type.program != "robot") return;
  if (plans_ways(type)) {
    check_crowd(command, members.size(), radius_of_type_[type_number]);
    return;
  }
  const double sphere =
      mission::number_parameter(type, "navigation_avoid_robot_sphere", mission::kDefaultRobotSphere);
  const double spheres_across = 2.0 * command.radius / sphere + 1.0;
  if (sphere <= 0.0 || static_cast<double>(members.size()) <= kDensest * spheres_across * spheres_across)
    return;
  diagnostics_
      .warning(
          "rally-too-narrow", command.goal_place,
          fmt::format("{} robots push each other away within {:.6g} m: there may be no room for all of them "
                      "within {:.6g} m of {}",
                      members.size(), sphere, command.radius, in_backticks(command.place_name)))
      .hints.emplace_back(
          "give the place a larger diameter, or set `navigation_avoid_robot_sphere` and "
          "`navigation_avoid_robot_min_range` lower in NEW-ROBOT");
}

void FormationCheck::check_gap(const mission::UnitCommand& command, geom::Segment leg, double heading,
                               const overlay::ControlMeasure& gap) {
  // Seen along the way, the formation's heading is turned by what a HEADING clause turns it.
  const Extent needed = extent(command, heading - geom::direction(leg.b - leg.a));
  if (needed.height() <= gap.size) return;
  const std::vector<base::RobotId>& members = mission::members_of(mission_, command);
  const bool pass_in_file = plans_ways(mission_.types[type_of_robot_.at(members[0].value)]);
  auto& warning =
      diagnostics_.warning("formation-wider-than-gap", command.place,
                           fmt::format("{} are {:.6g} m wide, the gap {} on the way to {} has {:.6g} m{}",
                                       described(members, command.formation), needed.height(),
                                       in_backticks(gap.name), in_backticks(command.place_name), gap.size,
                                       pass_in_file ? ": they pass in file here" : ""));
  warning.notes.push_back({fmt::format("{} declared here", in_backticks(gap.name)), gap.place});
  if (command.formation != percept::Formation::kColumn && !pass_in_file)
    warning.hints.emplace_back("a Column is as narrow as one robot");
}

}  // namespace mlab::mdl
