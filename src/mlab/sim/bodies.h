#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mlab/percept/percepts.h"
#include "mlab/sim/body.h"

namespace mlab::sim {

/// What bodies meet, as one number: the kind in the upper two bits, the index below.
using Thing = std::uint32_t;
constexpr Thing thing_of_body(std::uint32_t body) {
  return body;
}
constexpr Thing thing_of_disc(std::uint32_t disc) {
  return (1U << 30) | disc;
}
constexpr Thing thing_of_roamer(std::uint32_t roamer) {
  return (1U << 30) | (1U << 29) | roamer;
}
constexpr Thing thing_of_wall(std::uint32_t group) {
  return (2U << 30) | (group & ((1U << 30) - 1));
}
/// The edge of the mission area, which doesn't count as a thing.
inline constexpr Thing kNoThing = 3U << 30;
constexpr bool is_body(Thing thing) {
  return (thing >> 30) == 0;
}
constexpr bool is_disc(Thing thing) {
  return (thing >> 29) == 2;
}
constexpr bool is_roamer(Thing thing) {
  return (thing >> 29) == 3;
}

/// The last things that a body met, so that the same contact isn't counted twice.
struct Touched {
  std::array<Thing, 4> thing{};
  std::array<double, 4> until{-1, -1, -1, -1};  ///< meeting it before this time is still the same contact [s]

  /// Notes that it is met. @return whether that is a new contact
  bool meet(Thing met, double time);
};

/// All bodies, one array for each property, by BodyIndex.
struct Bodies {
  std::vector<double> x, y;         ///< [m]
  std::vector<double> heading;      ///< [rad]
  std::vector<geom::Offset> ahead;  ///< cosine and sine of the heading
  std::vector<double> radius;       ///< [m]
  std::vector<Momentum> momentum;
  std::vector<geom::Pose> counted;  ///< where a body whose pose is counted from its wheels believes to be
  std::vector<double> distance;     ///< driven [m]
  std::vector<std::uint32_t> contacts;
  std::vector<std::uint32_t> run_over;  ///< how often by a roamer
  std::vector<Touched> touched;
  std::vector<std::uint32_t> kind;  ///< index of what the spec was prepared to
  std::vector<base::RobotId> robot;
  std::vector<std::uint32_t> unit;
  std::vector<percept::ObjectClass> seen_as;
  std::vector<double> pan;             ///< of the camera, counter-clockwise from ahead [rad]
  std::vector<std::uint32_t> carried;  ///< index of the object + 1; 0: none
  std::vector<std::uint8_t> present;
  std::vector<std::uint8_t> is_guest;  ///< moves only where somebody puts it, for it is of elsewhere
  std::vector<std::uint8_t> held;      ///< must stay in the mission area

  std::size_t count() const { return x.size(); }
  geom::Point position(std::size_t i) const { return {x[i], y[i]}; }
  /// @param looks  cosine and sine of the pose's heading
  void put(std::size_t i, const geom::Pose& pose, geom::Offset looks) {
    x[i] = pose.position.x;
    y[i] = pose.position.y;
    heading[i] = pose.heading;
    ahead[i] = looks;
  }
};

}  // namespace mlab::sim
