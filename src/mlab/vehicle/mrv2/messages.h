#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "mlab/geom/pose.h"
#include "mlab/vehicle/mrv2/frames.h"

namespace mlab::vehicle::mrv2 {

// What is said over the line. docs/vehicles_mrv2.md has the bytes.

/// Told by the vehicle when it is asked: what it is and how it is set.
struct Identity {
  std::uint16_t boot = 0;  ///< another number each time it is switched on
  bool lurches = false;
  double radius = 0.0;            ///< [m]
  double max_speed = 0.0;         ///< [m/s]
  double max_turn_rate = 0.0;     ///< [rad/s]
  double max_acceleration = 0.0;  ///< [m/s^2]
  double watchdog = 0.0;          ///< so long after the last command it brakes [s]
  std::uint8_t sensors = 0;       ///< of its ring; sensor 0 looks ahead, the others follow counter-clockwise
  double range = 0.0;             ///< of each, from the vehicle's edge [m]
  double nearest = 0.0;           ///< what is nearer to the edge is told as this far [m]
  double beam_width = 0.0;        ///< full angle [rad]
  friend bool operator==(const Identity&, const Identity&) = default;
};

/// Told by the vehicle ten times a second.
struct State {
  enum Flag : std::uint8_t { kStopPressed = 1, kMotorFault = 2 };
  std::uint16_t boot = 0;
  std::uint32_t time = 0;  ///< since it was switched on [ms]
  geom::Pose pose;         ///< by its shaft encoders, from where it was switched on
  double speed = 0.0;      ///< [m/s]
  double turn_rate = 0.0;  ///< [rad/s]
  std::uint8_t flags = 0;
  double voltage = 0.0;  ///< [V]
  double charge = 0.0;   ///< share of the battery that is left, 0 .. 1
  friend bool operator==(const State&, const State&) = default;
};

/// Told by the vehicle five times a second: what its sensors heard.
struct Ranges {
  std::uint16_t boot = 0;
  std::uint32_t time = 0;        ///< since it was switched on [ms]
  std::vector<float> distances;  ///< from its edge [m]; infinite: no echo; not a number: it did not fire
};

/// Told to the vehicle: how to move, and until when this holds.
struct Drive {
  std::uint16_t boot = 0;        ///< of whom it is meant for
  std::uint32_t good_until = 0;  ///< on its own clock [ms]; later it is as though it had never come
  double speed = 0.0;            ///< [m/s]
  double turn_rate = 0.0;        ///< [rad/s]
  friend bool operator==(const Drive&, const Drive&) = default;
};

/// Told to the vehicle: to brake, and to forget what it was told.
struct Stop {
  friend bool operator==(const Stop&, const Stop&) = default;
};

/// Told to the vehicle: to say its identity.
struct Ask {
  friend bool operator==(const Ask&, const Ask&) = default;
};

using Message = std::variant<Identity, State, Ranges, Drive, Stop, Ask>;

/// As a frame. Values are rounded to what the line carries, and cut to what fits into it; what is no number
/// counts as 0.
std::string bytes_of(const Message& message);
/// Nothing: its type is not known, it is not as long as it has to be, or something in it can't be.
std::optional<Message> message_of(const Frame& frame);

}  // namespace mlab::vehicle::mrv2
