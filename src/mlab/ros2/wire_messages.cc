#include "mlab/ros2/wire_messages.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace mlab::ros2 {
namespace {

std::string text_of(const char* text) {
  return text == nullptr ? std::string() : std::string(text);
}

Stamp stamp_of(const builtin_interfaces_msg_dds__Time_& from) {
  return {from.sec, from.nanosec};
}

Quaternion rotation_of(const geometry_msgs_msg_dds__Quaternion_& from) {
  return {from.x, from.y, from.z, from.w};
}

/// Cyclone's structures have no const.
char* text_in(const std::string& text) {
  return const_cast<char*>(text.c_str());
}

}  // namespace

Odometry message_of(const nav_msgs_msg_dds__Odometry_& from) {
  const auto& position = from.pose.pose.position;
  return {.stamp = stamp_of(from.header.stamp),
          .frame = text_of(from.header.frame_id),
          .child_frame = text_of(from.child_frame_id),
          .position = {position.x, position.y, position.z},
          .orientation = rotation_of(from.pose.pose.orientation),
          .speed = from.twist.twist.linear.x,
          .turn_rate = from.twist.twist.angular.z,
          .writer = 0};
}

LaserScan message_of(const sensor_msgs_msg_dds__LaserScan_& from) {
  return {.topic = 0,
          .stamp = stamp_of(from.header.stamp),
          .frame = text_of(from.header.frame_id),
          .angle_min = from.angle_min,
          .angle_increment = from.angle_increment,
          .range_min = from.range_min,
          .range_max = from.range_max,
          .ranges = {from.ranges._buffer, from.ranges._buffer + from.ranges._length}};
}

BatteryState message_of(const sensor_msgs_msg_dds__BatteryState_& from) {
  return {from.voltage, from.percentage};
}

Transform message_of(const geometry_msgs_msg_dds__TransformStamped_& from) {
  const auto& translation = from.transform.translation;
  return {.parent = text_of(from.header.frame_id),
          .child = text_of(from.child_frame_id),
          .translation = {translation.x, translation.y, translation.z},
          .rotation = rotation_of(from.transform.rotation),
          .is_static = false,
          .is_own = false};
}

GoalStatus message_of(const action_msgs_msg_dds__GoalStatus_& from) {
  GoalStatus out;
  std::ranges::copy(from.goal_info.goal_id.uuid, std::begin(out.id.bytes));
  if (from.status >= 0 && from.status <= static_cast<int>(GoalState::kAborted))
    out.state = static_cast<GoalState>(from.status);
  return out;
}

GoalFeedback message_of(const nav2_msgs_action_dds__NavigateToPose_FeedbackMessage_& from) {
  GoalFeedback out;
  std::ranges::copy(from.goal_id.uuid, std::begin(out.id.bytes));
  out.recoveries = from.number_of_recoveries;
  return out;
}

builtin_interfaces_msg_dds__Time_ wire_of(const Stamp& stamp) {
  return {stamp.sec, stamp.nanosec};
}

geometry_msgs_msg_dds__Twist_ twist_of(const Velocity& velocity) {
  geometry_msgs_msg_dds__Twist_ out{};
  out.linear.x = velocity.speed;
  out.angular.z = velocity.turn_rate;
  return out;
}

geometry_msgs_msg_dds__TwistStamped_ stamped_twist_of(const Velocity& velocity) {
  geometry_msgs_msg_dds__TwistStamped_ out{};
  out.header.stamp = wire_of(velocity.stamp);
  out.header.frame_id = text_in(velocity.frame);
  out.twist = twist_of(velocity);
  return out;
}

nav2_msgs_action_dds__NavigateToPose_SendGoal_Request_ request_of(const Goal& goal) {
  static const std::string kNothing;  // the robot's own behavior tree
  nav2_msgs_action_dds__NavigateToPose_SendGoal_Request_ out{};
  std::ranges::copy(goal.id.bytes, std::begin(out.goal_id.uuid));
  out.goal.pose.header.stamp = wire_of(goal.stamp);
  out.goal.pose.header.frame_id = text_in(goal.frame);
  out.goal.pose.pose.position.x = goal.x;
  out.goal.pose.pose.position.y = goal.y;
  out.goal.pose.pose.orientation.z = std::sin(goal.heading / 2.0);
  out.goal.pose.pose.orientation.w = std::cos(goal.heading / 2.0);
  out.goal.behavior_tree = text_in(kNothing);
  return out;
}

action_msgs_srv_dds__CancelGoal_Request_ cancel_request_of(const std::optional<GoalId>& id) {
  action_msgs_srv_dds__CancelGoal_Request_ out{};  // no goal and no time: all of them
  if (id) std::ranges::copy(id->bytes, std::begin(out.goal_info.goal_id.uuid));
  return out;
}

}  // namespace mlab::ros2
