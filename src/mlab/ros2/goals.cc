#include "mlab/ros2/goals.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mlab/base/angle.h"

namespace mlab::ros2 {
namespace {

/// A navigator plans anew for each goal.
constexpr std::chrono::milliseconds kBetweenGoals{500};
constexpr double kMoved = 0.25;  // a target that has moved less is the same one [m]
constexpr double kTurned = 0.2;  // [rad]
/// Who steers by velocities turns hard until it looks right, which is long before a goal is reached; so a
/// turn counts for little more than the time until the next goal, else it would swing to and fro.
constexpr double kBendsFor = 0.4;  // while it goes [s]
constexpr double kTurnsFor = 1.0;  // on the spot [s]
constexpr double kStands = 0.02;   // what is slower does not go [m/s]

}  // namespace

Goals::Goals(double look_ahead, double max_speed, std::uint64_t session)
    : look_ahead_(look_ahead), max_speed_(max_speed), session_(session) {}

geom::Pose Goals::ahead(const geom::Pose& pose, const vehicle::Command& command) const {
  const bool only_turns = std::abs(command.speed) < kStands;
  const double turn = command.turn_rate * (only_turns ? kTurnsFor : kBendsFor);
  const double heading = pose.heading + std::clamp(turn, -std::numbers::pi, std::numbers::pi);
  const double way = only_turns ? 0.0 : command.speed * look_ahead_ / max_speed_;
  return {geom::Pose{pose.position, heading}.point_at({way, 0.0, 0.0}), base::wrap_angle(heading)};
}

GoalId Goals::new_id() {
  ++count_;
  GoalId out;
  for (unsigned i = 0; i < 8; ++i) {
    out.bytes[i] = static_cast<std::uint8_t>(session_ >> (8 * i));
    out.bytes[8 + i] = static_cast<std::uint8_t>(count_ >> (8 * i));
  }
  return out;
}

std::optional<Goal> Goals::next(const vehicle::Command& command, const geom::Pose& pose,
                                const std::string& frame, const Stamp& stamp, Time now) {
  if (sent_at_ && now - *sent_at_ < kBetweenGoals) return std::nullopt;
  const geom::Pose target = ahead(pose, command);
  const bool is_same = id_ && !has_ended_ && geom::distance(target.position, target_.position) <= kMoved &&
                       std::abs(base::wrap_angle(target.heading - target_.heading)) <= kTurned;
  if (is_same) return std::nullopt;
  id_ = new_id();
  target_ = target;
  has_ended_ = false;
  request_ = 0;
  sent_at_ = now;
  return Goal{*id_, stamp, frame, target.position.x, target.position.y, target.heading};
}

void Goals::take(const Heard& heard) {
  for (const GoalAnswer& one : heard.answers) {
    if (!id_ || one.request != request_) continue;
    if (!one.is_accepted) has_ended_ = true;
    problem_ = one.is_accepted ? "" : "does not take the goal that it is given";
  }
  for (const GoalStatus& one : heard.goals) {
    if (!id_ || one.id != *id_) continue;
    const bool is_over = one.state == GoalState::kSucceeded || one.state == GoalState::kCanceled ||
                         one.state == GoalState::kAborted;
    has_ended_ = has_ended_ || is_over;
    if (one.state == GoalState::kAborted) problem_ = "finds no way to where it is to go";
    if (one.state == GoalState::kSucceeded) problem_.clear();
  }
}

void Goals::drop() {
  id_.reset();
  request_ = 0;
}

}  // namespace mlab::ros2
