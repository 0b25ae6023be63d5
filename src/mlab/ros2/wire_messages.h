#pragma once

#include <optional>

#include "mlab/ros2/link.h"
#include "mlab/ros2/messages.h"
#include "ros2.h"

// Between messages as Cyclone has them and ours.
namespace mlab::ros2 {

Odometry message_of(const nav_msgs_msg_dds__Odometry_& from);
LaserScan message_of(const sensor_msgs_msg_dds__LaserScan_& from);
BatteryState message_of(const sensor_msgs_msg_dds__BatteryState_& from);
Transform message_of(const geometry_msgs_msg_dds__TransformStamped_& from);
GoalStatus message_of(const action_msgs_msg_dds__GoalStatus_& from);
GoalFeedback message_of(const nav2_msgs_action_dds__NavigateToPose_FeedbackMessage_& from);

/// What they refer to stays where it is: they live no longer than what they were made of.
builtin_interfaces_msg_dds__Time_ wire_of(const Stamp& stamp);
geometry_msgs_msg_dds__Twist_ twist_of(const Velocity& velocity);
geometry_msgs_msg_dds__TwistStamped_ stamped_twist_of(const Velocity& velocity);
nav2_msgs_action_dds__NavigateToPose_SendGoal_Request_ request_of(const Goal& goal);
/// To take back a goal; nothing: all of them.
action_msgs_srv_dds__CancelGoal_Request_ cancel_request_of(const std::optional<GoalId>& id);

}  // namespace mlab::ros2
