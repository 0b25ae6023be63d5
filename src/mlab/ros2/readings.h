#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mlab/ros2/frames.h"
#include "mlab/ros2/messages.h"
#include "mlab/ros2/robot_clock.h"
#include "mlab/vehicle/device.h"

namespace mlab::ros2 {

/// Older than this, where the robot is and what its scanners saw is not told any more.
inline constexpr std::chrono::milliseconds kMotionLasts{1000};
inline constexpr std::size_t kMostScanners = 16;
/// A scan of more beams is told with fewer: of neighbours the nearest.
inline constexpr std::size_t kMostBeams = 1024;

/// Which frames poses are told in.
struct Places {
  /// That poses are wanted in, by what `/tf` says; empty: that of the odometry.
  std::string map_frame;
  /// Where the origin of that frame is in the world; nothing: it begins anywhere.
  std::optional<geom::Point> origin;
  bool is_global() const { return !map_frame.empty() || origin.has_value(); }
};

/// What a robot has said, checked: what makes no sense is left out and told, what is old is forgotten.
class Readings {
 public:
  using Time = vehicle::Clock::time_point;

  /// @param max_speed  of the robot [m/s], > 0: what moves faster has jumped
  Readings(Places places, std::vector<std::string> scanners, double max_speed);

  void take(const Heard& heard, Time now);

  /// In the wanted frame. Nothing: `why_no_motion` says why.
  std::optional<vehicle::Motion> motion(Time now) const;
  std::string why_no_motion(Time now) const;
  void scans(Time now, std::vector<vehicle::Scan>& out) const;
  std::optional<vehicle::Battery> battery(Time now) const;
  /// How far it has jumped in the last second, more than it can drive; 0: it has not [m].
  double jump(Time now) const;
  /// Whether it has been seen standing since, in two messages that were said later.
  bool has_stood_since(Time then) const;

  const RobotClock& clock() const { return clock_; }
  /// The robot's own frame; empty: it has not been told.
  const std::string& base_frame() const { return base_frame_; }
  /// That its odometry counts in.
  const std::string& odometry_frame() const { return odometry_frame_; }
  /// Where it is in that frame.
  std::optional<geom::Pose> odometry_pose(Time now) const;

  /// What people are to know, a line each.
  std::vector<std::string> take_news();

 private:
  struct Moving {
    Placement placement;
    geom::Pose pose;
    double speed = 0.0;
    double turn_rate = 0.0;
    Time at;
  };
  struct Scanner {
    std::string topic;
    std::optional<vehicle::Scan> scan;
    std::optional<Time> waits_for_mount_since;
    std::string told;  // what was said of it last
  };

  void take(const Odometry& message, Time now);
  void take(const LaserScan& message, Time now);
  void take(const BatteryState& message, Time now);
  bool is_from_elsewhere(const Odometry& message, Time now);
  void notice_jump(const Moving& next, Time now);
  void begin_anew(Time now);
  std::optional<Time> time_of(Scanner& scanner, const Stamp& stamp, Time now);
  /// Turns the beams round, too, where it is mounted upside down. False: it can't be used.
  bool mount(Scanner& scanner, const std::string& frame, vehicle::Scan& scan, Time now);
  std::optional<Placement> map_to_odometry(Time now) const;
  void tell(std::string news);
  void tell(Scanner& scanner, std::string problem);

  Places places_;
  std::vector<Scanner> scanners_;
  double max_speed_;
  RobotClock clock_;
  Frames frames_;
  std::string base_frame_;
  std::string odometry_frame_;
  std::optional<Moving> odometry_;
  std::optional<Time> heard_at_;  // something that was an odometry
  std::uint64_t writer_ = 0;
  Time writer_heard_at_;
  bool is_second_told_ = false;
  bool is_unstamped_ = false;
  bool is_senseless_ = false;
  std::optional<vehicle::Battery> battery_;
  std::array<std::optional<Time>, 2> stood_at_;  // the two newest in a row in which it stood
  double jump_ = 0.0;
  Time jumped_at_;
  std::vector<std::string> news_;
};

/// Takes a scan's numbers over, checked: beams are from its own frame's heading.
/// @return  what is wrong with it; empty: nothing
std::string read_scan(const LaserScan& message, vehicle::Scan& out);

}  // namespace mlab::ros2
