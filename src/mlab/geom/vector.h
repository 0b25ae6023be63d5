#pragma once

#include <cmath>

namespace mlab::geom {

/// A vector in the robot's own frame: x ahead, y to the left, z up [m, or share of full strength].
/// What motor schemas put out and what perception tells of the surroundings.
struct Vector {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;

  constexpr Vector& operator+=(Vector v) { return x += v.x, y += v.y, z += v.z, *this; }
  constexpr Vector& operator-=(Vector v) { return x -= v.x, y -= v.y, z -= v.z, *this; }
  constexpr Vector& operator*=(double s) { return x *= s, y *= s, z *= s, *this; }

  friend constexpr Vector operator+(Vector a, Vector b) { return a += b; }
  friend constexpr Vector operator-(Vector a, Vector b) { return a -= b; }
  friend constexpr Vector operator-(Vector a) { return {-a.x, -a.y, -a.z}; }
  friend constexpr Vector operator*(Vector a, double s) { return a *= s; }
  friend constexpr Vector operator*(double s, Vector a) { return a *= s; }
  friend constexpr bool operator==(Vector, Vector) = default;
};

/// Length in the plane; z does not count. Written out because the loop calls it: std::hypot guards against
/// overflow that metres never reach and costs ten times as much.
inline double length(Vector v) {
  return std::sqrt(v.x * v.x + v.y * v.y);
}
constexpr double dot(Vector a, Vector b) {
  return a.x * b.x + a.y * b.y;
}
/// Positive where b lies to the left of a.
constexpr double cross(Vector a, Vector b) {
  return a.x * b.y - a.y * b.x;
}
/// Direction counter-clockwise from ahead, in (-pi, pi] [rad]; 0 for the zero vector.
inline double direction(Vector v) {
  return std::atan2(v.y, v.x);
}
/// The vector of length `magnitude` in the direction `angle` [rad, counter-clockwise from ahead].
inline Vector polar(double magnitude, double angle) {
  return {magnitude * std::cos(angle), magnitude * std::sin(angle), 0.0};
}
/// Turned counter-clockwise by `angle` [rad] about the z axis.
inline Vector rotated(Vector v, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y, v.z};
}
/// Shorter than this counts as no direction at all [m].
inline constexpr double kZeroLength = 1e-5;
/// Same direction in the plane, length 1; the zero vector where there is no direction. z is dropped.
inline Vector unit(Vector v) {
  const double l = length(v);
  return l > kZeroLength ? Vector{v.x / l, v.y / l, 0.0} : Vector{};
}

}  // namespace mlab::geom
