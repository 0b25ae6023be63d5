#include "mlab/mission/search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <utility>

#include "mlab/mission/known_map.h"
#include "mlab/mission/parameter.h"
#include "mlab/percept/shared_route.h"
#include "mlab/ways/coverage.h"

namespace mlab::mission {
namespace {

constexpr std::size_t kMostShares = percept::kMostParts / percept::kPiecesOfAShare;
constexpr int kSidesOfACircle = 32;
constexpr double kWorthTelling = 0.98;  // a smaller share of the area that is seen
constexpr double kLeastMargin = 0.1;    // [m]
constexpr double kNearEnough = 0.9;     // to see what lies round a thing [half of the swath]
constexpr double kLongestDetour = 0.2;  // that a robot may make on either side [swaths]
constexpr double kOffWay = 0.15;        // a robot may be so far beside its lane [m], or
constexpr double kOffNarrowWay = 0.08;  // so far where that is less [swaths]

// The way of a share: its waypoints, with the corners in between. Where it makes a detour one of these counts
// as a waypoint, too, so that a robot does not go round on the other side, which sees something else.
struct Way {
  Way(const ways::Coverage& found, std::size_t share, double longest_detour) {
    const std::size_t first = found.shares[share];
    const bool is_last = share + 1 == found.shares.size();
    const std::size_t end = is_last ? found.waypoints.size() : found.shares[share + 1];
    points = {found.waypoints[first]};
    is_waypoint = {true};
    for (std::size_t i = first + 1; i < end; ++i) {
      const auto& corners = found.corners[i - 1];
      const std::size_t middle = points.size() + corners.size() / 2;
      const double before = length;
      for (const geom::Point corner : corners) add(corner, false);
      add(found.waypoints[i], true);
      const double detour = length - before - geom::distance(found.waypoints[i - 1], found.waypoints[i]);
      if (!corners.empty() && detour > longest_detour) is_waypoint[middle] = true;
    }
  }
  void add(geom::Point p, bool is_one) {
    length += geom::distance(points.back(), p);
    points.push_back(p);
    is_waypoint.push_back(is_one);
  }

  std::vector<geom::Point> points;
  std::vector<bool> is_waypoint;
  double length = 0.0;
};

// Its waypoints, cut into pieces of equal length; where one ends and the next begins the point stands twice.
// Cut where the way leads round something, too: a straight line from waypoint to waypoint may lead through
// it.
std::vector<geom::Point> cut(const Way& way, std::size_t pieces) {
  const double piece = way.length / static_cast<double>(pieces);
  std::vector<geom::Point> out = {way.points.front()};
  double left = piece;
  std::size_t cuts = 1;
  for (std::size_t i = 1; i < way.points.size(); ++i) {
    geom::Point from = way.points[i - 1];
    const geom::Point to = way.points[i];
    for (double rest = geom::distance(from, to); cuts < pieces && rest > left;
         rest -= std::exchange(left, piece)) {
      from = from + (to - from) * (left / rest);
      if (!(from == out.back())) out.push_back(from);
      out.push_back(from);
      ++cuts;
    }
    left -= geom::distance(from, to);
    if (way.is_waypoint[i] && !(to == out.back())) out.push_back(to);
  }
  return out;
}

// Of one share that is for so many robots: no shorter than some swaths, so that they are not in each other's
// way.
std::size_t pieces_of(const ways::Coverage& found, const UnitCommand& command, std::size_t robots) {
  constexpr double kLeast = 3.0;
  const auto most = static_cast<std::size_t>(std::min(found.length / (kLeast * command.swath), 1e3));
  return std::clamp<std::size_t>(most, 1, std::min(percept::kMostParts, percept::kPiecesOfAShare * robots));
}

// As percept::piece reads it.
std::vector<geom::Point> route_of(const ways::Coverage& found, const UnitCommand& command,
                                  std::size_t robots) {
  if (found.waypoints.empty()) return {};
  const std::size_t pieces =
      found.shares.size() == 1 ? pieces_of(found, command, robots) : percept::kPiecesOfAShare;
  std::vector<geom::Point> out;
  for (std::size_t share = 0; share < found.shares.size(); ++share) {
    const auto way = cut(Way(found, share, kLongestDetour * command.swath), pieces);
    if (!out.empty() && !(way.front() == out.back())) out.insert(out.end(), 2, way.front());
    out.insert(out.end(), way.begin(), way.end());
  }
  return out;
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
      return fmt::format(
          "{} is too large for a swath of {:g} m: it is not searched; choose a wider one, or divide it", name,
          command.swath);
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
        swath(command.swath - 2.0 * std::min(kOffWay, kOffNarrowWay * command.swath)) {
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
                      const std::vector<base::RobotId>& robots, std::span<const geom::Point> places) {
  const Terms terms(mission, command, robots.front());
  const ways::Coverage found =
      ways::coverage_route(command.route, terms.ground, terms.clearances(), terms.swath,
                           places.first(std::min(places.size(), kMostShares)), terms.opaque);
  SearchWay out;
  out.margin = std::max(found.clearance - terms.radius, 0.0);
  out.warning = warning_of(found, command, command.place_name);
  out.route = route_of(found, command, robots.size());
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
