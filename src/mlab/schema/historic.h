#pragma once

#include <cmath>

#include "mlab/base/angle.h"
#include "mlab/geom/vector.h"
#include "mlab/schema/constants.h"

/// The vector names of the historic toolset, so that procedures written against nothing else compile. New
/// procedures use the names of mlab/schema/vector_sum.h, geom and std. The functions change their first
/// argument where it may be changed, and return the result in any case, so both styles of use work. Angles
/// are in degrees here.

namespace mlab::schema {

// NOLINTBEGIN(readability-identifier-naming): these are names that others gave.

inline constexpr double GT_INFINITY = kInfinity;
inline constexpr int INT_INFINITY = 10'000'000;
inline constexpr double EPS_ZERO = geom::kZeroLength;
#ifndef TRUE
inline constexpr bool TRUE = true;
#endif
#ifndef FALSE
inline constexpr bool FALSE = false;
#endif

inline double len_2d(geom::Vector v) {
  return geom::length(v);
}
inline double len_3d(geom::Vector v) {
  return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

inline geom::Vector& VECTOR_CLEAR(geom::Vector& v) {
  return v = geom::Vector{};
}
inline geom::Vector& VECTOR_ZERO(geom::Vector& v) {
  return v = geom::Vector{};
}

/// Length 1 in the plane, z kept; a vector without direction becomes zero.
inline geom::Vector unit_2d(const geom::Vector& v) {
  const geom::Vector u = geom::unit(v);
  return {u.x, u.y, v.z};
}
inline geom::Vector& unit_2d(geom::Vector& v) {
  return v = unit_2d(static_cast<const geom::Vector&>(v));
}
/// Length 1 in space; unlike its model it leaves a vector without direction at zero instead of dividing by
/// zero.
inline geom::Vector unit_3d(const geom::Vector& v) {
  const double length = len_3d(v);
  return length > EPS_ZERO ? v * (1.0 / length) : geom::Vector{};
}
inline geom::Vector& unit_3d(geom::Vector& v) {
  return v = unit_3d(static_cast<const geom::Vector&>(v));
}

/// a += b, in the plane or in space; with three arguments out = a + b.
inline geom::Vector& plus_2d(geom::Vector& a, geom::Vector b) {
  return a += {b.x, b.y, 0.0};
}
inline geom::Vector& plus_3d(geom::Vector& a, geom::Vector b) {
  return a += b;
}
inline geom::Vector plus_2d(const geom::Vector& a, geom::Vector b) {
  return a + geom::Vector{b.x, b.y, 0.0};
}
inline geom::Vector plus_3d(const geom::Vector& a, geom::Vector b) {
  return a + b;
}
inline geom::Vector& plus_2d(geom::Vector& out, geom::Vector a, geom::Vector b) {
  return out = {a.x + b.x, a.y + b.y, out.z};
}
inline geom::Vector& plus_3d(geom::Vector& out, geom::Vector a, geom::Vector b) {
  return out = a + b;
}
inline geom::Vector& minus_2d(geom::Vector& a, geom::Vector b) {
  return a -= {b.x, b.y, 0.0};
}
inline geom::Vector& minus_3d(geom::Vector& a, geom::Vector b) {
  return a -= b;
}
inline geom::Vector minus_2d(const geom::Vector& a, geom::Vector b) {
  return a - geom::Vector{b.x, b.y, 0.0};
}
inline geom::Vector minus_3d(const geom::Vector& a, geom::Vector b) {
  return a - b;
}
inline geom::Vector& minus_2d(geom::Vector& out, geom::Vector a, geom::Vector b) {
  return out = {a.x - b.x, a.y - b.y, out.z};
}
inline geom::Vector& minus_3d(geom::Vector& out, geom::Vector a, geom::Vector b) {
  return out = a - b;
}
inline geom::Vector& times_2d(geom::Vector& v, double s) {
  return v = {v.x * s, v.y * s, v.z};
}
inline geom::Vector& times_3d(geom::Vector& v, double s) {
  return v *= s;
}
inline geom::Vector times_2d(const geom::Vector& v, double s) {
  return {v.x * s, v.y * s, v.z};
}
inline geom::Vector times_3d(const geom::Vector& v, double s) {
  return v * s;
}

/// Other spellings of plus and times.
template <class... Arguments>
decltype(auto) add_2d(Arguments&&... arguments) {
  return plus_2d(static_cast<Arguments&&>(arguments)...);
}
template <class... Arguments>
decltype(auto) add_3d(Arguments&&... arguments) {
  return plus_3d(static_cast<Arguments&&>(arguments)...);
}
template <class... Arguments>
decltype(auto) mult_2d(Arguments&&... arguments) {
  return times_2d(static_cast<Arguments&&>(arguments)...);
}
template <class... Arguments>
decltype(auto) mult_3d(Arguments&&... arguments) {
  return times_3d(static_cast<Arguments&&>(arguments)...);
}

/// Turned counter-clockwise about the z axis by an angle in degrees.
inline geom::Vector rotate_z(const geom::Vector& v, double angle_deg) {
  return geom::rotated(v, base::radians(angle_deg));
}
inline geom::Vector& rotate_z(geom::Vector& v, double angle_deg) {
  return v = rotate_z(static_cast<const geom::Vector&>(v), angle_deg);
}

// NOLINTEND(readability-identifier-naming)

}  // namespace mlab::schema
