#include "mlab/ros2/goals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "mlab/base/angle.h"

namespace mlab::ros2 {
namespace {

/// A navigator plans anew for each goal.
constexpr std::chrono::milliseconds kBetweenGoals{500};
/// A goal that its navigator has not told of by then was not taken.
constexpr std::chrono::milliseconds kHeardOfWithin{2000};
/// A navigator that goes for so long has found a way.
constexpr std::chrono::milliseconds kFoundAfter{3000};
constexpr double kMoved = 0.25;  // a target that has moved less is the same one [m]
constexpr double kTurned = 0.2;  // [rad]
/// Who steers by velocities turns hard until it looks right, which is long before a goal is reached; so a
/// turn counts for little more than the time until the next goal, else it would swing to and fro.
constexpr double kBendsFor = 0.4;  // while it goes [s]
constexpr double kTurnsFor = 1.0;  // on the spot [s]
constexpr double kStands = 0.02;   // what is slower does not go [m/s]
constexpr double kAheadFor = 2.0;  // at full speed [s]
/// Nav2 takes 0.25 m for being there, and goes slower where a goal is near.
constexpr double kNearest = 0.8;  // [m]
/// Strangers may tell of as many as they like; what is not kept now is told again.
constexpr std::size_t kMostKept = 32;
constexpr std::size_t kMostTakenBack = 8;

/// What ids of all our goals begin with, whatever process they are of.
constexpr std::array<std::uint8_t, 4> kMark = {'m', 'l', 'a', 'b'};

bool is_ours(const GoalId& id) {
  return std::equal(kMark.begin(), kMark.end(), id.bytes);
}

// One that is being taken back is gone to no more.
bool is_gone_to(GoalState state) {
  return state == GoalState::kAccepted || state == GoalState::kExecuting;
}

bool is_among(const GoalId& id, const std::vector<GoalId>& ids) {
  return std::ranges::find(ids, id) != ids.end();
}

}  // namespace

double look_ahead_for(double max_speed) {
  return std::max(kNearest, kAheadFor * max_speed);
}

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
  std::ranges::copy(kMark, out.bytes);
  for (unsigned i = 0; i < 8; ++i) out.bytes[4 + i] = static_cast<std::uint8_t>(session_ >> (8 * i));
  for (unsigned i = 0; i < 4; ++i) out.bytes[12 + i] = static_cast<std::uint8_t>(count_ >> (8 * i));
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
  has_ended_ = is_known_ = false;
  sent_at_ = now;
  if (!unanswered_since_) unanswered_since_ = now;
  std::erase_if(unheard_, [&](const Sent& one) { return now - one.at > kHeardOfWithin; });
  unheard_.push_back({*id_, now});
  return Goal{*id_, stamp, frame, target.position.x, target.position.y, target.heading};
}

void Goals::note_heard_of(const GoalId& id) {
  if (std::erase_if(unheard_, [&](const Sent& one) { return one.id == id; }) == 0) return;
  unanswered_since_.reset();
  if (problem_ == Problem::kNotTaken) problem_ = Problem::kNone;
}

void Goals::take_state(GoalState state, Time now) {
  is_known_ = true;
  has_ended_ = has_ended_ || is_over(state);
  if (has_ended_)
    goes_since_.reset();
  else if (!goes_since_)
    goes_since_ = now;
  const bool found_its_way = goes_since_ && now - *goes_since_ > kFoundAfter;
  if (problem_ == Problem::kNoWay && (found_its_way || state == GoalState::kSucceeded))
    problem_ = Problem::kNone;
  // One that had to make room for somebody else's is aborted, too.
  if (state == GoalState::kAborted && !is_taken_) problem_ = Problem::kNoWay;
}

// Others' goals that are over are not to be remembered.
void Goals::look_for_others() {
  std::erase_if(engaged_, [&](const GoalId& one) { return !is_among(one, others_); });
  is_taken_ = std::ranges::any_of(others_, [&](const GoalId& one) { return !is_among(one, engaged_); });
}

void Goals::take(const std::vector<GoalStatus>& goals, Time now) {
  ours_.clear();
  others_.clear();
  std::optional<GoalState> state;
  for (const GoalStatus& one : goals) {
    std::vector<GoalId>& whose = is_ours(one.id) ? ours_ : others_;
    if (is_gone_to(one.state) && whose.size() < kMostKept) whose.push_back(one.id);
    if (is_ours(one.id)) note_heard_of(one.id);
    if (id_ && one.id == *id_) state = one.state;
  }
  look_for_others();
  if (state)
    take_state(*state, now);
  else if (is_known_)
    has_ended_ = true;  // it is not known any more
}

void Goals::take(const Heard& heard, Time now) {
  if (heard.goals) take(*heard.goals, now);
  for (const GoalFeedback& one : heard.feedback) {
    note_heard_of(one.id);
    if (id_ && one.id == *id_) is_held_up_ = one.recoveries > 0;
  }
  if (!id_) return;
  if (!is_known_ && sent_at_ && now - *sent_at_ > kHeardOfWithin) has_ended_ = true;
  if (unanswered_since_ && now - *unanswered_since_ > kHeardOfWithin) problem_ = Problem::kNotTaken;
}

void Goals::drop() {
  id_.reset();
  unanswered_since_.reset();
  goes_since_.reset();
  is_held_up_ = false;
  problem_ = Problem::kNone;
}

void Goals::forget() {
  has_ended_ = true;
  is_known_ = false;
  unanswered_since_.reset();
}

std::vector<GoalId> Goals::to_take_back(Time now) const {
  std::vector<GoalId> out = ours_;
  for (const Sent& one : unheard_) {
    if (now - one.at <= kHeardOfWithin) out.push_back(one.id);
  }
  if (out.size() > kMostTakenBack) out.resize(kMostTakenBack);
  return out;
}

void Goals::engage() {
  engaged_ = others_;
  look_for_others();
}

std::string_view Goals::problem() const {
  if (problem_ == Problem::kNotTaken) return "does not take the goals that it is given";
  if (problem_ == Problem::kNoWay) return "finds no way to where it is to go";
  return is_held_up_ ? "is held up on its way, and tries to get free" : "";
}

}  // namespace mlab::ros2
