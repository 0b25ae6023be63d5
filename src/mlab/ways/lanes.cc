#include "mlab/ways/lanes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace mlab::ways {
namespace {

constexpr std::size_t kMostSides = 32;  // of an outline, the longest ones, that lanes are laid along
constexpr int kOtherDirections = 16;    // that are tried besides
// Lanes end so far inside of the outline, on either side: a share of the swath.
constexpr double kEndsInside = 0.5;
// Than along longer sides, which come first: what is told is rough.
constexpr double kClearlyShorter = 0.98;

/// Directions worth trying: the fewest lanes lie along a side of the convex hull.
std::vector<geom::Offset> directions_of(std::span<const geom::Point> outline) {
  std::vector<geom::Offset> sides;
  for (std::size_t i = 0; i < outline.size(); ++i)
    sides.push_back(outline[(i + 1) % outline.size()] - outline[i]);
  std::ranges::stable_sort(sides, std::greater<>(), [](geom::Offset side) { return dot(side, side); });
  if (sides.size() > kMostSides) sides.resize(kMostSides);
  std::vector<geom::Offset> out;
  for (const geom::Offset side : sides) {
    if (length(side) > 0.0 && std::isfinite(length(side))) out.push_back(unit(side));
  }
  for (int i = 0; i < kOtherDirections; ++i) {
    const double angle = std::numbers::pi * i / kOtherDirections;
    out.push_back({std::cos(angle), std::sin(angle)});
  }
  return out;
}

/// The rectangle of that direction round the outline, with lanes in it.
std::optional<Lanes> lanes_along(geom::Offset direction, std::span<const geom::Point> outline, double swath,
                                 int most) {
  Lanes out{outline[0], direction, 0.0, 0.0, 1};
  LanePlace low;
  LanePlace high;
  for (const geom::Point corner : outline) {
    const LanePlace p = out.to_lanes(corner);
    low = {std::min(low.along, p.along), std::min(low.across, p.across)};
    high = {std::max(high.along, p.along), std::max(high.across, p.across)};
  }
  const double width = high.across - low.across;
  const double lanes = std::max(1.0, std::ceil(width / swath - 1e-9));
  if (!(lanes <= most) || !std::isfinite(high.along - low.along)) return std::nullopt;
  out.count = static_cast<int>(lanes);
  // What is much narrower than a swath gets a lane through its middle.
  const double across = std::max(width, 0.25 * swath);
  out.length = std::max(high.along - low.along, 0.25 * swath);
  out.spacing = across / lanes;
  out.origin =
      out.to_world({0.5 * (low.along + high.along - out.length), 0.5 * (low.across + high.across - across)});
  return out;
}

/// Where lines meet the outline, from low to high: the lanes, and those in the middle between two of them.
std::vector<std::vector<double>> crossings(const Lanes& lanes, std::span<const geom::Point> outline) {
  const double spacing = 0.5 * lanes.spacing;
  const double lines = 2.0 * lanes.count + 1.0;
  std::vector<std::vector<double>> out(static_cast<std::size_t>(lines));
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const LanePlace a = lanes.to_lanes(outline[i]);
    const LanePlace b = lanes.to_lanes(outline[(i + 1) % outline.size()]);
    const auto line_above = [&](double across) {
      return static_cast<std::size_t>(std::clamp(std::ceil(across / spacing), 0.0, lines));
    };
    const std::size_t last = line_above(std::max(a.across, b.across));
    for (std::size_t line = line_above(std::min(a.across, b.across)); line < last; ++line) {
      const double share = (static_cast<double>(line) * spacing - a.across) / (b.across - a.across);
      out[line].push_back(a.along + share * (b.along - a.along));
    }
  }
  for (std::vector<double>& line : out) std::ranges::sort(line);
  return out;
}

/// How long it is on all lanes, and from each piece of one to the next, were nothing on the ground [m].
double length_of(const Lanes& lanes, std::span<const geom::Point> outline, double swath) {
  const auto lines = crossings(lanes, outline);
  double out = 0.0;
  std::optional<double> middle_before;
  for (std::size_t lane = 1; lane < lines.size(); lane += 2) {
    if (lines[lane].empty()) continue;
    double from = lines[lane].front();  // the least, and the most, that it must see
    double to = lines[lane].back();
    for (const auto& beside : {lines[lane - 1], lines[lane + 1]}) {
      if (beside.empty()) continue;
      from = std::min(from, beside.front());
      to = std::max(to, beside.back());
    }
    out += std::max(0.0, to - from - 2.0 * kEndsInside * swath);
    for (std::size_t i = 1; i + 1 < lines[lane].size(); i += 2)
      out += swath - (lines[lane][i + 1] - lines[lane][i]);
    const double middle = 0.5 * (from + to);
    if (middle_before) out += length(geom::Offset{middle - *middle_before, lanes.spacing});
    middle_before = middle;
  }
  return out;
}

}  // namespace

std::optional<Lanes> shortest_lanes(std::span<const geom::Point> outline, double swath, int most) {
  std::optional<Lanes> out;
  double shortest = 0.0;
  for (const geom::Offset direction : directions_of(outline)) {
    const auto lanes = lanes_along(direction, outline, swath, most);
    if (!lanes) continue;
    const double length = length_of(*lanes, outline, swath);
    if (out && !(length < kClearlyShorter * shortest)) continue;
    out = lanes;
    shortest = length;
  }
  return out;
}

}  // namespace mlab::ways
