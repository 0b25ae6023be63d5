#include "mlab/fleet/failsafes.h"

#include <algorithm>
#include <cmath>

namespace mlab::fleet {
namespace {

using mission::FailsafeAction;
using mission::FailsafeCondition;

constexpr double kWantsToDrive = 0.05;  // whoever wants to be faster [m/s]
constexpr double kGetsOn = 0.5;         // who has come so far is not stuck [m]
constexpr double kIsHome = 0.5;         // [m]
constexpr double kReversed = 3.0;       // from the line [m]
constexpr double kReverseSpeed = 0.5;   // [m/s]
constexpr double kTurnsBack = 0.5;      // nearer to a fence it has to turn back to be free again [m]
constexpr double kPassingSphere = Situation::kSight;
constexpr double kMostPush = 2.0;  // against one step towards the goal
constexpr double kClear = 0.5;     // between its body and what it passes [m]

static_assert(mission::kMostFailsafes <= 16, "Situation::rows has a bit for each");

bool is_own(const Situation& situation, std::size_t row) {
  return (situation.rows >> row & 1U) != 0;
}

// It brakes. What it asks for, and what it says of its order, are not motion.
void stand(percept::Action& action) {
  action.velocity = {};
  action.spin = 0.0;
  action.drives = action.spins = false;
}

// Away from a thing, and past it on the side that the way leads to: the motor schema that avoids static
// obstacles (Arkin 1989, section IV), turned so that nothing straight ahead stops the robot for ever.
geom::Vector past(geom::Vector thing, double radius, geom::Vector way, const Situation& situation) {
  const double distance = geom::length(thing) - radius - situation.radius;
  if (distance >= kPassingSphere || geom::dot(thing, way) < 0.0) return {};
  const double share = std::clamp((kPassingSphere - distance) / (kPassingSphere - kClear), 0.0, kMostPush);
  const geom::Vector away = -geom::unit(thing);
  const geom::Vector side =
      geom::cross(way, thing) > 0.0 ? geom::Vector{-away.y, away.x, 0.0} : geom::Vector{away.y, -away.x, 0.0};
  return (away + side) * share;
}

void drive_towards(geom::Point goal, const Situation& situation, percept::Action& action) {
  stand(action);
  const geom::Vector to_goal = situation.motion.pose.to_robot(goal);
  const double far = geom::length(to_goal);
  if (far < kIsHome) return;
  const geom::Vector way = geom::unit(to_goal);
  geom::Vector wanted = way;
  for (const percept::Obstacle& one : situation.obstacles)
    wanted += past(one.center, one.radius, way, situation);
  for (const percept::RobotReading& one : situation.others)
    wanted += past(one.center, one.radius, way, situation);
  action.velocity = geom::unit(wanted) * std::min(situation.cruise_speed, far);
  action.drives = true;
}

}  // namespace

Failsafes::Failsafes(std::span<const mission::Failsafe> rows)
    : rows_(rows.begin(),
            rows.begin() + static_cast<std::ptrdiff_t>(std::min(rows.size(), mission::kMostFailsafes))) {
  for (const mission::Failsafe& row : rows_) fences_.emplace_back(row.fence);
}

std::uint16_t Failsafes::rows_of(std::string_view type) const {
  unsigned out = 0;
  for (std::size_t i = 0; i < rows_.size(); ++i) out |= rows_[i].is_of(type) ? 1U << i : 0U;
  return static_cast<std::uint16_t>(out);
}

bool Failsafes::holds(std::size_t row, const Situation& situation, const percept::Action& wanted, double dt,
                      FailsafeState& state) const {
  switch (rows_[row].condition) {
    case FailsafeCondition::kOutside: {
      const double margin = state.is_met[row] ? kTurnsBack : 0.0;
      return !fences_[row].allows(*situation.kinematics, wanted, situation.motion, situation.radius + margin,
                                  dt) ||
             fences_[row].depth(situation.motion.pose.position) < 0.0;
    }
    case FailsafeCondition::kInContact:
      return situation.is_in_contact;
    case FailsafeCondition::kStuck: {
      const bool wants = wanted.drives && geom::length(wanted.velocity) > kWantsToDrive;
      const geom::Point here = situation.motion.pose.position;
      if (!wants || !state.has_anchor || geom::distance(here, state.anchor) >= kGetsOn) {
        state.anchor = here;
        state.has_anchor = wants;
        return false;
      }
      return true;
    }
    case FailsafeCondition::kLinkLost:
      return situation.silence > 0.0;
  }
  return false;
}

// The first row whose condition has now held for long enough, and did not before.
std::optional<std::size_t> Failsafes::newly_met(const Situation& situation, const percept::Action& wanted,
                                                double dt, FailsafeState& state) const {
  std::optional<std::size_t> out;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (!is_own(situation, i)) continue;
    const bool is_true = holds(i, situation, wanted, dt, state);
    const double before = state.held[i];
    state.held[i] = !is_true                                             ? 0.0
                    : rows_[i].condition == FailsafeCondition::kLinkLost ? situation.silence
                                                                         : before + dt;
    const bool is_met = is_true && state.held[i] >= rows_[i].seconds;
    if (is_met && !state.is_met[i] && !out) out = i;
    state.is_met[i] = is_met;
  }
  return out;
}

