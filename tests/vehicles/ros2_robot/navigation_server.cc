#include "navigation_server.h"

#include <cmath>

#include <fmt/format.h>

namespace mlab::ros2_robot {
namespace {

constexpr double kFeedbackEvery = 0.2;      // [s]
constexpr std::size_t kMostQuestions = 64;  // that wait
constexpr std::uint16_t kUnknownError = 9000;

/// What rmw_cyclonedds tells of a service's endpoints, by which it knows that both of them are there.
std::string service_id(const Gid& gid, std::uint8_t number) {
  std::string out = "serviceid=";
  for (std::size_t i = 0; i < gid.size(); ++i)
    out += fmt::format("{}{:x}", i > 0 ? "." : "", i + 1 < gid.size() ? gid[i] : number);
  return out + ";";
}

Time duration(double seconds) {
  const double whole = std::floor(seconds);
  return {static_cast<std::int32_t>(whole), static_cast<std::uint32_t>((seconds - whole) * 1e9)};
}

}  // namespace

template <class Request, class Response>
NavigationServer::Service<Request, Response> NavigationServer::serve(Participant& participant,
                                                                     const std::string& action,
                                                                     const std::string& name) {
  const std::string id = service_id(participant.gid(), static_cast<std::uint8_t>(name.size()));
  return {participant.subscribe<Call<Request>>("rq" + action + name + "Request", {}, id),
          participant.publish<Call<Response>>("rr" + action + name + "Reply", {}, id)};
}

NavigationServer::NavigationServer(Participant& participant, const NodeSettings& settings, Robot& robot)
    : settings_(settings),
      robot_(robot),
      send_goal_(serve<SendGoalRequest, SendGoalResponse>(
          participant, settings.node_namespace + "/navigate_to_pose/_action/", "send_goal")),
      cancel_goal_(serve<CancelGoalRequest, CancelGoalResponse>(
          participant, settings.node_namespace + "/navigate_to_pose/_action/", "cancel_goal")),
      get_result_(serve<GetResultRequest, GetResultResponse>(
          participant, settings.node_namespace + "/navigate_to_pose/_action/", "get_result")),
      statuses_(participant.publish<GoalStatuses>(
          "rt" + settings.node_namespace + "/navigate_to_pose/_action/status", kLatched)),
      feedback_(participant.publish<Feedback>(
          "rt" + settings.node_namespace + "/navigate_to_pose/_action/feedback", {})) {}

bool NavigationServer::is_usable(const SendGoalRequest& request) const {
  const std::string& frame = request.pose.header.frame_id;
  const geom::Pose target = pose_of(request.pose.pose);
  // Its map is where it was switched on: it has no better one.
  const bool is_known = frame.empty() || frame == "map" || frame == settings_.frame_prefix + "odom";
  return is_known && std::isfinite(target.position.x) && std::isfinite(target.position.y) &&
         std::isfinite(target.heading);
}

void NavigationServer::take_goals() {
  for (Call<SendGoalRequest> asked; send_goal_.requests.take(asked);) {
    const Goal goal{.id = asked.body.id,
                    .target = pose_of(asked.body.pose.pose),
                    .accepted = time_now(),
                    .began = robot_.time()};
    const bool is_accepted = is_usable(asked.body) && navigator_.accept(goal);
    send_goal_.reply(asked, {is_accepted, goal.accepted});
  }
}

void NavigationServer::take_cancellations() {
  for (Call<CancelGoalRequest> asked; cancel_goal_.requests.take(asked);) {
    CancelGoalResponse told;
    told.return_code = static_cast<std::int8_t>(navigator_.cancel(asked.body.goal, told.goals_canceling));
    cancel_goal_.reply(asked, told);
  }
}

void NavigationServer::take_questions() {
  for (Call<GetResultRequest> asked; get_result_.requests.take(asked);) {
    if (questions_.size() < kMostQuestions) questions_.push_back(asked);
  }
}

void NavigationServer::answer_questions() {
  std::erase_if(questions_, [&](const Call<GetResultRequest>& asked) {
    const Goal* goal = navigator_.find(asked.body.id);
    const GoalState state = goal != nullptr ? goal->state : GoalState::kUnknown;
    if (goal != nullptr && !is_over(state)) return false;
    GetResultResponse told{.status = static_cast<std::int8_t>(state)};
    if (state == GoalState::kAborted) {
      told.error_code = kUnknownError;
      told.error_msg = "another goal came, or it did not get on";
    }
    get_result_.reply(asked, told);
    return true;
  });
}

void NavigationServer::tell_states() {
  if (navigator_.changes() == told_changes_) return;
  told_changes_ = navigator_.changes();
  GoalStatuses told;
  for (const Goal& goal : navigator_.goals())
    told.status_list.push_back({{goal.id, goal.accepted}, static_cast<std::int8_t>(goal.state)});
  statuses_.write(told);
}

void NavigationServer::tell_progress() {
  const Goal* goal = navigator_.current();
  if (goal == nullptr || robot_.time() < next_feedback_) return;
  next_feedback_ = robot_.time() + kFeedbackEvery;
  const geom::Pose pose = robot_.counted();
  const double distance = geom::length(goal->target.position - pose.position);
  Feedback told{.id = goal->id,
                .current_pose = {{time_now(), "map"}, message_of(pose)},
                .navigation_time = duration(robot_.time() - goal->began),
                .estimated_time_remaining = duration(distance / robot_.spec().max_speed),
                .distance_remaining = static_cast<float>(distance)};
  feedback_.write(told);
}

void NavigationServer::work() {
  take_goals();
  take_cancellations();
  take_questions();
  tell_states();
  robot_.navigate(navigator_.step(robot_.counted(), robot_.time()).value_or(Speeds{}));
  tell_states();
  answer_questions();
  tell_progress();
}

}  // namespace mlab::ros2_robot
