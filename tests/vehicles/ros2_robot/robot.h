#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/geom/pose.h"
#include "mlab/overlay/overlay.h"

namespace mlab::ros2_robot {

struct RobotSpec {
  double radius = 0.25;          ///< [m]
  double max_speed = 1.0;        ///< [m/s]
  double max_turn_rate = 1.5;    ///< [rad/s]
  double acceleration = 2.0;     ///< with which it starts and brakes [m/s^2]
  double turn_acceleration = 5;  ///< [rad/s^2]
  /// So long after the last command of its driver it brakes, as the watchdog of diff_drive_controller has it
  /// (cmd_vel_timeout) [s].
  double patience = 0.5;
  double drift = 0.01;        ///< standard deviation of a step's length and turn, as a share of them
  std::uint16_t beams = 360;  ///< of its scanner, one a degree: 360 all round, or 180 ahead
  double range = 10.0;        ///< of its scanner [m]
  double nearest = 0.12;      ///< what is nearer the scanner can't measure [m]
  double range_noise = 0.01;  ///< standard deviation [m]
  double battery = 0.9;       ///< that is left when it is switched on, 0 .. 1
  geom::Pose place;           ///< where it stands then [m, world]
  std::uint64_t seed = 1;     ///< of drift and noise
};

/// Where its scanner is on it [m, robot frame].
inline constexpr double kScannerAhead = 0.1;

/// What a scanner saw at once.
struct Scan {
  double first_angle = 0.0;   ///< [rad]
  double step = 0.0;          ///< [rad]
  std::vector<float> ranges;  ///< [m]; infinite: nothing is there; less than that of all numbers: too near
};

struct Speeds {
  double ahead = 0.0;  ///< [m/s]
  double turn = 0.0;   ///< counter-clockwise [rad/s]
};

/// A robot with two driven wheels in the world of an overlay. It knows no clock: time goes by when it is told
/// so.
class Robot {
 public:
  Robot(const overlay::Overlay& world, const RobotSpec& spec);
  ~Robot();
  Robot(const Robot&) = delete;
  Robot& operator=(const Robot&) = delete;

  /// What its driver wants, for `patience`; no numbers count as nothing said.
  void command(const Speeds& wanted);
  /// What its own navigation wants, until it wants otherwise; a driver who lets himself be heard goes before.
  void navigate(const Speeds& wanted) { navigated_ = wanted; }
  /// @param dt  [s], > 0
  void step(double dt);

  /// Since it was switched on [s].
  double time() const { return time_; }
  /// What its wheels are told now, before any acceleration.
  Speeds commanded() const;
  /// When its driver was heard last; less than 0: never [s].
  double heard_at() const { return heard_at_; }
  /// A driver was heard within `patience`.
  bool is_driven() const { return time_ - heard_at_ < spec_.patience; }
  geom::Pose pose() const;  ///< where it really is [m, world]
  Speeds speeds() const;    ///< as it really moves
  geom::Pose counted();     ///< as its wheels say, from where it was switched on
  Scan scan();
  double battery() const;  ///< that is left, 0 .. 1
  const RobotSpec& spec() const { return spec_; }

 private:
  struct Parts;
  RobotSpec spec_;
  std::unique_ptr<Parts> parts_;
  Speeds driven_;
  Speeds navigated_;
  double time_ = 0.0;
  double heard_at_ = -1e9;
};

}  // namespace mlab::ros2_robot
