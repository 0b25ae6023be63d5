#include "mlab/schema/reciprocal.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "mlab/base/up_to.h"

namespace mlab::schema {
namespace {

using geom::Offset;

// Lines that meet in a point leave it, whatever is rounded: standing still is always permitted by what stands
// [m/s].
constexpr double kRounding = 1e-9;
// More of them are left out, the last ones.
constexpr std::size_t kMost = 24;

/// Velocities to the left of a line are permitted.
struct HalfPlane {
  Offset point;
  Offset direction;  // of length 1

  double lack(Offset v) const { return cross(direction, point - v); }  // > 0: not permitted
};

Offset turned_left(Offset v) {
  return {-v.y, v.x};
}
Offset turned_right(Offset v) {
  return {v.y, -v.x};
}

// The velocities that meet nobody within the horizon, relative to the other, are those outside of a cone
// with a round tip; the line touches it where the relative velocity leaves it soonest.
HalfPlane half_plane(const Traffic& other, Offset now, double cycle) {
  const Offset relative = now - other.velocity;
  const double reach2 = other.reach * other.reach;
  const double distance2 = dot(other.place, other.place);
  const double part = other.shares ? 0.5 : 1.0;
  const bool is_apart = distance2 > reach2;
  const double time = is_apart ? other.horizon : cycle;
  const Offset from_tip = relative - other.place * (1.0 / time);
  const double along = dot(from_tip, other.place);
  Offset direction;
  Offset change;
  if (!is_apart || (along < 0.0 && along * along > reach2 * dot(from_tip, from_tip))) {
    const double length = geom::length(from_tip);
    const Offset out = length > 1e-9 ? from_tip * (1.0 / length) : unit(other.place) * -1.0;
    direction = turned_right(out);
    change = out * (other.reach / time - length);
  } else {
    const double leg = std::sqrt(distance2 - reach2);
    const Offset to = other.place;
    const Offset side = turned_left(to) * other.reach;
    // Of the two sides of the cone the nearer one.
    direction = cross(to, from_tip) > 0.0 ? (to * leg + side) * (1.0 / distance2)
                                          : (to * leg - side) * (-1.0 / distance2);
    change = direction * dot(relative, direction) - relative;
  }
  return {now + change * part, direction};
}

// On a line, within the circle of the fastest and what the lines before it permit: the place nearest to the
// wanted one, or the farthest in a direction.
std::optional<Offset> on_line(std::span<const HalfPlane> lines, std::size_t which, double fastest,
                              Offset wanted, bool is_direction) {
  const HalfPlane& line = lines[which];
  const double along = dot(line.point, line.direction);
  const double room = along * along + fastest * fastest - dot(line.point, line.point);
  if (room < 0.0) return std::nullopt;
  double low = -along - std::sqrt(room);
  double high = -along + std::sqrt(room);
  for (const HalfPlane& other : lines.first(which)) {
    const double slope = cross(line.direction, other.direction);
    const double gap = cross(other.direction, line.point - other.point);
    if (std::abs(slope) <= 1e-9) {
      if (gap < 0.0) return std::nullopt;
      continue;
    }
    const double at = gap / slope;
    if (slope >= 0.0)
      high = std::min(high, at);
    else
      low = std::max(low, at);
    if (low > high + kRounding) return std::nullopt;
  }
  high = std::max(low, high);
  const double best = is_direction ? (dot(wanted, line.direction) > 0.0 ? high : low)
                                   : std::clamp(dot(line.direction, wanted - line.point), low, high);
  return line.point + line.direction * best;
}

struct Best {
  Offset velocity;
  std::size_t met = 0;  // so many of the lines permit it
};

Best best_within(std::span<const HalfPlane> lines, double fastest, Offset wanted, bool is_direction) {
  Offset out = wanted;
  if (is_direction)
    out = wanted * fastest;
  else if (length(wanted) > fastest)
    out = unit(wanted) * fastest;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].lack(out) <= 0.0) continue;
    const auto there = on_line(lines, i, fastest, wanted, is_direction);
    if (!there) return {out, i};
    out = *there;
  }
  return {out, lines.size()};
}

// Where not all can be met: what lacks least of those that share; the hard ones are met.
Offset least_lack(std::span<const HalfPlane> lines, std::size_t hard, std::size_t failed, double fastest,
                  Offset out) {
  double lack = 0.0;
  for (std::size_t i = std::max(failed, hard); i < lines.size(); ++i) {
    if (lines[i].lack(out) <= lack) continue;
    base::UpTo<HalfPlane, kMost> among;
    for (std::size_t j = 0; j < hard; ++j) among.add(lines[j]);
    for (std::size_t j = hard; j < i; ++j) {
      HalfPlane between;
      const double slope = cross(lines[i].direction, lines[j].direction);
      if (std::abs(slope) <= 1e-9) {
        if (dot(lines[i].direction, lines[j].direction) > 0.0) continue;
        between.point = (lines[i].point + lines[j].point) * 0.5;
      } else {
        const double at = cross(lines[j].direction, lines[i].point - lines[j].point) / slope;
        between.point = lines[i].point + lines[i].direction * at;
      }
      between.direction = unit(lines[j].direction - lines[i].direction);
      among.add(between);
    }
    const Best best = best_within(among.all(), fastest, turned_left(lines[i].direction), true);
    if (best.met == among.size()) out = best.velocity;
    lack = lines[i].lack(out);
  }
  return out;
}

}  // namespace

geom::Offset reciprocal_velocity(geom::Offset wanted, geom::Offset now, std::span<const Traffic> traffic,
                                 double cycle, double fastest) {
  base::UpTo<HalfPlane, kMost> lines;
  std::size_t hard = 0;
  for (const Traffic& other : traffic.first(std::min(traffic.size(), kMost))) {
    lines.add(half_plane(other, now, cycle));
    if (!other.shares && !other.passes) hard = lines.size();
  }
  const Best best = best_within(lines.all(), fastest, wanted, false);
  if (best.met == lines.size()) return best.velocity;
  return least_lack(lines.all(), hard, best.met, fastest, best.velocity);
}

geom::Offset SeenRobots::velocity_of(base::RobotId robot, geom::Point place, double dt) const {
  const auto seen = std::span(seen_).first(count_);
  const auto before = std::ranges::find(seen, robot, &Seen::robot);
  return before == seen.end() || dt <= 0.0 ? geom::Offset{} : (place - before->place) * (1.0 / dt);
}

}  // namespace mlab::schema
