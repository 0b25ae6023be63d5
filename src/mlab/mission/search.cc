#include "mlab/mission/search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "mlab/mission/known_map.h"
#include "mlab/mission/parameter.h"
#include "mlab/percept/shared_route.h"
#include "mlab/ways/coverage.h"

namespace mlab::mission {
namespace {

constexpr int kSidesOfACircle = 32;
constexpr double kWorthTelling = 0.98;  // a smaller share of the area that is seen
constexpr double kLeastMargin = 0.1;    // [m]
constexpr double kNearEnough = 0.9;     // to see what lies round a thing [half of the swath]
constexpr double kOffWay = 0.15;        // a robot may be so far beside its lane [m]

// Cut into pieces of equal length; where one ends and the next begins the point stands twice. Cut where the
// way leads round something, too: a straight line from waypoint to waypoint may lead through it.
std::vector<geom::Point> cut(const ways::Coverage& found, std::size_t pieces) {
  const double piece = found.length / static_cast<double>(pieces);
  std::vector<geom::Point> out = {found.waypoints.front()};
  double left = piece;
  std::size_t cuts = 1;
  const auto go_to = [&](geom::Point from, geom::Point to) {
    for (double rest = geom::distance(from, to); cuts < pieces && rest > left;
         rest -= std::exchange(left, piece)) {
      from = from + (to - from) * (left / rest);
      if (!(from == out.back())) out.push_back(from);
      out.push_back(from);
      ++cuts;
    }
    left -= geom::distance(from, to);
  };
  for (std::size_t i = 1; i < found.waypoints.size(); ++i) {
    geom::Point from = found.waypoints[i - 1];
    for (const geom::Point corner : found.corners[i - 1]) go_to(std::exchange(from, corner), corner);
    go_to(from, found.waypoints[i]);
    if (!(found.waypoints[i] == out.back())) out.push_back(found.waypoints[i]);
  }
  return out;
}

// No shorter than some swaths, so that robots are not in each other's way.
std::size_t pieces_of(const ways::Coverage& found, const UnitCommand& command, std::size_t robots) {
  constexpr double kLeast = 3.0;
  const auto most = static_cast<std::size_t>(std::min(found.length / (kLeast * command.swath), 1e3));
  return std::clamp<std::size_t>(most, 1, std::min(percept::kMostParts, percept::kPiecesOfAShare * robots));
}

std::string warning_of(const ways::Coverage& found, const UnitCommand& command, const std::string& name) {
  using End = ways::CoverageEnd;
  switch (found.end) {
    case End::kNoArea:
      return fmt::format("{} has no area: there is nothing to search", name);
    case End::kNothingToSearch:
    case End::kUnusable:
      return fmt::format("nothing of {} can be searched: it is closed off, or too near to obstacles", name);
    case End::kTooLarge:
      return fmt::format("{} is too large for a swath of {:g} m: it is not searched", name, command.swath);
    case End::kCovered:
    case End::kPartly:
      break;
  }
  const double seen = found.visible * found.seen;
  if (seen >= kWorthTelling) return {};
  return fmt::format("the robots will see {:.0f} % of {} with a swath of {:g} m: the rest is {}",
                     std::floor(100.0 * seen), name, command.swath,
                     found.seen >= ways::Coverage::kWanted
                         ? "closed off, or too near to obstacles"
                         : "closed off, or among too many obstacles to be planned");
}

// On what ground a robot searches, and how wide it sees for certain.
struct Terms {
  Terms(const Mission& mission, const UnitCommand& command, base::RobotId robot)
      : ground(known_things(mission.overlay)),
        swath(command.swath - 2.0 * std::min(kOffWay, 0.05 * command.swath)) {
    ground.bounds = known_bounds(mission.overlay);
    for (const overlay::Barrier& one : overlay::barriers(mission.overlay)) {
      if (one.is_solid) opaque.push_back(one.segment);
    }
    const RobotType* const type = type_of(mission, robot);
    if (type == nullptr) return;
    radius = std::max(number_parameter(*type, "robot_radius", kDefaultBodyRadius), 0.0);
    margin = std::max(number_parameter(*type, "avoid_obstacle_safety_margin", kDefaultMargin), 0.0);
    // So that what lies round a thing that nobody knew of is seen on the way past it, too.
    while (margin > kLeastMargin && radius + margin > kNearEnough * 0.5 * swath) margin *= 0.5;
  }

  ways::Clearances clearances() const { return {radius, margin}; }

  ways::Ground ground;
  std::vector<geom::Segment> opaque;  // of its walls: not the edges of areas that robots only keep out of
  double radius = kDefaultBodyRadius;
  double margin = kDefaultMargin;
  double swath;
};

}  // namespace

std::vector<geom::Point> area_of(const overlay::ControlMeasure& measure) {
  const overlay::MeasureInfo& kind = overlay::info(measure.kind);
  if (kind.shape == overlay::MeasureShape::kRegion && measure.points.size() >= 3) return measure.points;
  std::vector<geom::Point> out;
  const bool is_round =
      measure.points.size() == 1 && measure.size > 0.0 && kind.size == overlay::MeasureSize::kDiameter;
  for (int i = 0; is_round && i < kSidesOfACircle; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kSidesOfACircle;
    out.push_back(measure.center() + geom::Offset{std::cos(angle), std::sin(angle)} * (measure.size / 2.0));
  }
  return out;
}

SearchWay plan_search(const Mission& mission, const UnitCommand& command,
                      const std::vector<base::RobotId>& robots, std::optional<geom::Point> from) {
  const Terms terms(mission, command, robots.front());
  const ways::Coverage found =
      ways::coverage_route(command.route, terms.ground, terms.clearances(), terms.swath, from, terms.opaque);
  SearchWay out;
  out.margin = std::max(found.clearance - terms.radius, 0.0);
  out.warning = warning_of(found, command, command.place_name);
  if (!found.waypoints.empty()) out.route = cut(found, pieces_of(found, command, robots.size()));
  return out;
}

std::string warn_of_search(const Mission& mission, const UnitCommand& command, base::RobotId robot,
                           std::optional<geom::Point> from, const std::string& name) {
  const Terms terms(mission, command, robot);
  auto outlook = ways::coverage_outlook(command.route, terms.ground, terms.clearances(), terms.swath, from,
                                        terms.opaque);
  if (!outlook) return {};
  outlook->seen = 1.0;  // of what can be seen: what a way would miss is not known yet
  return warning_of(*outlook, command, name);
}

}  // namespace mlab::mission
