#pragma once

#include <cstdint>
#include <numbers>
#include <optional>
#include <string>

#include "mlab/base/id.h"
#include "mlab/geom/pose.h"
#include "mlab/percept/percepts.h"

namespace mlab::binding {

/// A body of a binding: dense, from 0, in the order in which they were given; stays valid when a body is
/// released.
using BodyIndex = base::Id<struct BodyTag>;
inline constexpr BodyIndex kNoBody{0xffffffffU};

/// How a body turns wanted velocities into motion. docs/simulator.md has the laws.
/// kSynchro: all wheels are steered together and driven together, so it turns on the spot and goes where it
/// looks, each with a motor of its own.
enum class Drive : std::uint8_t { kHolonomic, kDifferential, kCar, kSynchro };
/// The last one, for who checks numbers from outside.
inline constexpr Drive kLastDrive = Drive::kSynchro;

struct Kinematics {
  Drive drive = Drive::kHolonomic;
  double axle = 0.0;             ///< differential: distance between the wheels [m]
  double max_wheel_speed = 0.0;  ///< differential, synchro: of each wheel [m/s]; 0: no limit
  double wheelbase = 1.25;       ///< car: distance between the axles [m], > 0
  double max_steer = 1.309;      ///< car: of the front wheels, to each side [rad], < pi/2
  double max_speed = 0.0;        ///< [m/s]; 0: no limit
  double max_acceleration =
      0.0;  ///< of the velocity (holonomic), of the speed along the heading (others) [m/s^2]; 0: no limit
  double max_turn_rate = 0.0;          ///< [rad/s]; 0: no limit
  double max_turn_acceleration = 0.0;  ///< [rad/s^2]; 0: no limit

  friend bool operator==(const Kinematics&, const Kinematics&) = default;
};

/// Range sensors on the body's surface, evenly spaced: all round, or over an arc as a scanner's. They see
/// discs, walls and robots.
struct RangeRing {
  std::uint16_t count = 0;   ///< 0: no ring
  double arc = 0.0;          ///< from beam 0 to the last one, < 2 pi; 0: all round [rad]
  double first_angle = 0.0;  ///< of beam 0; the others follow counter-clockwise [rad, robot frame]
  double range = 0.0;        ///< from the surface [m]
  double beam_width =
      0.0;               ///< full angle of the cone; the nearest thing in it is told [rad]; 0: a single ray
  double noise = 0.0;    ///< standard deviation of the distance where something was hit [m]
  double dropout = 0.0;  ///< chance that a beam that hit something tells nothing, 0 .. 1

  friend bool operator==(const RangeRing&, const RangeRing&) = default;
};

/// The sensor of objects, in the middle of the body. It can be turned, and sees those whose centre is in its
/// field of view.
struct CameraSpec {
  double field_of_view = 2.0 * std::numbers::pi;  ///< full angle, 0 .. 2 pi [rad]
  double max_pan = std::numbers::pi;  ///< to each side; from pi on it turns round without end [rad]
  double max_pan_rate = 0.0;          ///< [rad/s]; 0: no limit

  friend bool operator==(const CameraSpec&, const CameraSpec&) = default;
};

/// What robots tell each other by. Signals are as strong as `signal_strength` says.
struct RadioSpec {
  double range = 0.0;  ///< from where on nothing is heard [m]; 0: it is heard everywhere, in full
  double loss = 0.0;   ///< chance that something that is told does not arrive, for each who hears it, 0 .. 1

  /// Whether all that is told arrives.
  bool is_perfect() const { return range == 0.0 && loss == 0.0; }
  friend bool operator==(const RadioSpec&, const RadioSpec&) = default;
};

/// What bodies of one kind have in common.
struct BodySpec {
  double radius = 0.2;  ///< of the disc [m], >= 0
  Kinematics kinematics;
  RangeRing ring;
  CameraSpec camera;
  RadioSpec radio;
  /// Obstacles are what the ring's beams hit, as points; else discs are told as they are, walls by rays.
  bool has_ring_obstacles = false;
  /// Its pose is counted from what its wheels turned: standard deviation of a step's length and turn, as a
  /// share of them. 0: it is told as it is.
  double odometry_noise = 0.0;

  friend bool operator==(const BodySpec&, const BodySpec&) = default;
};

/// What a body has and can do, as far as whoever runs its robot has to know.
struct Capabilities {
  double radius = 0.0;              ///< of the disc that it takes up [m]
  std::uint16_t range_sensors = 0;  ///< beams of its ring; 0: it has none
  double max_speed = 0.0;           ///< [m/s]; 0: no limit that is known
  double max_turn_rate = 0.0;       ///< [rad/s]; 0: no limit that is known
  /// How it turns wanted velocities into motion; nothing: as the mission says.
  std::optional<Kinematics> kinematics = {};
  bool overlooks = false;  ///< it may not sense all obstacles that are within the reach of its sensors

  friend bool operator==(const Capabilities&, const Capabilities&) = default;
};

/// Those of a body that is as the mission wants it.
constexpr Capabilities capabilities_of(const BodySpec& spec) {
  return {spec.radius, spec.ring.count,        spec.kinematics.max_speed, spec.kinematics.max_turn_rate,
          {},          spec.has_ring_obstacles};
}

/// A body to be put into the world.
struct BodySetup {
  BodySpec spec;
  geom::Pose pose;
  base::RobotId robot;     ///< tells the robot's requests and random streams apart; unique
  std::uint32_t unit = 0;  ///< bodies of the same unit see each other as mates; 0: of no unit
  percept::ObjectClass seen_as =
      percept::ObjectClass::kFriendlyRobot;  ///< in lists of robots and of objects, by its colour
  std::string vehicle = {};                  ///< the real vehicle that is its body; empty: none is
};

/// A body that pushes against a thing again within this time after it last did so is still in the same
/// contact [s].
inline constexpr double kSameContact = 1.0;

/// Where a body came to stand.
struct Placement {
  BodyIndex body;
  geom::Pose pose;
  bool moved = false;  ///< the wanted place was not free: this is the nearest free one
};

}  // namespace mlab::binding
