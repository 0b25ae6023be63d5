#include "mlab/vehicle/pose_history.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "mlab/base/angle.h"

namespace mlab::vehicle {
namespace {

constexpr double kUnknownGap = 1.0;        // between motions that nothing is known of what is between [s]
constexpr std::size_t kMostMotions = 256;  // motions

/// Along the arc on which it moves.
geom::Pose moved(const Motion& motion, double dt) {
  const double turn = motion.turn_rate * dt;
  const double heading = motion.pose.heading + turn / 2.0;
  const geom::Offset way = geom::Offset{std::cos(heading), std::sin(heading)} * (motion.speed * dt);
  return {motion.pose.position + way, base::wrap_angle(motion.pose.heading + turn)};
}

geom::Pose between(const Motion& a, const Motion& b, double share) {
  const double turn = base::wrap_angle(b.pose.heading - a.pose.heading);
  return {a.pose.position + (b.pose.position - a.pose.position) * share,
          base::wrap_angle(a.pose.heading + turn * share)};
}

}  // namespace

void PoseHistory::add(const Motion& motion) {
  if (!motions_.empty()) {
    const double newer = seconds_between(motions_.back().at, motion.at);
    if (newer < -kKept) motions_.clear();
    if (newer <= 0.0 && !motions_.empty()) return;
  }
  motions_.push_back(motion);
  while (motions_.size() > kMostMotions || seconds_between(motions_.front().at, motion.at) > kKept)
    motions_.pop_front();
}

std::optional<geom::Pose> PoseHistory::at(Clock::time_point time) const {
  const auto after = std::ranges::upper_bound(motions_, time, {}, &Motion::at);
  const Motion* const a = after == motions_.begin() ? nullptr : &*std::prev(after);
  const Motion* const b = after == motions_.end() ? nullptr : &*after;
  if (a != nullptr && b != nullptr) {
    const double whole = seconds_between(a->at, b->at);
    if (whole <= kUnknownGap) return between(*a, *b, seconds_between(a->at, time) / whole);
  }
  if (a != nullptr && seconds_between(a->at, time) <= kAhead) return moved(*a, seconds_between(a->at, time));
  if (b != nullptr && seconds_between(time, b->at) <= kAhead) return moved(*b, seconds_between(b->at, time));
  return std::nullopt;
}

}  // namespace mlab::vehicle
