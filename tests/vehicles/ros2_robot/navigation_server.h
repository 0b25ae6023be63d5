#pragma once

#include <string>
#include <vector>

#include "navigator.h"
#include "node.h"
#include "participant.h"
#include "robot.h"
#include "service.h"

namespace mlab::ros2_robot {

struct NavigationSettings {
  Services services = Services::kPlain;
  int refused = 0;  ///< of the first goals, so many are not accepted
  int aborted = 0;  ///< of the first that are, so many are aborted at once
};

/// Nav2's action `navigate_to_pose`.
class NavigationServer {
 public:
  NavigationServer(Participant& participant, const NodeSettings& node, const NavigationSettings& settings,
                   Robot& robot);
  NavigationServer(const NavigationServer&) = delete;
  NavigationServer& operator=(const NavigationServer&) = delete;

  /// Answers what was asked, drives, and tells how it goes. As often as the robot steps.
  void work();

 private:
  void take_goals();
  void take_cancellations();
  void take_questions();
  bool is_usable(const SendGoalRequest& request) const;
  bool is_refused();
  void answer_questions();
  void tell_states();
  void tell_progress();

  NodeSettings node_;
  NavigationSettings settings_;
  Robot& robot_;
  Navigator navigator_;
  Service<SendGoalRequest, SendGoalResponse> send_goal_;
  Service<CancelGoalRequest, CancelGoalResponse> cancel_goal_;
  Service<GetResultRequest, GetResultResponse> get_result_;
  Publication<GoalStatuses> statuses_;
  Publication<Feedback> feedback_;
  std::vector<Asked<GetResultRequest>> questions_;  // that wait for a goal to be over
  std::uint64_t told_changes_ = 0;
  double next_feedback_ = 0.0;
};

}  // namespace mlab::ros2_robot
