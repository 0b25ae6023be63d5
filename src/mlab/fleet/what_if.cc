#include "mlab/fleet/what_if.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/core.h>

#include "mlab/binding/kinematics.h"
#include "mlab/robot/program/program_runner.h"

namespace mlab::fleet {
namespace {

using geom::Offset;
using geom::Point;
using mission::FailsafeAction;
using mission::FailsafeCondition;
using What = WhatIfEvent::What;

constexpr double kStandsStill = 1e-3;  // slower than this [m/s]
constexpr double kAfterwards = 1.0;    // it is watched for so long at least when all is over [s]
constexpr binding::Upkeep kFull = {.motion_age = 0.0, .battery = 1.0, .battery_age = 0.0};
constexpr double kMostWork = 4e6;  // as in work_of_cycle: less than a person would notice

bool is_within(double value, double low, double high) {
  return value >= low && value <= high;  // false for what is no number
}

std::optional<std::string> why_not(const Failsafes& failsafes, const Situation& robot, const WhatIf& asked) {
  for (const mission::FailsafeConditionInfo& one : mission::kFailsafeConditions) {
    if (!is_within(asked.lasts(one.condition), 0.0, one.may_last ? WhatIf::kMostSeconds : 0.0))
      return one.may_last ? fmt::format("{} lasts from 0 to {:g} s", one.word, WhatIf::kMostSeconds)
                          : fmt::format("{} does not last: it is tried at a line", one.word);
  }
  if (!is_within(asked.speed, 0.0, WhatIf::kMostSpeed))
    return fmt::format("the speed is a number from 0 to {:g} m/s", WhatIf::kMostSpeed);
  if (!asked.fence) return std::nullopt;
  const std::size_t row = asked.fence->row;
  const bool is_fence =
      row < failsafes.rows().size() && failsafes.rows()[row].condition == FailsafeCondition::kOutside;
  if (!is_fence) return fmt::format("row {} of the table is no OUTSIDE", row + 1);
  if ((robot.rows >> row & 1U) == 0) return fmt::format("row {} of the table is not this robot's", row + 1);
  if (!is_within(asked.fence->depth, -WhatIf::kMostDepth, WhatIf::kMostDepth))
    return fmt::format("the distance from the line is a number from -{0:g} to {0:g} m", WhatIf::kMostDepth);
  if (!is_within(asked.fence->bearing, -WhatIf::kMostBearing, WhatIf::kMostBearing))
    return "the heading is an angle of at most a full turn";
  return std::nullopt;
}

// From the place on the line that the robot is nearest to, else from the middle of a side: where one comes so
// far from there, and to no other side.
std::expected<geom::Pose, std::string> place_at(const mission::Failsafe& row, const Fence& fence, Point near,
                                                const WhatIf::AtFence& asked) {
  constexpr double kExact = 1e-3;
  constexpr std::size_t kMostTried = 32;  // each is held against all sides
  std::vector<Point> tried = {fence.nearest(near)};
  for (std::size_t i = 0; i < row.fence.size(); i += 1 + row.fence.size() / kMostTried) {
    const Point next = row.fence[(i + 1) % row.fence.size()];
    tried.push_back(row.fence[i] + (next - row.fence[i]) * 0.5);
  }
  for (const Point on_line : tried) {
    const Offset inward = fence.inward(on_line);
    const Point place = on_line + inward * asked.depth;
    if (length(inward) <= 0.0 || std::abs(fence.depth(place) - asked.depth) > kExact) continue;
    const double out = std::atan2(-inward.y, -inward.x);
    return geom::Pose{place, out + asked.bearing};
  }
  return std::unexpected(fmt::format("`{}` has no place that is {:g} m {} its line: come nearer to it",
                                     row.fence_name, std::abs(asked.depth),
                                     asked.depth < 0.0 ? "beyond" : "within"));
}

// A robot by itself, that its failsafes guard for as long as somebody looks.
class Trial {
 public:
  Trial(const Failsafes& failsafes, const Situation& robot, const WhatIf& asked, double dt)
      : failsafes_(failsafes), asked_(asked), dt_(dt), now_(robot) {
    now_.passage = &nothing_;
    now_.obstacles = {};
    now_.others = {};
    now_.silence = now_.percept_age = 0.0;
    now_.order = 0;
    now_.is_steered = now_.is_in_contact = now_.lacks_operator = false;
    now_.vehicle = kFull;
    out_.most_used.resize(failsafes.rows().size());
  }

  WhatIfOutcome run(const geom::Pose& from) {
    begin(from);
    std::size_t last = cycles_stuck();
    for (const double seconds : asked_.lasting) last = std::max(last, cycles(seconds));
    last += cycles(kAfterwards);
    const std::size_t settled =
        last + cycles(WhatIf::kMostSettling + seconds_to_fence() + seconds_until_stuck());
    double work = 0.0;
    std::size_t i = 0;
    for (; i < settled && (i < last || !is_settled(static_cast<double>(i) * dt_)); ++i) {
      work += work_of_cycle();
      if (i == WhatIf::kMostCycles || work > kMostWork) {
        out_.is_cut = true;
        break;
      }
      step(i);
    }
    out_.seconds = static_cast<double>(i) * dt_;
    finish();
    return std::move(out_);
  }

