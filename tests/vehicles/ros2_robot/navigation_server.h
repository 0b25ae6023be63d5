#pragma once

#include <string>
#include <vector>

#include "navigator.h"
#include "node.h"
#include "participant.h"
#include "robot.h"

namespace mlab::ros2_robot {

/// Nav2's action `navigate_to_pose`, its services as rmw_cyclonedds has them.
class NavigationServer {
 public:
  NavigationServer(Participant& participant, const NodeSettings& settings, Robot& robot);
  NavigationServer(const NavigationServer&) = delete;
  NavigationServer& operator=(const NavigationServer&) = delete;

  /// Answers what was asked, drives, and tells how it goes. As often as the robot steps.
  void work();

 private:
  template <class Request, class Response>
  struct Service {
    Subscription<Call<Request>> requests;
    Publication<Call<Response>> replies;
    void reply(const Call<Request>& to, const Response& body) {
      Call<Response> out{to.guid, to.sequence, body};
      replies.write(out);
    }
  };
  template <class Request, class Response>
  static Service<Request, Response> serve(Participant& participant, const std::string& action,
                                          const std::string& name);

  void take_goals();
  void take_cancellations();
  void take_questions();
  bool is_usable(const SendGoalRequest& request) const;
  void answer_questions();
  void tell_states();
  void tell_progress();

  NodeSettings settings_;
  Robot& robot_;
  Navigator navigator_;
  Service<SendGoalRequest, SendGoalResponse> send_goal_;
  Service<CancelGoalRequest, CancelGoalResponse> cancel_goal_;
  Service<GetResultRequest, GetResultResponse> get_result_;
  Publication<GoalStatuses> statuses_;
  Publication<Feedback> feedback_;
  std::vector<Call<GetResultRequest>> questions_;  // that wait for a goal to be over
  std::uint64_t told_changes_ = 0;
  double next_feedback_ = 0.0;
};

}  // namespace mlab::ros2_robot
