#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "action_messages.h"
#include "participant.h"

namespace mlab::ros2_robot {

/// Another client of NavigateToPose, as rmw_fastrtps_cpp has it: it says beside its request which reader is
/// its own, and knows its replies by that and the request's number.
class FastClient {
 public:
  explicit FastClient(int domain)
      : participant_(domain, "", "other_client"),
        goals_(participant_.publish<SendGoalRequest>(name("rq", "send_goalRequest"), {})),
        accepted_(participant_.subscribe<SendGoalResponse>(name("rr", "send_goalReply"), {})),
        cancels_(participant_.publish<CancelGoalRequest>(name("rq", "cancel_goalRequest"), {})),
        canceled_(participant_.subscribe<CancelGoalResponse>(name("rr", "cancel_goalReply"), {})) {}

  bool is_connected() const {
    return goals_.has_readers() && accepted_.has_writers() && cancels_.has_readers() &&
           canceled_.has_writers();
  }
  void send(std::uint8_t number, double x, const std::string& frame = "map") {
    SendGoalRequest out{.id = {number}, .pose = {}, .behavior_tree = ""};
    out.pose.header.frame_id = frame;
    out.pose.pose.position.x = x;
    out.pose.pose.orientation.w = 1.0;
    asked_ = ask(goals_, out, accepted_);
  }
  /// Whether what was sent last was accepted; nothing: there is no reply to it yet.
  std::optional<bool> is_accepted() {
    SendGoalResponse told;
    return takes_reply(accepted_, told) ? std::optional(told.accepted) : std::nullopt;
  }
  void cancel(std::uint8_t number) {
    CancelGoalRequest out{.goal = {.id = {number}, .stamp = {}}};
    asked_ = ask(cancels_, out, canceled_);
  }
  std::optional<int> cancel_code() {
    CancelGoalResponse told;
    return takes_reply(canceled_, told) ? std::optional<int>(told.return_code) : std::nullopt;
  }
  /// Replies that were somebody else's.
  int strange_replies() const { return strange_; }

 private:
  static std::string name(const std::string& prefix, const std::string& what) {
    return prefix + "/veh1/navigate_to_pose/_action/" + what;
  }
  template <class Request, class Response>
  static Identity ask(Publication<Request>& to, Request& request, const Subscription<Response>& replies) {
    Identity own;
    own.writer_guid(replies.guid());
    const Identity written = to.write(request, own);
    own.sequence_number(written.sequence_number());
    return own;
  }
  template <class Response>
  bool takes_reply(Subscription<Response>& from, Response& told) {
    for (eprosima::fastdds::dds::SampleInfo info; from.take(told, info);) {
      if (info.related_sample_identity == asked_) return true;
      ++strange_;
    }
    return false;
  }

  Participant participant_;
  Publication<SendGoalRequest> goals_;
  Subscription<SendGoalResponse> accepted_;
  Publication<CancelGoalRequest> cancels_;
  Subscription<CancelGoalResponse> canceled_;
  Identity asked_;
  int strange_ = 0;
};

}  // namespace mlab::ros2_robot