 private:
  // A condition that lasts so long holds at its end, too.
  std::size_t cycles(double seconds) const {
    if (seconds <= 0.0) return 0;
    const double whole = std::ceil(seconds / dt_ - 1e-9) + 1.0;
    return whole < static_cast<double>(WhatIf::kMostCycles) ? static_cast<std::size_t>(whole)
                                                            : WhatIf::kMostCycles + 1;
  }
  bool lasts_in(std::size_t cycle, FailsafeCondition condition) const {
    return cycle < cycles(asked_.lasts(condition));
  }
  // How long it has been so in this cycle, of what is measured by a clock [s].
  double age(std::size_t cycle, FailsafeCondition condition) const {
    const double time = static_cast<double>(cycle + 1) * dt_;
    return lasts_in(cycle, condition) ? std::min(time, asked_.lasts(condition)) : 0.0;
  }
  // In the first of them it is seen where it is.
  std::size_t cycles_stuck() const {
    const double seconds = asked_.lasts(FailsafeCondition::kStuck);
    return seconds > 0.0 ? cycles(seconds) + 1 : 0;
  }
  double room() const {
    return failsafes_.fence(asked_.fence->row).depth(now_.motion.pose.position) - now_.radius;
  }
  // With a detour.
  double seconds_to_fence() const {
    if (!asked_.fence || asked_.speed <= 0.0) return 0.0;
    return std::min(2.0 * std::abs(asked_.fence->depth) / asked_.speed, WhatIf::kMostSeconds);
  }
  double speed() const { return length(now_.motion.momentum.velocity); }

  void begin(const geom::Pose& from) {
    now_.motion = {from, {}};
    const double limit = now_.kinematics->max_speed;
    const double speed = cycles_stuck() > 0 ? 0.0
                         : limit > 0.0      ? std::min(asked_.speed, limit)
                                            : asked_.speed;
    now_.motion.momentum.velocity = Offset{std::cos(from.heading), std::sin(from.heading)} * speed;
    now_.motion.momentum.speed = speed;
    state_.has_begun = !(asked_.fence && asked_.fence->begins_there);
    out_.from = from;
    if (asked_.fence) out_.least_room = room();
  }

  percept::Action wanted() const {
    percept::Action out;
    if (out_.has_stopped || now_.silence > 0.0 || now_.lacks_operator) return out;
    out.drives = true;
    out.velocity = {asked_.speed, 0.0, 0.0};
    return out;
  }

  void step(std::size_t i) {
    const double time = static_cast<double>(i + 1) * dt_;
    const double silence = age(i, FailsafeCondition::kLinkLost);
    now_.silence = silence > robot::kActionPatience ? silence : 0.0;
    now_.percept_age = age(i, FailsafeCondition::kPerceptsStale);
    now_.vehicle->battery = lasts_in(i, FailsafeCondition::kBattery) ? 0.0 : 1.0;
    now_.is_in_contact = lasts_in(i, FailsafeCondition::kInContact);
    now_.lacks_operator = lasts_in(i, FailsafeCondition::kOperatorAbsent);
    now_.is_steered = !now_.lacks_operator && asked_.lasts(FailsafeCondition::kOperatorAbsent) > 0.0;
    action_ = wanted();
    if (!out_.has_stopped) guard(time);
    if (i < cycles_stuck())
      now_.motion.momentum = {};
    else
      move();
    if (asked_.fence) out_.least_room = std::min(out_.least_room, room());
    if (speed() > kStandsStill)
      out_.stood.reset();
    else if (!out_.stood)
      out_.stood = time;
  }

  void guard(double time) {
    const FailsafeState before = state_;
    const Failsafes::Outcome outcome = failsafes_.guard(now_, dt_, state_, action_);
    const auto tell = [&](std::size_t row, What what) {
      if (out_.events.size() < WhatIfOutcome::kMostEvents) out_.events.push_back({time, row, what});
    };
    if (outcome.outside) tell(*outcome.outside, What::kLetsIn);
    for (std::size_t i = 0; i < failsafes_.rows().size(); ++i) {
      if (state_.is_met[i] == before.is_met[i] || outcome.outside == i) continue;
      tell(i, state_.is_met[i] ? What::kMet : What::kNotMet);
    }
    if (outcome.is_over) tell(before.active, What::kIsOver);
    if (outcome.gave_way) tell(*outcome.gave_way, What::kGivesWay);
    if (outcome.triggered) tell(*outcome.triggered, What::kActs);
    if (outcome.triggered && failsafes_.rows()[*outcome.triggered].action == FailsafeAction::kStop) {
      out_.has_stopped = true;
      action_ = {};
    }
    for (std::size_t i = 0; i < out_.most_used.size(); ++i)
      out_.most_used[i] =
          std::max(out_.most_used[i], failsafes_.standing(i, now_, action_, dt_, state_).used);
  }

