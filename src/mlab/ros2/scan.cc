#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "mlab/ros2/readings.h"

namespace mlab::ros2 {
namespace {

constexpr std::size_t kMostRanges = 100'000;
constexpr float kFarthestRange = 1000.0F;  // [m]
constexpr double kRound = 2.0 * std::numbers::pi;
constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();
constexpr float kNothing = std::numeric_limits<float>::infinity();

std::string problem_of(const LaserScan& message) {
  const std::size_t count = message.ranges.size();
  if (count == 0) return "has no beams";
  if (count > kMostRanges) return fmt::format("has {} beams: {} at most", count, kMostRanges);
  if (!(std::abs(message.angle_min) <= 2.0 * kRound))
    return fmt::format("begins at {} rad", message.angle_min);
  const double step = std::abs(static_cast<double>(message.angle_increment));
  const bool is_step = count == 1 ? std::isfinite(step) : step > 0.0;
  if (!is_step || !(step * static_cast<double>(count - 1) <= 1.01 * kRound))
    return fmt::format("has {} beams, each {} rad from the last", count, message.angle_increment);
  if (!(message.range_min >= 0.0F && message.range_max > message.range_min &&
        message.range_max <= kFarthestRange))
    return fmt::format("measures from {} m to {} m", message.range_min, message.range_max);
  return "";
}

/// REP 117: infinite where nothing was hit, minus infinite where something is too near. Many drivers say 0
/// for what they don't know.
float distance_of(float range, const LaserScan& message) {
  if (range == kNothing) return kNothing;
  if (range == -kNothing) return message.range_min;
  return range >= message.range_min && range <= message.range_max ? range : kUnknown;
}

/// Of neighbours the nearest; where nothing was hit, nothing is known unless all say that there is nothing.
float of_group(float one, float other) {
  if (std::isfinite(one) && std::isfinite(other)) return std::min(one, other);
  if (std::isfinite(one)) return one;
  if (std::isfinite(other)) return other;
  return std::isnan(one) ? one : other;
}

}  // namespace

std::string read_scan(const LaserScan& message, vehicle::Scan& out) {
  if (std::string problem = problem_of(message); !problem.empty()) return problem;
  const std::size_t count = message.ranges.size();
  const std::size_t group = (count + kMostBeams - 1) / kMostBeams;
  const double step = message.angle_increment;
  out.sensor = static_cast<std::uint32_t>(message.topic);
  out.first_angle = message.angle_min + step * static_cast<double>(group - 1) / 2.0;
  out.step = step * static_cast<double>(group);
  out.beam_width = group == 1 ? 0.0 : std::abs(out.step);
  out.nearest = message.range_min;
  out.farthest = message.range_max;
  out.distances.clear();
  for (std::size_t i = 0; i < count; ++i) {
    const float distance = distance_of(message.ranges[i], message);
    if (i % group == 0)
      out.distances.push_back(distance);
    else
      out.distances.back() = of_group(out.distances.back(), distance);
  }
  return "";
}

}  // namespace mlab::ros2
