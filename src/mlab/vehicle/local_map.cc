#include "mlab/vehicle/local_map.h"

#include <algorithm>
#include <cmath>

#include "mlab/base/angle.h"

namespace mlab::vehicle {
namespace {

using geom::Point;

constexpr double kGap = 0.5;     // points of neighbouring beams that are farther apart are of two things [m]
constexpr double kWidest = 1.5;  // of a thing; what is wider is several of them [m]
constexpr double kLeastRadius = 0.05;  // [m]
constexpr double kSlack = 0.25;        // by which a beam has to go beyond a thing to have gone through it [m]

Point end_of(const geom::Pose& sensor, double angle, double distance) {
  const double heading = sensor.heading + angle;
  return sensor.position + geom::Offset{std::cos(heading), std::sin(heading)} * distance;
}

// The middle of the farthest two, and half of their distance.
std::pair<Point, double> round_of(const std::vector<Point>& points) {
  const Point a = points.front();
  const Point b = points.back();
  const Point middle = a + (b - a) * 0.5;
  double radius = kLeastRadius;
  for (const Point& one : points) radius = std::max(radius, geom::distance(one, middle));
  return {middle, radius};
}

}  // namespace

bool LocalMap::is_new(const Scan& scan) {
  const auto at = std::ranges::find(seen_, scan.sensor, &Seen::sensor);
  if (at == seen_.end()) {
    seen_.push_back({scan.sensor, scan.at});
    return true;
  }
  if (scan.at <= at->at) return false;
  at->at = scan.at;
  return true;
}

void LocalMap::add(const Scan& scan, const geom::Pose& pose) {
  if (!is_new(scan)) return;
  const double c = std::cos(pose.heading);
  const double s = std::sin(pose.heading);
  const Point& on = scan.mount.position;
  const geom::Pose sensor{pose.position + geom::Offset{c * on.x - s * on.y, s * on.x + c * on.y},
                          base::wrap_angle(pose.heading + scan.mount.heading)};
  clear(scan, sensor);
  add_hits(scan, sensor);
}

// What is nearer than where the beam went that points at its middle.
void LocalMap::clear(const Scan& scan, const geom::Pose& sensor) {
  if (scan.distances.empty()) return;
  std::erase_if(things_, [&](const Thing& thing) {
    const geom::Offset to = thing.center - sensor.position;
    const double distance = geom::length(to);
    if (distance < scan.nearest) return false;
    const double angle = base::wrap_angle(std::atan2(to.y, to.x) - sensor.heading - scan.first_angle);
    const double turn = 2.0 * std::numbers::pi;
    const double from_first =
        scan.step >= 0.0 ? (angle < 0.0 ? angle + turn : angle) : (angle > 0.0 ? angle - turn : angle);
    std::size_t beam = 0;
    if (scan.step != 0.0) {
      const double place = std::round(from_first / scan.step);
      // Half a step before the first one is the first one's, too.
      const bool is_before = std::abs(std::abs(from_first) - turn) < std::abs(scan.step) / 2.0;
      beam = is_before ? 0 : static_cast<std::size_t>(place);
    } else if (std::abs(angle) > scan.beam_width / 2.0) {
      return false;
    }
    if (beam >= scan.distances.size()) return false;
    const float went = scan.distances[beam];
    if (std::isnan(went)) return false;
    const double through = std::min<double>(went, scan.farthest);
    return through > distance + thing.radius + kSlack;
  });
}

void LocalMap::add_hits(const Scan& scan, const geom::Pose& sensor) {
  const auto close = [&] {
    if (cluster_.empty()) return;
    const auto [center, radius] = round_of(cluster_);
    put({center, radius, scan.at});
    cluster_.clear();
  };
  cluster_.clear();
  for (std::size_t i = 0; i < scan.distances.size(); ++i) {
    const float distance = scan.distances[i];
    const bool is_hit = std::isfinite(distance) && distance >= scan.nearest && distance <= scan.farthest;
    if (!is_hit || distance > kReach) {
      close();
      continue;
    }
    const Point hit = end_of(sensor, scan.first_angle + scan.step * static_cast<double>(i), distance);
    const bool goes_on = !cluster_.empty() && geom::distance(cluster_.back(), hit) <= kGap &&
                         geom::distance(cluster_.front(), hit) <= kWidest;
    if (!goes_on) close();
    cluster_.push_back(hit);
  }
  close();
}

// In place of what was seen there before.
void LocalMap::put(const Thing& thing) {
  std::erase_if(things_, [&](const Thing& old) {
    return geom::distance(old.center, thing.center) <= std::max(old.radius, thing.radius) + kSlack;
  });
  if (things_.size() < kMost) things_.push_back(thing);
}

void LocalMap::age(const geom::Pose& pose, Clock::time_point now) {
  std::erase_if(things_, [&](const Thing& thing) {
    return seconds_between(thing.seen, now) > kMemory ||
           geom::distance(thing.center, pose.position) > kReach + thing.radius;
  });
}

std::span<const percept::Obstacle> LocalMap::obstacles(const geom::Pose& pose, double reach,
                                                       std::span<const percept::RobotReading> others) {
  told_.clear();
  for (const Thing& thing : things_) {
    const geom::Vector center = pose.to_robot(thing.center);
    if (geom::length(center) - thing.radius > reach) continue;
    const bool is_other = std::ranges::any_of(others, [&](const percept::RobotReading& other) {
      return geom::length(center - other.center) <= other.radius + thing.radius + kSlack;
    });
    if (!is_other) told_.push_back({center, thing.radius, {}});
  }
  std::ranges::sort(told_, {},
                    [](const percept::Obstacle& one) { return geom::length(one.center) - one.radius; });
  return told_;
}

}  // namespace mlab::vehicle
