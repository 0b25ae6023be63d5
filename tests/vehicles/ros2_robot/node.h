#pragma once

#include <memory>
#include <optional>
#include <string>

#include "participant.h"
#include "robot.h"

namespace mlab::ros2_robot {

struct NodeSettings {
  int domain = 0;
  std::string node_namespace;  ///< such as `/veh1`; empty: none
  std::string frame_prefix;    ///< before the names of its frames, such as `veh1/`
  bool is_stamped = false;     ///< TwistStamped is what it is driven by, not Twist
};

/// The moment, as ROS has it: of the wall clock.
Time time_now();
PoseMessage message_of(const geom::Pose& pose);
geom::Pose pose_of(const PoseMessage& message);

/// The topics of a robot with two driven wheels: `cmd_vel` in, `odom`, `scan`, `battery_state`, `/tf`,
/// `/tf_static` out.
class Node {
 public:
  Node(Participant& participant, const NodeSettings& settings, Robot& robot);
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;

  /// Tells the robot what has come. @return  how many commands
  int obey();
  /// Says what is due.
  void say();

 private:
  Header header(const char* frame) const;
  void say_place();
  void say_scan();
  void say_battery();
  void say_mount();
  bool is_due(double& next, double every) const;

  NodeSettings settings_;
  Robot& robot_;
  std::optional<Subscription<Twist>> twists_;
  std::optional<Subscription<TwistStamped>> stamped_;
  Publication<Odometry> odometry_;
  Publication<LaserScan> scans_;
  Publication<BatteryState> batteries_;
  Publication<Transforms> transforms_;
  Publication<Transforms> mounts_;
  double next_place_ = 0.0;
  double next_scan_ = 0.0;
  double next_battery_ = 0.0;
};

}  // namespace mlab::ros2_robot