bool Failsafes::is_over(const Situation& situation, const FailsafeState& state) const {
  if (situation.is_steered || situation.order != state.order) return true;
  const FailsafeAction action = rows_[state.active].action;
  const bool waits = action == FailsafeAction::kHold || action == FailsafeAction::kContinue;
  return waits && !state.is_met[state.active];
}

void Failsafes::reverse(const Fence& fence, const Situation& situation, percept::Action& action) const {
  stand(action);
  const geom::Pose& pose = situation.motion.pose;
  const double depth = fence.depth(pose.position);
  if (depth - situation.radius >= kReversed) return;
  // From outside towards the line, from inside away from it.
  const geom::Vector to_line = geom::unit(pose.to_robot(fence.nearest(pose.position)));
  const geom::Vector way = depth < 0.0 ? to_line : -to_line;
  action.drives = true;
  if (situation.kinematics->drive == binding::Drive::kHolonomic) {
    action.velocity = way * kReverseSpeed;
    return;
  }
  action.velocity = {way.x < 0.0 ? -kReverseSpeed : kReverseSpeed, 0.0, 0.0};
  action.spins = true;  // straight, and backwards where that is the way
}

void Failsafes::act(const mission::Failsafe& row, const Situation& situation, percept::Action& action) const {
  switch (row.action) {
    case FailsafeAction::kContinue:
      break;
    case FailsafeAction::kHold:
    case FailsafeAction::kStop:
      stand(action);
      break;
    case FailsafeAction::kReturn:
      drive_towards(situation.home, situation, action);
      break;
    case FailsafeAction::kReverseInside:
      reverse(fences_[static_cast<std::size_t>(&row - rows_.data())], situation, action);
      break;
  }
}

Failsafes::Outcome Failsafes::guard(const Situation& situation, double dt, FailsafeState& state,
                                    percept::Action& action) const {
  Outcome out;
  const std::optional<std::size_t> met = newly_met(situation, action, dt, state);
  if (state.active != FailsafeState::kNone && is_over(situation, state)) {
    state.active = FailsafeState::kNone;
    out.is_over = true;
  }
  if (met && *met < state.active) {
    state.active = static_cast<std::uint8_t>(*met);
    state.order = situation.order;
    out.triggered = met;
  }
  if (state.active != FailsafeState::kNone) act(rows_[state.active], situation, action);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (rows_[i].condition == FailsafeCondition::kOutside && is_own(situation, i) &&
        !fences_[i].allows(*situation.kinematics, action, situation.motion, situation.radius, dt))
      stand(action);
  }
  return out;
}

}  // namespace mlab::fleet
