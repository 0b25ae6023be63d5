#include "mlab/fleet/fence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <utility>

namespace mlab::fleet {
namespace {

using geom::Offset;
using geom::Point;

constexpr double kSlack = 1e-6;   // of sums of steps [m]
constexpr double kStands = 1e-6;  // slower than this [m/s]

Offset ahead_of(double heading) {
  return {std::cos(heading), std::sin(heading)};
}

// A body that is moved by the laws that the simulator has.
class Body {
 public:
  Body(const binding::Kinematics& kinematics, const Motion& motion)
      : kinematics_(kinematics),
        place_(motion.pose.position),
        heading_(motion.pose.heading),
        momentum_(motion.momentum) {}
  /// Where it would go if it were free.
  Offset step(const percept::Action& action, double dt) {
    const binding::WantedMotion wanted =
        binding::drive(kinematics_, action, heading_, ahead_of(heading_), momentum_, dt);
    heading_ = wanted.heading;
    momentum_ = wanted.momentum;
    return wanted.step;
  }
  /// It has come there; what it met has taken from its momentum.
  void arrive(Point place, Offset wanted, double dt) {
    const bool is_free = place == place_ + wanted;
    const Offset gone = place - place_;
    place_ = place;
    if (is_free) return;
    const double square = dot(wanted, wanted);
    momentum_.speed *= square > 0.0 ? std::clamp(dot(gone, wanted) / square, 0.0, 1.0) : 0.0;
    momentum_.velocity = gone * (1.0 / dt);
  }
  Point place() const { return place_; }
  double speed() const { return length(momentum_.velocity); }

  /// Braked in finer cycles it comes so much farther.
  Offset rest(double dt) const {
    return kinematics_.max_acceleration > 0.0 ? momentum_.velocity * (0.5 * dt) : Offset{};
  }
  /// Where it brakes straight: so far it comes then, also in finer cycles.
  std::optional<Offset> braking(double dt) const {
    const double slower = kinematics_.max_acceleration * dt;
    if (slower <= 0.0) return Offset{};
    const bool is_holonomic = kinematics_.drive == binding::Drive::kHolonomic;
    const bool is_straight =
        is_holonomic || momentum_.turn_rate == 0.0 || kinematics_.max_turn_acceleration <= 0.0;
    if (!is_straight) return std::nullopt;
    const Offset velocity = is_holonomic ? momentum_.velocity : ahead_of(heading_) * momentum_.speed;
    const double speed = length(velocity);
    if (speed <= 0.0) return Offset{};
    const double cycles = std::floor(speed / slower);
    const double way = dt * (cycles * speed - slower * cycles * (cycles + 1.0) / 2.0) + 0.5 * dt * speed;
    return velocity * (way / speed);
  }

