#include "mlab/fleet/fence.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace mlab::fleet {
namespace {

using geom::Offset;
using geom::Point;

constexpr double kSlack = 1e-6;            // of sums of steps [m]
constexpr int kMostStepsToStand = 10'000;  // of bodies that hardly brake
constexpr double kStands = 1e-6;           // slower than this [m/s]

Offset ahead_of(double heading) {
  return {std::cos(heading), std::sin(heading)};
}

// A body between two cycles, moved by the laws that the simulator has.
class Body {
 public:
  Body(const binding::Kinematics& kinematics, const Motion& motion)
      : kinematics_(kinematics), place_(motion.pose.position), heading_(motion.pose.heading) {
    momentum_.velocity = motion.velocity;
    momentum_.speed = dot(motion.velocity, ahead_of(heading_));
    momentum_.turn_rate = motion.turn_rate;
  }
  void step(const percept::Action& action, double dt) {
    const binding::WantedMotion wanted =
        binding::drive(kinematics_, action, heading_, ahead_of(heading_), momentum_, dt);
    place_ = place_ + wanted.step;
    heading_ = wanted.heading;
    momentum_ = wanted.momentum;
  }
  Point place() const { return place_; }
  double speed() const { return length(momentum_.velocity); }

 private:
  const binding::Kinematics& kinematics_;
  Point place_;
  double heading_;
  binding::Momentum momentum_;
};

// How far it comes, at the most, if it gathers speed for a cycle and then brakes [m].
double reach(const binding::Kinematics& kinematics, const percept::Action& action, const Motion& motion,
             double dt) {
  double wanted = action.drives ? geom::length(action.velocity) : 0.0;
  if (kinematics.max_speed > 0.0) wanted = std::min(wanted, kinematics.max_speed);
  const double speed = std::max(wanted, length(motion.velocity));
  const double braking =
      kinematics.max_acceleration > 0.0 ? speed * speed / (2.0 * kinematics.max_acceleration) : 0.0;
  return 2.0 * speed * dt + braking;
}

}  // namespace

Fence::Fence(std::span<const Point> corners) {
  for (std::size_t i = 0; i < corners.size(); ++i)
    sides_.push_back({corners[i], corners[(i + 1) % corners.size()]});
}

Point Fence::nearest(Point place) const {
  Point out = place;
  double least = std::numeric_limits<double>::infinity();
  for (const geom::Segment& side : sides_) {
    const Point on_side = geom::nearest_point(side, place);
    const double far = geom::distance(on_side, place);
    if (far >= least) continue;
    least = far;
    out = on_side;
  }
  return out;
}

double Fence::depth(Point place) const {
  // How often a ray to the east crosses the line.
  bool is_inside = false;
  for (const geom::Segment& side : sides_) {
    const bool crosses = (side.a.y > place.y) != (side.b.y > place.y);
    if (crosses && place.x < side.a.x + (side.b.x - side.a.x) * (place.y - side.a.y) / (side.b.y - side.a.y))
      is_inside = !is_inside;
  }
  const double far = geom::distance(nearest(place), place);
  return is_inside ? far : -far;
}

bool Fence::allows(const binding::Kinematics& kinematics, const percept::Action& action, const Motion& motion,
                   double radius, double dt) const {
  const double before = depth(motion.pose.position) - radius;
  if (before > reach(kinematics, action, motion, dt)) return true;
  // Who is too near already may only gain.
  const double least = std::min(before, 0.0) - kSlack;
  Body body(kinematics, motion);
  body.step(action, dt);
  const Point first = body.place();
  if (depth(first) - radius < least) return false;
  for (int i = 0; body.speed() > kStands; ++i) {
    // Nobody knows where one comes to stand that brakes for longer.
    if (i == kMostStepsToStand) return false;
    body.step({}, dt);
    if (depth(body.place()) - radius < least) return false;
  }
  return true;
}

}  // namespace mlab::fleet
