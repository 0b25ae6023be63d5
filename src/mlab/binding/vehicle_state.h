#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace mlab::binding {

/// What failsafes look at of a body that is a vehicle.
struct Upkeep {
  double motion_age = 0.0;             ///< so old is the newest that it has said of its place [s]
  std::optional<double> battery = {};  ///< share that is left, as it said last, 0 .. 1; nothing: it never has
  double battery_age = 0.0;            ///< since it was so, or else since the vehicle was heard first [s]

  friend bool operator==(const Upkeep&, const Upkeep&) = default;
};

/// What is known of a vehicle, for people. Ages are by the run's time, at this moment of it.
struct VehicleState {
  /// Whether it would do what it is told.
  enum class Readiness : std::uint8_t {
    kUnheard,  ///< nothing has come from its process yet
    kAbsent,   ///< its process has no device
    kSilent,   ///< its device says nothing
    kNotReady,
    kReady,
    kFaulty,
    kStandby,  ///< being driven makes it ready
    kTaken,    ///< a pilot, or somebody else, has it; it is left to him
  };
  /// Whose commands it carries out.
  enum class Driver : std::uint8_t { kNobody, kThisRun, kAnotherRun };
  struct Battery {
    double share = 0.0;    ///< that is left, 0 .. 1
    double voltage = 0.0;  ///< [V]; 0: it isn't told
    double age = 0.0;      ///< [s]
  };
  /// One that measures distances.
  struct Sensor {
    std::uint32_t number = 0;
    std::uint32_t beams = 0;
    double farthest = 0.0;    ///< [m]
    double beam_width = 0.0;  ///< full angle of a beam; 0: a ray [rad]
    double age = 0.0;         ///< [s]
  };

  std::string name;  ///< in its fleet
  std::string kind;  ///< for people: `MAVLink rover at udp:14550`
  Readiness readiness = Readiness::kUnheard;
  std::string why;             ///< it is not ready, as a sentence without its subject: `is not armed`
  std::uint64_t number = 0;    ///< of its newest report; 0: none has come
  double age = 0.0;            ///< of that report; without one since the run began [s]
  std::optional<double> trip;  ///< from a command to a report that says that it was carried out [s]
  Driver driver = Driver::kNobody;
  bool is_stopped = false;           ///< an emergency stop holds there
  bool is_global = false;            ///< it knows its place on the map; else it counts its way
  std::optional<double> motion_age;  ///< [s]; nothing: it does not say where it is
  std::optional<Battery> battery;
  std::vector<Sensor> sensors;  ///< by number
};

}  // namespace mlab::binding
