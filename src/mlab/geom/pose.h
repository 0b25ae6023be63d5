#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "mlab/geom/vector.h"

namespace mlab::geom {

/// A difference of two world points: x east, y north [m].
struct Offset {
  double x = 0.0;
  double y = 0.0;

  friend constexpr Offset operator+(Offset a, Offset b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Offset operator-(Offset a, Offset b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Offset operator*(Offset a, double s) { return {a.x * s, a.y * s}; }
  friend constexpr bool operator==(Offset, Offset) = default;
};
inline double length(Offset o) {
  return std::sqrt(o.x * o.x + o.y * o.y);
}
/// Of length 1 in the same direction; zero where that has none.
inline Offset unit(Offset o) {
  const double l = length(o);
  return l > 0.0 ? o * (1.0 / l) : Offset{};
}
constexpr double dot(Offset a, Offset b) {
  return a.x * b.x + a.y * b.y;
}
/// Positive where b lies counter-clockwise of a.
constexpr double cross(Offset a, Offset b) {
  return a.x * b.y - a.y * b.x;
}
/// Counter-clockwise from east, in (-pi, pi] [rad].
inline double direction(Offset o) {
  return std::atan2(o.y, o.x);
}

/// A place in the world: x east, y north [m]. Not a Vector: only a Pose turns one into the other.
struct Point {
  double x = 0.0;
  double y = 0.0;

  friend constexpr Point operator+(Point p, Offset o) { return {p.x + o.x, p.y + o.y}; }
  friend constexpr Point operator-(Point p, Offset o) { return {p.x - o.x, p.y - o.y}; }
  friend constexpr Offset operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr bool operator==(Point, Point) = default;
};
inline double distance(Point a, Point b) {
  return length(a - b);
}

/// A heading [rad] whose cosine and sine are known.
struct KnownHeading {
  double heading = 0.0;
  Offset ahead{1.0, 0.0};
};
/// The place for a heading among those that this thread remembers. As many as the robots that it computes one
/// after the other have, mostly.
inline KnownHeading& remembered_heading(double heading) {
  constexpr int kBits = 7;
  thread_local std::array<KnownHeading, 1U << kBits> all;
  return all[(std::bit_cast<std::uint64_t>(heading) * 0x9e3779b97f4a7c15U) >> (64 - kBits)];
}
/// Of length 1 in the direction of a heading [rad]: its cosine and sine, which take longer to find than all
/// that is done with them. Each thread remembers some, since most of what a robot computes in a cycle is
/// turned by its own heading, or by that of its formation.
inline Offset ahead_of(double heading) {
  KnownHeading& known = remembered_heading(heading);
  if (std::bit_cast<std::uint64_t>(heading) != std::bit_cast<std::uint64_t>(known.heading))
    known = {heading, {std::cos(heading), std::sin(heading)}};
  return known.ahead;
}
/// What ahead_of a heading is, for who knows it already.
inline void remember(const KnownHeading& known) {
  remembered_heading(known.heading) = known;
}

/// Where a robot is and where it looks.
struct Pose {
  Point position;
  double heading = 0.0;  ///< counter-clockwise from east [rad]

  /// The world point as the robot sees it [m, robot frame].
  Vector to_robot(Point p) const { return to_robot(p - position); }
  /// The world direction as the robot sees it.
  Vector to_robot(Offset o) const {
    const auto [c, s] = ahead_of(heading);
    return {c * o.x + s * o.y, c * o.y - s * o.x, 0.0};
  }
  /// The robot-frame vector as a difference in the world.
  Offset to_world(Vector v) const {
    const auto [c, s] = ahead_of(heading);
    return {c * v.x - s * v.y, s * v.x + c * v.y};
  }
  /// The place that a robot-frame vector from the robot points at.
  Point point_at(Vector v) const { return position + to_world(v); }

  friend constexpr bool operator==(Pose, Pose) = default;
};

/// A straight piece between two world points.
struct Segment {
  Point a;
  Point b;
};
/// The point of the segment that is nearest to p.
inline Point nearest_point(Segment s, Point p) {
  const Offset along = s.b - s.a;
  const double l2 = dot(along, along);
  if (l2 <= 0.0) return s.a;
  const double t = dot(p - s.a, along) / l2;
  return s.a + along * (t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t);
}
/// True where the two segments have a point in common, ends included.
inline bool intersects(Segment s, Segment t) {
  const double d1 = cross(s.b - s.a, t.a - s.a);
  const double d2 = cross(s.b - s.a, t.b - s.a);
  const double d3 = cross(t.b - t.a, s.a - t.a);
  const double d4 = cross(t.b - t.a, s.b - t.a);
  if (((d1 > 0) != (d2 > 0)) && ((d3 > 0) != (d4 > 0)) && d1 != 0 && d2 != 0 && d3 != 0 && d4 != 0)
    return true;
  const auto touches = [](Segment u, Point p) { return nearest_point(u, p) == p; };
  return touches(s, t.a) || touches(s, t.b) || touches(t, s.a) || touches(t, s.b);
}

}  // namespace mlab::geom
