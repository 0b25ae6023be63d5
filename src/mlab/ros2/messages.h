#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace mlab::ros2 {

/// A time of the robot's own clock, which may be that of a simulation; all zero: it was not told.
struct Stamp {
  std::int32_t sec = 0;
  std::uint32_t nanosec = 0;
  friend bool operator==(const Stamp&, const Stamp&) = default;
};

struct Vector3 {
  double x = 0.0, y = 0.0, z = 0.0;
};

struct Quaternion {
  double x = 0.0, y = 0.0, z = 0.0, w = 1.0;
};

/// Of nav_msgs/Odometry what is used. Like all messages here it is as it came: any number may be none.
struct Odometry {
  Stamp stamp;
  std::string frame;        ///< that its pose is in
  std::string child_frame;  ///< the robot's own, which its velocities are in
  Vector3 position;         ///< [m]
  Quaternion orientation;
  double speed = 0.0;        ///< ahead [m/s]
  double turn_rate = 0.0;    ///< counter-clockwise, seen from above [rad/s]
  std::uint64_t writer = 0;  ///< tells those who publish it apart
};

/// Of sensor_msgs/LaserScan what is used.
struct LaserScan {
  std::size_t topic = 0;  ///< which of the scanners that were asked for
  Stamp stamp;            ///< of the first beam
  std::string frame;
  float angle_min = 0.0F, angle_increment = 0.0F;  ///< [rad]
  float range_min = 0.0F, range_max = 0.0F;        ///< [m]
  std::vector<float> ranges;                       ///< [m]
};

/// Of sensor_msgs/BatteryState what is used.
struct BatteryState {
  float voltage = 0.0F;     ///< [V]
  float percentage = 0.0F;  ///< 0 .. 1, whatever its name says
};

/// Of tf2_msgs/TFMessage one transform.
struct Transform {
  std::string parent;
  std::string child;
  Vector3 translation;  ///< of the child's origin, in the parent's frame [m]
  Quaternion rotation;
  bool is_static = false;
  bool is_own = false;  ///< it came on a topic in the robot's own namespace
};

/// Goals of an action are told apart by it.
struct GoalId {
  std::uint8_t bytes[16] = {};
  friend bool operator==(const GoalId&, const GoalId&) = default;
};

/// What becomes of a goal, of action_msgs/GoalStatus.
enum class GoalState : std::int8_t {
  kUnknown = 0,
  kAccepted = 1,
  kExecuting = 2,
  kCanceling = 3,
  kSucceeded = 4,
  kCanceled = 5,
  kAborted = 6,
};

struct GoalStatus {
  GoalId id;
  GoalState state = GoalState::kUnknown;
};

constexpr bool is_over(GoalState state) {
  return state >= GoalState::kSucceeded;
}

/// What a navigator says on its way to a goal, of nav2_msgs/NavigateToPose.
struct GoalFeedback {
  GoalId id;
  int recoveries = 0;  ///< how often it has tried to get free
};

/// All that came since it was asked last, in the order in which it came on each topic.
struct Heard {
  std::vector<Odometry> odometry;
  std::vector<LaserScan> scans;
  std::vector<BatteryState> batteries;
  std::vector<Transform> transforms;
  /// All goals that navigators know of, whoever gave them; nothing: nothing of that is new.
  std::optional<std::vector<GoalStatus>> goals;
  std::vector<GoalFeedback> feedback;
};

}  // namespace mlab::ros2
