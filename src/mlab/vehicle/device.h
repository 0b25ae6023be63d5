#pragma once

#include <chrono>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "mlab/binding/body.h"
#include "mlab/geography/geo_point.h"
#include "mlab/geom/pose.h"
#include "mlab/vehicle/check.h"

namespace mlab::vehicle {

/// Nobody sets it; times of vehicles' own clocks are put onto it when something of theirs arrives.
using Clock = std::chrono::steady_clock;

inline double seconds_between(Clock::time_point before, Clock::time_point after) {
  return std::chrono::duration<double>(after - before).count();
}

/// What a vehicle is, and what it may be asked for. It holds whatever a mission or a behavior says.
struct Limits {
  binding::Kinematics kinematics;  ///< never holonomic
  double radius = 0.3;             ///< of the disc that it takes up [m]
  double min_speed = 0.0;          ///< backwards, <= 0 [m/s]; 0: it does not go backwards
  /// So long after the last command it stands, whatever becomes of the device's driver or the way to it [s].
  double standstill = 1.0;
};

/// What a vehicle is told to do, until it is told otherwise or `Limits::standstill` is over.
struct Command {
  double speed = 0.0;      ///< along its heading [m/s]; less than 0: backwards
  double turn_rate = 0.0;  ///< counter-clockwise [rad/s]
  friend bool operator==(const Command&, const Command&) = default;
};

/// Where a vehicle is and how it moves, as it says itself.
struct Motion {
  geom::Pose pose;         ///< in the frame of its odometry, or of its map, see `Report::is_global`
  double speed = 0.0;      ///< along its heading [m/s]
  double turn_rate = 0.0;  ///< counter-clockwise [rad/s]
  Clock::time_point at;    ///< when it was so
};

/// What one sensor of distances saw at once.
struct Scan {
  std::uint32_t sensor = 0;  ///< tells the vehicle's sensors apart
  geom::Pose mount;          ///< of the sensor on the vehicle: beams begin there [m, rad, robot frame]
  double first_angle = 0.0;  ///< of beam 0, from the mount's heading, counter-clockwise [rad]
  double step = 0.0;         ///< from each beam to the next [rad]
  double beam_width = 0.0;   ///< full angle of a beam; 0: a ray [rad]
  double nearest = 0.0;      ///< what is nearer than this it can't see [m]
  double farthest = 0.0;     ///< what is beyond it can't see [m]
  /// By beam, from the mount [m]; infinite: nothing was there up to `farthest`; not a number: nothing is
  /// known.
  std::vector<float> distances;
  Clock::time_point at;
  /// Where the vehicle was then, in the frame of its motions; nothing: devices need not know.
  std::optional<geom::Pose> pose = {};
};

/// A point in the frame of its motions of which it knows where on the Earth it is.
struct Fix {
  geography::GeoPoint place;
  geom::Point point;   ///< [m]
  double north = 0.0;  ///< where true north is there, counter-clockwise from the frame's x [rad]
  Clock::time_point at;
};

/// Of its battery.
struct Battery {
  double share = 0.0;    ///< that is left, 0 .. 1
  double voltage = 0.0;  ///< [V]; 0: it isn't told
  Clock::time_point at;
};

/// Whether a vehicle will do what it is told.
enum class Readiness : std::uint8_t {
  kAbsent,    ///< its device is not there, or can't be opened
  kSilent,    ///< nothing has been heard of it for too long
  kNotReady,  ///< it is there, and would not move whatever it is told: its own failsafe acts, it lacks
              ///< something
  kReady,
  kFaulty,   ///< it says that something of it does not work
  kStandby,  ///< it would not move yet; `drive` makes it ready: arms it, changes its mode
  kTaken,    ///< somebody else has it: a pilot, another ground station, who pressed its own emergency stop
};
inline constexpr Readiness kLastReadiness = Readiness::kTaken;  // their numbers stand in recordings

/// What is known of a vehicle at a moment. Only what it said; nothing is made up, and what it has not said
/// for too long is not there any more.
struct Report {
  Readiness readiness = Readiness::kAbsent;
  std::string why;               ///< it is not ready, as a sentence without its subject: `is not armed`
  std::optional<Motion> motion;  ///< the newest
  bool is_global = false;        ///< its pose is in the world's frame; else it begins anywhere, and drifts
  std::optional<Fix> fix;        ///< the newest
  std::vector<Scan> scans;       ///< the newest of each sensor, by its number
  std::optional<Battery> battery;
};

/// A vehicle, over whatever connects it. All is called by one thread; nothing blocks for longer than some
/// milliseconds. A device that is away is looked for again by `work`, for as long as it takes; one that comes
/// back stands until the next `drive`.
class Device {
 public:
  Device() = default;
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;
  /// Tells the vehicle to stop, where it can be told.
  virtual ~Device() = default;

  /// What it is, for people: `MAVLink rover at udp:14550`.
  virtual const std::string& name() const = 0;
  virtual const Limits& limits() const = 0;
  /// Reads what has come, and says what is due by itself (that somebody is there, what is to be told how
  /// often). To be called at least every 50 ms.
  virtual void work(Clock::time_point now) = 0;
  /// What it is like now. Valid until the next call.
  virtual const Report& report(Clock::time_point now) = 0;
  /// What happened since this was called last, for people at the vehicle, the oldest first, a line each.
  virtual std::vector<std::string> take_news() { return {}; }
  /// What of it is to be looked at before a mission, beside limits and report; nothing is made up. In an
  /// order that stays.
  virtual std::vector<Check> checks(Clock::time_point /*now*/) { return {}; }
  /// Nothing real moves.
  virtual bool is_simulated() const { return false; }
  /// Tells it what to do, cut to its limits. Has no effect where it is not ready; one in `kStandby` it makes
  /// ready (arms it, changes its mode), over several calls. Nothing is taken from who has taken it.
  /// @param command  what is no number counts as `stop`
  virtual void drive(const Command& command, Clock::time_point now) = 0;
  /// As fast as it can, and from now on until `drive`; told until it is seen to stand. One in `kTaken` is not
  /// told: that would take it from a pilot.
  virtual void stop(Clock::time_point now) = 0;
  /// The same, whoever has taken it. What nobody can take does that by `stop`.
  virtual void stop_in_emergency(Clock::time_point now) { stop(now); }
  /// A person has it driven anew, though somebody has taken it: it may be taken back by `drive`, but from a
  /// pilot who steers it still.
  virtual void engage(Clock::time_point /*now*/) {}
};

}  // namespace mlab::vehicle
