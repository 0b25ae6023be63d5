#include "mlab/model_vehicles/sonar_ring.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace mlab::model_vehicles {
namespace {

/// Readings are single precision.
constexpr double kSame = 2e-3;
constexpr double kAtEnd = 1e-9;

/// The part of a line, as shares of its length, that lies within a cone about the x axis.
struct Part {
  double from = 0.0;
  double to = 1.0;
};

/// Keeps what lies where `begin + share * change` is at most 0.
void cut(Part& part, double begin, double change) {
  if (change == 0.0) {
    if (begin > 0.0) part.to = -1.0;
    return;
  }
  const double crossing = -begin / change;
  if (change > 0.0) {
    part.to = std::min(part.to, crossing);
  } else {
    part.from = std::max(part.from, crossing);
  }
}

/// The place of a wall that a beam along x meets first.
struct Met {
  double distance = 0.0;
  double sine = 0.0;  ///< of the angle from straight on; 0 where it is an end of the wall
};

std::optional<Met> meet(geom::Vector a, geom::Vector b, double slope) {
  const geom::Vector along{b.x - a.x, b.y - a.y, 0.0};
  const double length2 = along.x * along.x + along.y * along.y;
  if (length2 <= 0.0) return std::nullopt;
  Part part;
  cut(part, a.y - slope * a.x, along.y - slope * along.x);
  cut(part, -a.y - slope * a.x, -along.y - slope * along.x);
  if (part.from > part.to) return std::nullopt;
  const double share = std::clamp(-(a.x * along.x + a.y * along.y) / length2, part.from, part.to);
  const geom::Vector place{a.x + share * along.x, a.y + share * along.y, 0.0};
  const double distance = std::sqrt(place.x * place.x + place.y * place.y);
  if (share <= kAtEnd || share >= 1.0 - kAtEnd || distance <= 0.0) return Met{distance, 0.0};
  const double dot = place.x * along.x + place.y * along.y;
  return Met{distance, std::abs(dot) / (distance * std::sqrt(length2))};
}

}  // namespace

bool is_thrown_elsewhere(const SonarSpec& spec, const geom::Pose& pose, double axis, double distance,
                         std::span<const binding::Wall> walls) {
  const geom::Pose beam{pose.position, pose.heading + axis};
  const double slope = std::tan(spec.beam_width / 2.0);
  bool is_a_wall = false;
  for (const binding::Wall& wall : walls) {
    if (!wall.is_solid) continue;
    const auto met = meet(beam.to_robot(wall.segment.a), beam.to_robot(wall.segment.b), slope);
    if (!met.has_value() || std::abs(met->distance - distance) > kSame) continue;
    if (met->sine <= std::sin(spec.glancing)) return false;
    is_a_wall = true;
  }
  return is_a_wall;
}

std::vector<float> heard(const SonarSpec& spec, const geom::Pose& pose, double edge,
                         std::span<const percept::RangeReading> readings,
                         std::span<const binding::Wall> walls, base::Random& random) {
  std::vector<float> distances;
  for (const percept::RangeReading& reading : readings) {
    const double noise = spec.noise * random.normal();
    const bool is_lost = random.uniform() < spec.dropout;
    const double there = reading.distance;
    const double told = std::max(there + noise, spec.nearest);
    const bool is_heard = reading.hit && !is_lost && told <= spec.range &&
                          !is_thrown_elsewhere(spec, pose, reading.angle, edge + there, walls);
    distances.push_back(is_heard ? static_cast<float>(told) : std::numeric_limits<float>::infinity());
  }
  return distances;
}

}  // namespace mlab::model_vehicles
