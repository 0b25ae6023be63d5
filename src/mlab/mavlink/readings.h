#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "mlab/mavlink/boot_clock.h"
#include "mlab/mavlink/messages.h"
#include "mlab/vehicle/device.h"

namespace mlab::mavlink {

/// What is older than this is not reported.
inline constexpr std::chrono::milliseconds kMotionLasts{1000};
inline constexpr std::chrono::milliseconds kScanLasts{1000};
inline constexpr std::chrono::milliseconds kBatteryLasts{10000};
/// So long after its position jumped a rover is not relied on.
inline constexpr std::chrono::milliseconds kJumpLasts{1000};

/// Where a vehicle is on the earth, as it says itself.
struct Place {
  double latitude = 0.0;   ///< [rad]
  double longitude = 0.0;  ///< [rad]
  vehicle::Clock::time_point at;
};

/// What a rover says of itself, in our units and frames: x east, y north, angles counter-clockwise from east.
/// What is no number, out of any range or older than what is known is dropped.
class Readings {
 public:
  using Time = vehicle::Clock::time_point;

  /// @param origin     of the rover's own frame in the world's; nothing: it is not known
  /// @param max_speed  it can't be faster [m/s], > 0
  Readings(std::optional<geom::Point> origin, double max_speed) : origin_(origin), max_speed_(max_speed) {}

  // Each says whether the vehicle has begun again since the one before; then nothing is taken of it.
  bool take(const Attitude& message, Time now);
  bool take(const LocalPositionNed& message, Time now);
  bool take(const GlobalPositionInt& message, Time now);
  void take(const SysStatus& message, Time now);
  void take(const BatteryStatus& message, Time now);
  void take(const DistanceSensor& message, Time now);
  void take(const ObstacleDistance& message, Time now);
  /// Nothing is known any more.
  void forget();
  /// The same, and the vehicle's own clock begins anew.
  void begin_anew();

  std::optional<vehicle::Motion> motion(Time now) const;
  std::optional<vehicle::Battery> battery(Time now) const;
  std::optional<Place> place(Time now) const;
  /// The same, and which point of its own frame that is.
  std::optional<vehicle::Fix> fix(Time now) const;
  /// By their numbers: 0 is OBSTACLE_DISTANCE, 1 .. 8 are sensors of distance by their orientation.
  void scans(Time now, std::vector<vehicle::Scan>& out) const;
  /// How far its position has just jumped [m]; 0: it has not.
  double jump(Time now) const;
  /// Messages that were dropped.
  std::uint64_t dropped() const { return dropped_; }

 private:
  struct Turning {
    double heading = 0.0;
    double rate = 0.0;
    std::uint32_t boot_ms = 0;  // when it was so, by its clock
  };
  struct Moving {
    geom::Point position;
    geom::Offset velocity;
    std::uint32_t boot_ms = 0;
  };
  // The last second, by time: heading and position come one after the other, and either may get lost; what is
  // told of both is of one moment.
  template <class Sample>
  using Past = std::deque<Sample>;
  template <class Sample>
  static void keep(Past<Sample>& past, const Sample& next);
  template <class Sample>
  static Sample sample_at(const Past<Sample>& past, std::uint32_t boot_ms);
  std::optional<std::pair<Turning, Moving>> newest_pair() const;
  static Turning between(const Turning& a, const Turning& b, double share);
  static Moving between(const Moving& a, const Moving& b, double share);

  bool hear(std::uint32_t kind, std::uint32_t boot_ms, Time now, bool& is_new);
  void notice_how_it_comes();
  void notice_jump(const Moving& next, Time now);
  void keep(vehicle::Scan scan);

  std::optional<geom::Point> origin_;
  double max_speed_;
  BootClock clock_;
  Past<Turning> turned_;
  Past<Moving> moved_;
  bool comes_in_one_go_ = false;
  std::optional<vehicle::Battery> battery_;
  std::optional<Place> place_;
  std::uint32_t place_boot_ms_ = 0;
  std::map<std::uint32_t, vehicle::Scan> scans_;
  double jump_ = 0.0;
  Time jumped_at_;
  std::uint64_t dropped_ = 0;
};

}  // namespace mlab::mavlink
