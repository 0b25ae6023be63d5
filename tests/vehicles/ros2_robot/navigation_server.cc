#include "navigation_server.h"

#include <cmath>

#include <fmt/core.h>

namespace mlab::ros2_robot {
namespace {

constexpr double kFeedbackEvery = 0.2;      // [s]
constexpr std::size_t kMostQuestions = 64;  // that wait
constexpr std::uint16_t kUnknownError = 9000;

/// A service of the action.
std::string service(const NodeSettings& node, const char* name) {
  return node.node_namespace + "/navigate_to_pose/_action/" + name;
}

Time duration(double seconds) {
  const double whole = std::floor(seconds);
  return {static_cast<std::int32_t>(whole), static_cast<std::uint32_t>((seconds - whole) * 1e9)};
}

}  // namespace

NavigationServer::NavigationServer(Participant& participant, const NodeSettings& node,
                                   const NavigationSettings& settings, Robot& robot)
    : node_(node),
      settings_(settings),
      robot_(robot),
      send_goal_(participant, service(node, "send_goal"), settings.services, 1),
      cancel_goal_(participant, service(node, "cancel_goal"), settings.services, 2),
      get_result_(participant, service(node, "get_result"), settings.services, 3),
      statuses_(participant.publish<GoalStatuses>("rt" + service(node, "status"), kLatched)),
      feedback_(participant.publish<Feedback>("rt" + service(node, "feedback"), {})) {}

bool NavigationServer::is_refused() {
  if (settings_.refused <= 0) return false;
  --settings_.refused;
  fmt::print("refuses a goal\n");
  return true;
}

bool NavigationServer::is_usable(const SendGoalRequest& request) const {
  const std::string& frame = request.pose.header.frame_id;
  const geom::Pose target = pose_of(request.pose.pose);
  // Its map is where it was switched on: it has no better one.
  const bool is_known = frame.empty() || frame == "map" || frame == node_.frame_prefix + "odom";
  return is_known && std::isfinite(target.position.x) && std::isfinite(target.position.y) &&
         std::isfinite(target.heading);
}

void NavigationServer::take_goals() {
  for (Asked<SendGoalRequest> asked; send_goal_.take(asked);) {
    const Goal goal{.id = asked.body.id,
                    .target = pose_of(asked.body.pose.pose),
                    .accepted = time_now(),
                    .began = robot_.time()};
    const bool is_accepted = is_usable(asked.body) && !is_refused() && navigator_.accept(goal);
    send_goal_.reply(asked, {is_accepted, goal.accepted});
    if (is_accepted && settings_.aborted > 0) {
      --settings_.aborted;
      navigator_.abort();
    }
  }
}

void NavigationServer::take_cancellations() {
  for (Asked<CancelGoalRequest> asked; cancel_goal_.take(asked);) {
    CancelGoalResponse told;
    told.return_code = static_cast<std::int8_t>(navigator_.cancel(asked.body.goal, told.goals_canceling));
    cancel_goal_.reply(asked, told);
  }
}

void NavigationServer::take_questions() {
  for (Asked<GetResultRequest> asked; get_result_.take(asked);) {
    if (questions_.size() < kMostQuestions) questions_.push_back(asked);
  }
}

void NavigationServer::answer_questions() {
  std::erase_if(questions_, [&](const Asked<GetResultRequest>& asked) {
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