 private:
  const binding::Kinematics& kinematics_;
  Point place_;
  double heading_;
  binding::Momentum momentum_;
};

double least_distance(const geom::Segment& side, const geom::Segment& way) {
  return std::min({geom::distance(nearest_point(side, way.a), way.a),
                   geom::distance(nearest_point(side, way.b), way.b),
                   geom::distance(nearest_point(way, side.a), side.a),
                   geom::distance(nearest_point(way, side.b), side.b)});
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

Offset Fence::inward(Point place) const {
  constexpr double kOnLine = 1e-6;
  const double here = depth(place);
  const Point on_line = nearest(place);
  if (std::abs(here) > kOnLine) return (place - on_line) * (1.0 / here);
  // Of the sides that meet here one leads inside to its left or to its right.
  for (const geom::Segment& side : sides_) {
    const Offset along = side.b - side.a;
    if (length(along) <= 0.0 || geom::distance(nearest_point(side, place), place) > 2.0 * kOnLine) continue;
    const Offset left = Offset{-along.y, along.x} * (1.0 / length(along));
    for (const Offset way : {left, left * -1.0}) {
      if (depth(place + way * (10.0 * kOnLine)) > here) return way;
    }
  }
  return {};
}

double Fence::reach(const binding::Kinematics& kinematics, const percept::Action& action,
                    const Motion& motion, double dt) {
  double wanted = action.drives ? geom::length(action.velocity) : 0.0;
  if (kinematics.max_speed > 0.0) wanted = std::min(wanted, kinematics.max_speed);
  const double speed = std::max({wanted, length(motion.momentum.velocity), std::abs(motion.momentum.speed)});
  const double braking =
      kinematics.max_acceleration > 0.0 ? speed * speed / (2.0 * kinematics.max_acceleration) : 0.0;
  return 2.0 * speed * dt + braking;
}

// Of a way that begins where the body is: nowhere nearer to the line than `least`, or farther outside.
class Fence::Border {
 public:
  /// @param reach  the way goes no farther [m]
  Border(const Fence& fence, Point from, double depth, double radius, double reach)
      : fence_(fence),
        from_(from),
        radius_(radius),
        is_on_line_(std::abs(depth) <= kSlack),
        is_inside_(depth >= 0.0 && !is_on_line_),
        // Who is too near already may only gain.
        least_(std::min(depth - radius, 0.0) - kSlack) {
    if (!is_inside_) return;
    for (const geom::Segment& side : fence.sides_) {
      if (geom::distance(nearest_point(side, from), from) > 2.0 * reach + depth + radius) continue;
      if (near_count_ == near_.size()) {
        near_count_ = kTooMany;
        return;
      }
      near_[near_count_++] = &side;
    }
  }

  /// The way goes on to there. @return  false: it must not
  bool lets(Point to) {
    const geom::Segment way{std::exchange(from_, to), to};
    if (!is_inside_) return lets_in(to);
    const auto is_clear = [&](const geom::Segment& side) {
      return !intersects(side, way) && least_distance(side, way) - radius_ >= least_;
    };
    if (near_count_ == kTooMany) return std::ranges::all_of(fence_.sides_, is_clear);
    return std::all_of(near_.begin(), near_.begin() + static_cast<std::ptrdiff_t>(near_count_),
                       [&](const geom::Segment* side) { return is_clear(*side); });
  }
  bool lets(std::span<const Point> corners) {
    return std::ranges::all_of(corners, [&](Point corner) { return lets(corner); });
  }

 private:
  // A way that begins on the line touches it. Once it has come inside it must not leave again.
  bool lets_in(Point to) {
    const double depth = fence_.depth(to);
    if (is_on_line_ && depth > kSlack) {
      is_inside_ = true;
      near_count_ = kTooMany;
    }
    return depth - radius_ >= least_;
  }

  static constexpr std::size_t kTooMany = std::numeric_limits<std::size_t>::max();

  const Fence& fence_;
  Point from_;
  double radius_;
  bool is_on_line_;
  bool is_inside_;
  double least_;
  std::array<const geom::Segment*, 32> near_{};
  std::size_t near_count_ = 0;
};

bool Fence::allows(const binding::Kinematics& kinematics, const percept::Action& action, const Motion& motion,
                   double radius, double dt, const binding::Passage& passage) const {
  const double here = depth(motion.pose.position);
  const double far = reach(kinematics, action, motion, dt);
  if (here - radius > far) return true;
  Border border(*this, motion.pose.position, here, radius, far);
  Body body(kinematics, motion);
  const auto go = [&](Offset wanted, double seconds) {
    const binding::Passage::Way way = passage.follow(body.place(), wanted, radius);
    body.arrive(way.end(), wanted, seconds);
    return border.lets(way.corners());
  };
  if (!go(body.step(action, dt), dt)) return false;
  const bool is_free = !passage.is_near(motion.pose.position, far + radius);
  if (const std::optional<Offset> braking = body.braking(dt); braking && is_free)
    return border.lets(body.place() + *braking);
  const Offset rest = body.rest(dt);
  for (int i = 0; body.speed() > kStands; ++i) {
    if (i == kMostStepsToStand) return false;
    if (!go(body.step({}, dt), dt)) return false;
  }
  return border.lets(passage.follow(body.place(), rest, radius).corners());
}

}  // namespace mlab::fleet