  // By the laws that the simulator has.
  void move() {
    geom::Pose& pose = now_.motion.pose;
    const binding::WantedMotion motion =
        binding::drive(*now_.kinematics, action_, pose.heading,
                       {std::cos(pose.heading), std::sin(pose.heading)}, now_.motion.momentum, dt_);
    pose.position = pose.position + motion.step;
    pose.heading = motion.heading;
    now_.motion.momentum = motion.momentum;
  }

  // Who is held somewhere, and wants to go on, is stuck there in time.
  double seconds_until_stuck() const {
    double out = 0.0;
    for (std::size_t i = 0; i < failsafes_.rows().size(); ++i) {
      const mission::Failsafe& row = failsafes_.rows()[i];
      const bool may_come = row.condition == FailsafeCondition::kStuck && (now_.rows >> i & 1U) != 0 &&
                            !state_.is_met[i] && !out_.has_stopped;
      if (may_come) out = std::max(out, row.seconds + kAfterwards);
    }
    return std::min(out, WhatIf::kMostSeconds);
  }

  // Nothing more becomes of it.
  bool is_settled(double time) const {
    const bool is_free = state_.active == FailsafeState::kNone && state_.waiting == 0;
    if (is_free && !asked_.fence) return true;
    if (!out_.stood || (action_.drives && !out_.has_stopped)) return false;
    if (asked_.speed <= 0.0 || out_.has_stopped) return true;
    return time >= *out_.stood + (state_.makes_no_way ? seconds_until_stuck() : kAfterwards);
  }

  // In looks at a side of a fence, at the most: where the body may brake on a curve, each step of that is
  // held against the fences that are near.
  double work_of_cycle() const {
    constexpr double kLooks = 6.0;        // at each side, for how far it is
    constexpr double kLooksOfStep = 5.0;  // at each side, for whether a step keeps off it
    constexpr double kStep = 20.0;        // to know where it leads
    const double steps = steps_to_stand();
    const double far = reach();
    double out = kLooks;
    for (std::size_t i = 0; i < failsafes_.rows().size(); ++i) {
      const auto sides = static_cast<double>(failsafes_.rows()[i].fence.size());
      out += kLooks * (1.0 + sides);
      if (sides <= 0.0 || failsafes_.fence(i).depth(now_.motion.pose.position) - now_.radius > far) continue;
      out += 2.0 * steps * (kLooksOfStep * sides + kStep);
    }
    return out;
  }
  // The fastest that it drives in the coming cycle [m/s].
  double most_speed() const {
    const double wanted = std::max({asked_.speed, now_.cruise_speed, 1.0});
    const double limit = now_.kinematics->max_speed;
    return std::max(
        {limit > 0.0 ? std::min(wanted, limit) : wanted, speed(), std::abs(now_.motion.momentum.speed)});
  }
  double reach() const {
    percept::Action fastest;
    fastest.drives = true;
    fastest.velocity.x = most_speed();
    return Fence::reach(*now_.kinematics, fastest, now_.motion, dt_);
  }
  // Of those that are known only one by one.
  double steps_to_stand() const {
    const binding::Kinematics& kinematics = *now_.kinematics;
    const double slower = kinematics.max_acceleration * dt_;
    const bool is_straight = kinematics.drive == binding::Drive::kHolonomic ||
                             kinematics.max_turn_acceleration <= 0.0 || slower <= 0.0;
    const double now = std::max(speed(), std::abs(now_.motion.momentum.speed));
    return is_straight ? 1.0 : std::min(now / slower + 2.0, static_cast<double>(Fence::kMostStepsToStand));
  }

  void finish() {
    out_.to = now_.motion.pose;
    out_.speed = speed();
    if (asked_.fence) out_.last_room = room();
    for (std::size_t i = 0; i < failsafes_.rows().size(); ++i)
      out_.rows.push_back(failsafes_.standing(i, now_, action_, dt_, state_));
  }

  const Failsafes& failsafes_;
  const WhatIf& asked_;
  const double dt_;
  const binding::Passage nothing_;
  Situation now_;
  FailsafeState state_;
  percept::Action action_;
  WhatIfOutcome out_;
};

}  // namespace

std::expected<WhatIfOutcome, std::string> what_if(const Failsafes& failsafes, const Situation& robot,
                                                  const WhatIf& conditions, double dt) {
  if (auto reason = why_not(failsafes, robot, conditions)) return std::unexpected(std::move(*reason));
  Trial trial(failsafes, robot, conditions, dt);
  if (!conditions.fence) return trial.run(robot.motion.pose);
  const WhatIf::AtFence& at = *conditions.fence;
  auto from = place_at(failsafes.rows()[at.row], failsafes.fence(at.row), robot.motion.pose.position, at);
  if (!from) return std::unexpected(std::move(from.error()));
  return trial.run(*from);
}

}  // namespace mlab::fleet
