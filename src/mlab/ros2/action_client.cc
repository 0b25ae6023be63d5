#include "mlab/ros2/action_client.h"

#include <algorithm>
#include <span>
#include <string_view>
#include <utility>

#include "mlab/ros2/take_all.h"
#include "mlab/ros2/wire_messages.h"

namespace mlab::ros2 {
namespace {

/// Of goals that did not get through only the newest comes later.
constexpr TopicQos kGoals{.is_reliable = true, .is_for_latecomers = false, .depth = 1};
constexpr TopicQos kCancels{.is_reliable = true, .is_for_latecomers = false, .depth = 10};
/// Servers keep one; of two that follow one another both are heard.
constexpr TopicQos kStates{.is_reliable = true, .is_for_latecomers = true, .depth = 10};
constexpr TopicQos kFeedback{.is_reliable = false, .is_for_latecomers = false, .depth = 10};

/// rmw_cyclonedds says by this which of its readers and writers are one service; no other does.
constexpr std::string_view kHeadedServer = "serviceid=";
/// What ids of participants of Fast DDS begin with, as RTPS numbers those who make it.
constexpr std::array<std::uint8_t, 2> kFastDds = {0x01, 0x0f};

Services services_of(const Reader& server) {
  if (server.words.contains(kHeadedServer)) return Services::kHeaded;
  const bool is_fast_dds = std::ranges::equal(kFastDds, std::span(server.participant).first<2>());
  return is_fast_dds ? Services::kPlain : Services::kUnknown;
}

/// Of all who serve; kNone: nobody does.
Services services_of(const std::vector<Reader>& servers) {
  Services out = Services::kNone;
  for (const Reader& one : servers) {
    const Services now = services_of(one);
    if (out != Services::kNone && out != now) return Services::kUnknown;
    out = now;
  }
  return out;
}

std::string news_of(Services services) {
  switch (services) {
    case Services::kNone:
      return "has no navigator any more";
    case Services::kPlain:
      return "has a navigator, which is asked as rmw_fastrtps asks";
    case Services::kHeaded:
      return "has a navigator, which is asked as rmw_cyclonedds asks";
    case Services::kUnknown:
      return "has a navigator that is asked nothing: it speaks services neither as rmw_fastrtps nor as "
             "rmw_cyclonedds, or there are two that don't agree";
  }
  return "";
}

/// Both kinds of requests have types of the same names.
dds_topic_descriptor_t called_as(const dds_topic_descriptor_t& headed, const dds_topic_descriptor_t& plain) {
  dds_topic_descriptor_t out = headed;
  out.m_typename = plain.m_typename;
  return out;
}

}  // namespace

std::expected<ActionClient, std::string> ActionClient::begin(const RosParticipant& participant,
                                                             const std::string& robot_namespace) {
  ActionClient out;
  std::string problem;
  const auto keep = [&](std::expected<Endpoint, std::string> made, Endpoint& to) {
    if (made)
      to = std::move(*made);
    else if (problem.empty())
      problem = made.error();
  };
  const std::string action = robot_namespace + "/navigate_to_pose/_action/";
  const auto ask = [&](const dds_topic_descriptor_t& goal, const dds_topic_descriptor_t& cancel, Asks& to) {
    keep(participant.writer("rq" + action + "send_goalRequest", goal, "", kGoals), to.goals);
    keep(participant.writer("rq" + action + "cancel_goalRequest", cancel, "", kCancels), to.cancels);
  };
  const auto& goal = nav2_msgs_action_dds__NavigateToPose_SendGoal_Request__desc;
  const auto& cancel = action_msgs_srv_dds__CancelGoal_Request__desc;
  ask(goal, cancel, out.plain_);
  ask(called_as(headed_SendGoal_Request__desc, goal), called_as(headed_CancelGoal_Request__desc, cancel),
      out.headed_);
  keep(participant.reader("rt" + action + "status", action_msgs_msg_dds__GoalStatusArray__desc,
                          "action_msgs/msg/GoalStatusArray", kStates),
       out.states_);
  keep(participant.reader("rt" + action + "feedback",
                          nav2_msgs_action_dds__NavigateToPose_FeedbackMessage__desc, "", kFeedback),
       out.feedback_);
  if (!problem.empty()) return std::unexpected(problem);
  dds_instance_handle_t handle = 0;
  if (dds_get_instance_handle(out.headed_.goals.handle(), &handle) == 0) out.client_ = handle;
  return out;
}

void ActionClient::look_at_servers() {
  const Endpoint& goals = plain_.goals;
  const Endpoint& cancels = plain_.cancels;
  const std::array servers = {goals.readers(), cancels.readers(), goals.readers_so_far(),
                              cancels.readers_so_far()};
  const bool is_waiting = services_ == Services::kNone && servers[0] > 0;
  if (servers == servers_ && !is_waiting) return;
  servers_ = servers;
  so_far_ = static_cast<std::uint32_t>(std::max(servers[2], 0));
  const bool is_there = plain_.are_heard() && headed_.are_heard();
  const Services goal = services_of(goals.matched_readers());
  Services now = is_there ? goal : Services::kNone;
  if (is_there && services_of(cancels.matched_readers()) != goal) now = Services::kUnknown;
  if (now == services_) return;
  services_ = now;
  news_.push_back(news_of(now));
}

void ActionClient::hear_states(Heard& heard) {
  const std::size_t before = told_.size();
  bool is_new = false;
  take_all<action_msgs_msg_dds__GoalStatusArray_>(
      states_.handle(), [&](const auto& message, const dds_sample_info_t& info) {
        std::vector<GoalStatus>& goals = told_[info.publication_handle];
        goals.clear();
        for (std::uint32_t i = 0; i < message.status_list._length; ++i)
          goals.push_back(message_of(message.status_list._buffer[i]));
        is_new = true;
      });
  if (told_.empty()) return;
  const auto there = states_.matched_writers();
  std::erase_if(told_, [&](const auto& one) { return std::ranges::find(there, one.first) == there.end(); });
  if (!is_new && told_.size() == before) return;
  heard.goals.emplace();
  for (const auto& [writer, goals] : told_)
    heard.goals->insert(heard.goals->end(), goals.begin(), goals.end());
}

void ActionClient::hear(Heard& heard) {
  look_at_servers();
  hear_states(heard);
  take_all<nav2_msgs_action_dds__NavigateToPose_FeedbackMessage_>(
      feedback_.handle(),
      [&](const auto& message, const auto&) { heard.feedback.push_back(message_of(message)); });
}

// What can't be written is asked again.
template <class Message>
void ActionClient::write(const Endpoint& to, Message& message) {
  static_cast<void>(dds_write(to.handle(), &message));
}

void ActionClient::send(const Goal& goal) {
  auto plain = request_of(goal);
  if (services_ == Services::kPlain) write(plain_.goals, plain);
  if (services_ != Services::kHeaded) return;
  headed_SendGoal_Request_ headed{client_, ++requests_, plain};
  write(headed_.goals, headed);
}

void ActionClient::cancel(const std::optional<GoalId>& id) {
  auto plain = cancel_request_of(id);
  if (services_ == Services::kPlain) write(plain_.cancels, plain);
  if (services_ != Services::kHeaded) return;
  headed_CancelGoal_Request_ headed{client_, ++requests_, plain};
  write(headed_.cancels, headed);
}

void ActionClient::wait_for_acks(dds_duration_t patience) const {
  const Endpoint& said = services_ == Services::kHeaded ? headed_.cancels : plain_.cancels;
  if (said.readers() > 0) dds_wait_for_acks(said.handle(), patience);
}

std::vector<const Endpoint*> ActionClient::readers() const {
  return {&states_, &feedback_};
}

std::vector<const Endpoint*> ActionClient::writers() const {
  return {&plain_.goals, &plain_.cancels, &headed_.goals, &headed_.cancels};
}

std::vector<std::string> ActionClient::take_news() {
  return std::exchange(news_, {});
}

}  // namespace mlab::ros2
