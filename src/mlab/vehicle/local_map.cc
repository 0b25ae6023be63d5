#include "mlab/vehicle/local_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

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

// The beam that looks there; nothing: none does.
// @param angle  from the mount's heading, counter-clockwise [rad]
std::optional<std::size_t> beam_at(const Scan& scan, double angle) {
  if (scan.distances.empty()) return std::nullopt;
  const double off = base::wrap_angle(angle - scan.first_angle);
  if (scan.step == 0.0)
    return std::abs(off) <= scan.beam_width / 2.0 ? std::optional<std::size_t>(0) : std::nullopt;
  // Steps to there, the way round in which beams follow each other; half a step before beam 0 is its own.
  const double round = 2.0 * std::numbers::pi / std::abs(scan.step);
  double steps = off / scan.step;
  if (steps < -0.5) steps += round;
  const double beam = std::max(0.0, std::round(steps));
  if (!(beam < static_cast<double>(scan.distances.size()))) return std::nullopt;
  return static_cast<std::size_t>(beam);
}

// Round all of them, from the middle between the first and the last.
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
  const geom::Pose sensor{pose.point_at({scan.mount.position.x, scan.mount.position.y, 0.0}),
                          base::wrap_angle(pose.heading + scan.mount.heading)};
  clear(scan, sensor);
  add_hits(scan, sensor);
}

// What is nearer than where the beam went that points at its middle.
void LocalMap::clear(const Scan& scan, const geom::Pose& sensor) {
  std::erase_if(things_, [&](const Thing& thing) {
    const geom::Offset to = thing.center - sensor.position;
    const double distance = geom::length(to);
    if (distance < scan.nearest) return false;
    const auto beam = beam_at(scan, std::atan2(to.y, to.x) - sensor.heading);
    if (!beam || std::isnan(scan.distances[*beam])) return false;
    return std::min<double>(scan.distances[*beam], scan.farthest) > distance + thing.radius + kSlack;
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
  if (things_.size() >= kMost) things_.erase(std::ranges::min_element(things_, {}, &Thing::seen));
  things_.push_back(thing);
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
