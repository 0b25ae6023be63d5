#include "navigator.h"

#include <algorithm>
#include <cmath>

#include "mlab/base/angle.h"

namespace mlab::ros2_robot {
namespace {

constexpr double kNear = 0.15;          // [m]
constexpr double kAsWanted = 0.1;       // [rad]
constexpr double kTurnsFirst = 0.4;     // from where on it turns before it goes [rad]
constexpr double kSpeed = 0.6;          // [m/s]
constexpr double kTurnRate = 1.0;       // [rad/s]
constexpr double kProgress = 0.2;       // that has to be made [m and rad]
constexpr double kGivenUpAfter = 10.0;  // without progress [s]

double turn_for(double error) {
  return std::clamp(1.5 * error, -kTurnRate, kTurnRate);
}

double left(const geom::Pose& pose, const geom::Pose& target) {
  return geom::length(target.position - pose.position) +
         std::abs(base::wrap_angle(target.heading - pose.heading));
}

bool is_before(const Time& a, const Time& b) {
  return a.sec != b.sec ? a.sec < b.sec : a.nanosec <= b.nanosec;
}

}  // namespace

std::optional<Speeds> towards(const geom::Pose& pose, const geom::Pose& target) {
  const geom::Offset way = target.position - pose.position;
  const double distance = geom::length(way);
  if (distance > kNear) {
    const double error = base::wrap_angle(std::atan2(way.y, way.x) - pose.heading);
    const bool goes = std::abs(error) < kTurnsFirst;
    return Speeds{goes ? std::min(kSpeed, 0.1 + distance) : 0.0, turn_for(error)};
  }
  const double error = base::wrap_angle(target.heading - pose.heading);
  if (std::abs(error) > kAsWanted) return Speeds{0.0, turn_for(error)};
  return std::nullopt;
}

void Navigator::set(Goal& goal, GoalState state) {
  goal.state = state;
  ++changes_;
}

bool Navigator::accept(const Goal& goal) {
  if (find(goal.id) != nullptr) return false;
  for (Goal& one : goals_) {
    if (!is_over(one.state)) set(one, GoalState::kAborted);
  }
  if (goals_.size() == kKept) goals_.erase(goals_.begin());
  goals_.push_back(goal);
  goals_.back().came_nearer = goal.began;
  set(goals_.back(), GoalState::kExecuting);
  return true;
}

void Navigator::abort() {
  if (!goals_.empty() && !is_over(goals_.back().state)) set(goals_.back(), GoalState::kAborted);
}

CancelCode Navigator::cancel(const GoalInfo& asked, std::vector<GoalInfo>& told) {
  const bool names_one = asked.id != GoalId{};
  const bool has_stamp = asked.stamp.sec != 0 || asked.stamp.nanosec != 0;
  if (names_one && find(asked.id) == nullptr) return CancelCode::kUnknownGoal;
  for (Goal& one : goals_) {
    const bool is_meant = names_one ? one.id == asked.id : !has_stamp || is_before(one.accepted, asked.stamp);
    if (!is_meant || is_over(one.state)) continue;
    set(one, GoalState::kCanceling);
    told.push_back({one.id, one.accepted});
  }
  if (!told.empty()) return CancelCode::kDone;
  return names_one ? CancelCode::kIsOver : CancelCode::kRejected;
}

std::optional<Speeds> Navigator::step(const geom::Pose& pose, double now) {
  if (goals_.empty() || is_over(goals_.back().state)) return std::nullopt;
  Goal& goal = goals_.back();
  if (goal.state == GoalState::kCanceling) {
    set(goal, GoalState::kCanceled);
    return std::nullopt;
  }
  const double now_left = left(pose, goal.target);
  if (now_left < goal.nearest - kProgress) {
    goal.nearest = now_left;
    goal.came_nearer = now;
  }
  const auto wanted = towards(pose, goal.target);
  if (!wanted.has_value()) {
    set(goal, GoalState::kSucceeded);
  } else if (now - goal.came_nearer > kGivenUpAfter) {
    set(goal, GoalState::kAborted);
    return std::nullopt;
  }
  return wanted;
}

const Goal* Navigator::find(const GoalId& id) const {
  const auto found = std::ranges::find(goals_, id, &Goal::id);
  return found != goals_.end() ? &*found : nullptr;
}

const Goal* Navigator::current() const {
  return goals_.empty() || is_over(goals_.back().state) ? nullptr : &goals_.back();
}

}  // namespace mlab::ros2_robot
