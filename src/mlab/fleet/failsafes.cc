#include "mlab/fleet/failsafes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "mlab/robot/program/program_runner.h"

namespace mlab::fleet {
namespace {

using mission::FailsafeAction;
using mission::FailsafeCondition;

constexpr double kWantsToDrive = 0.05;  // whoever wants to be faster [m/s]
constexpr double kGetsOn = 0.5;         // who has come so far is not stuck [m]
constexpr double kIsHome = 0.5;         // [m]
constexpr double kReversed = 3.0;       // from the line [m]
constexpr double kReverseSpeed = 0.5;   // [m/s]
constexpr double kReverseSpin = 1.0;    // [rad/s]
constexpr double kAlongTheLine =
    0.7;                            // cosine between a heading and the way inside, below which it leads along
constexpr double kCharged = 0.05;   // more than it takes, of who had too little
constexpr double kLowOn = 0.2;      // a battery is watched from so far above the share on
constexpr double kTurnsBack = 0.5;  // nearer to a fence it has to turn back to be free again [m]
constexpr double kPassingSphere = Situation::kSight;
constexpr double kMostPush = 2.0;  // against one step towards the goal
constexpr double kClear = 0.5;     // between its body and what it passes [m]

static_assert(mission::kMostFailsafes <= 16, "Situation::rows has a bit for each");

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

// Of percepts that its program answers, and of what its vehicle has said, whichever is older [s]; 0: all is
// in time.
double stale_for(const Situation& situation) {
  const double motion_age = situation.vehicle ? situation.vehicle->motion_age : 0.0;
  return std::max(situation.percept_age, motion_age > robot::kActionPatience ? motion_age : 0.0);
}

// The share that is known to be left; what nobody knows is not relied on.
std::optional<double> battery_of(const binding::Upkeep& vehicle) {
  return vehicle.battery_age <= Situation::kBatteryPatience ? vehicle.battery : std::nullopt;
}

// For how long the condition has held, where that is measured and not counted in cycles [s].
std::optional<double> known_to_last(FailsafeCondition condition, const Situation& situation) {
  if (condition == FailsafeCondition::kLinkLost) return situation.silence;
  if (condition == FailsafeCondition::kPerceptsStale) return stale_for(situation);
  return std::nullopt;
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

bool Failsafes::watches(mission::FailsafeWatch when) const {
  return std::ranges::any_of(
      rows_, [&](const mission::Failsafe& row) { return mission::info(row.condition).watch == when; });
}

std::uint16_t Failsafes::rows_of(std::string_view type) const {
  unsigned out = 0;
  for (std::size_t i = 0; i < rows_.size(); ++i) out |= rows_[i].is_of(type) ? 1U << i : 0U;
  return static_cast<std::uint16_t>(out);
}

// It stands on when what was wrong is over.
bool Failsafes::goes_on(std::size_t row) const {
  const FailsafeAction action = rows_[row].action;
  return action == FailsafeAction::kReturn || action == FailsafeAction::kReverseInside;
}

template <class Visit>
void Failsafes::for_each_own(std::uint16_t rows, Visit&& visit) const {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if ((rows >> i & 1U) != 0) visit(i);
  }
}

percept::Needs Failsafes::needs(std::uint16_t rows, const FailsafeState& state) const {
  percept::Needs out;
  for_each_own(rows, [&](std::size_t i) {
    if (rows_[i].condition == FailsafeCondition::kInContact) out.want(percept::Sensor::kTouch);
  });
  if (!returns(state)) return out;
  out.want(percept::Sensor::kObstacles, Situation::kSight);
  out.want(percept::Sensor::kRobots, Situation::kSight);
  return out;
}

double Failsafes::passage_reach(const Situation& situation, const percept::Action& wanted, double dt) const {
  percept::Action driven;
  driven.drives = true;
  driven.velocity.x = std::max(situation.cruise_speed, kReverseSpeed);
  const auto reach = [&](const percept::Action& action) {
    return Fence::reach(*situation.kinematics, action, situation.motion, dt);
  };
  const double far = std::max(reach(wanted), reach(driven)) + situation.radius;
  bool is_near = false;
  for_each_own(situation.rows, [&](std::size_t i) {
    is_near = is_near || (rows_[i].condition == FailsafeCondition::kOutside &&
                          fences_[i].depth(situation.motion.pose.position) <= far + kTurnsBack);
  });
  return is_near ? far : 0.0;
}

// Who has come no half metre further, though he wants to, and no other failsafe makes him stand.
bool Failsafes::makes_no_way(const Situation& situation, const percept::Action& wanted,
                             FailsafeState& state) const {
  const bool is_held = state.active != FailsafeState::kNone &&
                       rows_[state.active].action != FailsafeAction::kContinue &&
                       rows_[state.active].condition != FailsafeCondition::kStuck;
  const bool wants = wanted.drives && geom::length(wanted.velocity) > kWantsToDrive && !is_held;
  const geom::Point here = situation.motion.pose.position;
  if (wants && state.has_anchor && geom::distance(here, state.anchor) < kGetsOn) return true;
  state.anchor = here;
  state.has_anchor = wants;
  return false;
}

bool Failsafes::holds(std::size_t row, const Situation& situation, const percept::Action& wanted, double dt,
                      const FailsafeState& state) const {
  switch (rows_[row].condition) {
    case FailsafeCondition::kOutside: {
      const double margin = state.is_met[row] ? kTurnsBack : 0.0;
      return !fences_[row].allows(*situation.kinematics, wanted, situation.motion, situation.radius + margin,
                                  dt, *situation.passage) ||
             fences_[row].depth(situation.motion.pose.position) < 0.0;
    }
    case FailsafeCondition::kInContact:
      return situation.is_in_contact;
    case FailsafeCondition::kStuck:
      return state.makes_no_way;
    case FailsafeCondition::kLinkLost:
      return situation.silence > 0.0;
    case FailsafeCondition::kPerceptsStale:
      return stale_for(situation) > 0.0;
    case FailsafeCondition::kOperatorAbsent:
      return situation.lacks_operator;
    case FailsafeCondition::kBattery:
      return situation.vehicle && lacks_battery(row, *situation.vehicle, state);
  }
  return false;
}

// A battery that recovers while its vehicle stands is not charged for that.
bool Failsafes::lacks_battery(std::size_t row, const binding::Upkeep& vehicle,
                              const FailsafeState& state) const {
  if (!battery_of(vehicle)) return vehicle.battery_age > Situation::kBatteryPatience;
  return *vehicle.battery < std::min(1.0, rows_[row].share + (state.is_met[row] ? kCharged : 0.0));
}

RowStanding Failsafes::standing(std::size_t row, const Situation& situation, const percept::Action& action,
                                double dt, const FailsafeState& state) const {
  using State = RowStanding::State;
  RowStanding out;
  if ((situation.rows >> row & 1U) == 0) return out;
  if (rows_[row].condition == FailsafeCondition::kOutside) {
    const double room = fences_[row].depth(situation.motion.pose.position) - situation.radius;
    const double needed = Fence::reach(*situation.kinematics, action, situation.motion, dt) + kTurnsBack;
    out.measure = room;
    out.used = room > needed ? needed / room : 1.0;
  } else if (rows_[row].condition == FailsafeCondition::kBattery) {
    const std::optional<double> left = situation.vehicle ? battery_of(*situation.vehicle) : std::nullopt;
    out.measure = left.value_or(-1.0);
    const double above = left ? *left - rows_[row].share : kLowOn;
    const double spent = std::clamp(1.0 - above / kLowOn, 0.0, 1.0);
    out.used = state.is_met[row] ? 1.0 : spent;
  } else {
    const double seconds = rows_[row].seconds;
    out.measure = state.held[row];
    out.used = state.is_met[row] ? 1.0 : seconds > 0.0 ? std::min(state.held[row] / seconds, 1.0) : 0.0;
  }
  out.state = state.active == row                  ? State::kActive
              : (state.waiting >> row & 1U) != 0   ? State::kWaiting
              : state.is_met[row]                  ? State::kOverruled
              : out.used >= RowStanding::kNearFrom ? State::kNear
                                                   : State::kArmed;
  return out;
}

// A robot that begins outside has not left: it is let in first.
std::optional<std::size_t> Failsafes::begin(const Situation& situation, FailsafeState& state) const {
  std::optional<std::size_t> out;
  if (std::exchange(state.has_begun, true)) return out;
  for_each_own(situation.rows, [&](std::size_t i) {
    if (rows_[i].condition != FailsafeCondition::kOutside ||
        fences_[i].depth(situation.motion.pose.position) >= situation.radius)
      return;
    state.is_met[i] = true;
    if (!out) out = i;
  });
  return out;
}

// The rows whose conditions have now held for long enough, and did not before; a bit for each.
std::uint16_t Failsafes::newly_met(const Situation& situation, const percept::Action& wanted, double dt,
                                   FailsafeState& state) const {
  unsigned out = 0;
  state.makes_no_way = makes_no_way(situation, wanted, state);
  for_each_own(situation.rows, [&](std::size_t i) {
    const bool is_true = holds(i, situation, wanted, dt, state);
    const double lasted = known_to_last(rows_[i].condition, situation).value_or(state.held[i] + dt);
    state.held[i] = is_true ? lasted : 0.0;
    const bool is_met = is_true && state.held[i] >= rows_[i].seconds;
    if (is_met && !state.is_met[i]) out |= 1U << i;
    state.is_met[i] = is_met;
  });
  return static_cast<std::uint16_t>(out);
}

// What is over, and what would have acted but for it.
void Failsafes::end(const Situation& situation, FailsafeState& state, Outcome& out) const {
  if (state.active != FailsafeState::kNone) {
    const bool is_escaped = situation.is_steered || situation.order != state.order;
    if (is_escaped) state.waiting = 0;
    out.is_over = is_escaped || (!goes_on(state.active) && !state.is_met[state.active]);
    if (out.is_over) state.active = FailsafeState::kNone;
  }
  for_each_own(situation.rows, [&](std::size_t i) {
    if (!state.is_met[i] && !goes_on(i)) state.waiting &= static_cast<std::uint16_t>(~(1U << i));
  });
}

void Failsafes::reverse(const Fence& fence, const Situation& situation, percept::Action& action) const {
  stand(action);
  const geom::Pose& pose = situation.motion.pose;
  if (fence.depth(pose.position) - situation.radius >= kReversed) return;
  const geom::Offset inward = fence.inward(pose.position);
  const geom::Vector way = pose.to_robot(pose.position + inward);
  action.drives = true;
  if (situation.kinematics->drive == binding::Drive::kHolonomic) {
    action.velocity = way * kReverseSpeed;
    return;
  }
  // Forwards or backwards, whichever way leads inside, and round until it leads straight there. Who can turn
  // on the spot does that first.
  const double ahead = way.x < 0.0 ? -1.0 : 1.0;
  const bool turns_first =
      situation.kinematics->drive != binding::Drive::kCar && std::abs(way.x) < kAlongTheLine;
  action.velocity = {turns_first ? 0.0 : ahead * kReverseSpeed, 0.0, 0.0};
  action.spins = true;
  const double error = std::atan2(ahead * way.y, ahead * way.x);
  action.spin = std::clamp(error, -kReverseSpin, kReverseSpin);
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
  out.outside = begin(situation, state);
  const unsigned met = newly_met(situation, action, dt, state);
  end(situation, state, out);
  state.waiting |= static_cast<std::uint16_t>(met);
  const auto first = static_cast<std::size_t>(std::countr_zero(state.waiting));
  if (state.waiting != 0 && first < state.active) {
    unsigned waiting = state.waiting & ~(1U << first);
    if (state.active != FailsafeState::kNone) {
      out.gave_way = state.active;
      waiting |= 1U << state.active;
    }
    state.waiting = static_cast<std::uint16_t>(waiting);
    state.active = static_cast<std::uint8_t>(first);
    state.order = situation.order;
    out.triggered = first;
  }
  if (state.active != FailsafeState::kNone) act(rows_[state.active], situation, action);
  for_each_own(situation.rows, [&](std::size_t i) {
    if (rows_[i].condition == FailsafeCondition::kOutside &&
        !fences_[i].allows(*situation.kinematics, action, situation.motion, situation.radius, dt,
                           *situation.passage))
      stand(action);
  });
  return out;
}

}  // namespace mlab::fleet
