#pragma once

#include "messages.h"

namespace mlab::ros2_robot {

/// The services and topics that an action is made of, for nav2_msgs/action/NavigateToPose.

/// What rmw_cyclonedds puts before each request and its reply: who asked, and which of his questions it is.
template <class Body>
struct Call {
  static constexpr const char* kType = Body::kType;
  static constexpr const char* kHash = "";
  std::uint64_t guid = 0;
  std::int64_t sequence = 0;
  Body body;
};
template <class Io, class Body>
void pass(Io& io, Call<Body>& m) {
  io(m.guid, m.sequence, m.body);
}

/// unique_identifier_msgs/UUID
using GoalId = std::array<std::uint8_t, 16>;

struct GoalInfo {
  GoalId id{};
  Time stamp;
};
template <class Io>
void pass(Io& io, GoalInfo& m) {
  io(m.id, m.stamp);
}

struct SendGoalRequest {
  static constexpr const char* kType = "nav2_msgs::action::dds_::NavigateToPose_SendGoal_Request_";
  static constexpr const char* kHash = "";
  GoalId id{};
  PoseStamped pose;
  std::string behavior_tree = {};
};
template <class Io>
void pass(Io& io, SendGoalRequest& m) {
  io(m.id, m.pose, m.behavior_tree);
}

struct SendGoalResponse {
  static constexpr const char* kType = "nav2_msgs::action::dds_::NavigateToPose_SendGoal_Response_";
  static constexpr const char* kHash = "";
  bool accepted = false;
  Time stamp;
};
template <class Io>
void pass(Io& io, SendGoalResponse& m) {
  io(m.accepted, m.stamp);
}

struct GetResultRequest {
  static constexpr const char* kType = "nav2_msgs::action::dds_::NavigateToPose_GetResult_Request_";
  static constexpr const char* kHash = "";
  GoalId id{};
};
template <class Io>
void pass(Io& io, GetResultRequest& m) {
  io(m.id);
}

/// The result as Nav2 has it since Kilted. Older ones begin alike: a number alone (Jazzy), nothing (Humble).
struct GetResultResponse {
  static constexpr const char* kType = "nav2_msgs::action::dds_::NavigateToPose_GetResult_Response_";
  static constexpr const char* kHash = "";
  std::int8_t status = 0;
  std::uint16_t error_code = 0;
  std::string error_msg = {};
};
template <class Io>
void pass(Io& io, GetResultResponse& m) {
  io(m.status, m.error_code, m.error_msg);
}

struct CancelGoalRequest {
  static constexpr const char* kType = "action_msgs::srv::dds_::CancelGoal_Request_";
  static constexpr const char* kHash = "";
  GoalInfo goal;
};
template <class Io>
void pass(Io& io, CancelGoalRequest& m) {
  io(m.goal);
}

struct CancelGoalResponse {
  static constexpr const char* kType = "action_msgs::srv::dds_::CancelGoal_Response_";
  static constexpr const char* kHash = "";
  std::int8_t return_code = 0;
  std::vector<GoalInfo> goals_canceling = {};
};
template <class Io>
void pass(Io& io, CancelGoalResponse& m) {
  io(m.return_code, m.goals_canceling);
}

struct GoalStatus {
  GoalInfo goal;
  std::int8_t status = 0;
};
template <class Io>
void pass(Io& io, GoalStatus& m) {
  io(m.goal, m.status);
}

struct GoalStatuses {
  static constexpr const char* kType = "action_msgs::msg::dds_::GoalStatusArray_";
  static constexpr const char* kHash = "";
  std::vector<GoalStatus> status_list = {};
};
template <class Io>
void pass(Io& io, GoalStatuses& m) {
  io(m.status_list);
}

struct Feedback {
  static constexpr const char* kType = "nav2_msgs::action::dds_::NavigateToPose_FeedbackMessage_";
  static constexpr const char* kHash = "";
  GoalId id{};
  PoseStamped current_pose;
  Time navigation_time;
  Time estimated_time_remaining;
  std::int16_t number_of_recoveries = 0;
  float distance_remaining = 0.0F;
};
template <class Io>
void pass(Io& io, Feedback& m) {
  io(m.id, m.current_pose, m.navigation_time, m.estimated_time_remaining, m.number_of_recoveries,
     m.distance_remaining);
}

}  // namespace mlab::ros2_robot
