#include "mlab/binding/sweep.h"

#include <algorithm>
#include <cmath>

namespace mlab::binding {

using geom::Offset;
using geom::Point;

namespace {

/// A body may start inside the skin; then it may stay as near as it is, but come no nearer, rounding aside.
double nearest_allowed(double radius, double start) {
  return std::min(radius - kSlack, start - 1e-11);
}

}  // namespace

double meets_disc(Offset relative, Offset motion, double radius) {
  const double approach = -dot(relative, motion);
  if (!(approach > 0.0)) return kNever;
  const double way = length(motion);
  const double start = length(relative);
  const double nearest = nearest_allowed(radius, start);
  // The distance from the line of motion: by the cross product, which stays exact however long the motion is.
  const double aside = std::abs(cross(relative, motion)) / way;
  if (aside >= nearest) return kNever;
  const double to_foot = approach / way;  // way to the point of the line that is nearest to the centre
  if (to_foot > way) {
    const Offset end = relative + motion;
    if (length(end) >= nearest) return kNever;
  }
  if (start <= radius || aside >= radius) return 0.0;
  const double contact = to_foot - std::sqrt((radius - aside) * (radius + aside));
  return std::clamp(contact / way, 0.0, 1.0);
}

double meets_wall(const geom::Segment& wall, Point from, Offset motion, double radius) {
  double first =
      std::min(meets_disc(from - wall.a, motion, radius), meets_disc(from - wall.b, motion, radius));
  const Offset along = wall.b - wall.a;
  const double wall_length = length(along);
  if (wall_length <= 0.0) return first;
  double side = cross(along, from - wall.a) / wall_length;
  double speed = cross(along, motion) / wall_length;
  if (side < 0.0) {
    side = -side;
    speed = -speed;
  }
  if (speed >= 0.0) return first;
  // While the point is beside the wall, not beyond one of its ends.
  const double foot = dot(from - wall.a, along);
  const double foot_speed = dot(motion, along);
  double enter = 0.0;
  double leave = 1.0;
  if (foot_speed != 0.0) {
    const double at_a = -foot / foot_speed;
    const double at_b = (wall_length * wall_length - foot) / foot_speed;
    enter = std::max(enter, std::min(at_a, at_b));
    leave = std::min(leave, std::max(at_a, at_b));
  } else if (foot < 0.0 || foot > wall_length * wall_length) {
    return first;
  }
  if (enter > leave || side + speed * leave >= nearest_allowed(radius, side)) return first;
  const double touch = (side - radius) / -speed;
  if (touch < enter && side + speed * enter <= 0.0) return first;  // it has passed beyond the wall's end
  first = std::min(first, std::max(enter, touch));
  return first;
}

double meet(const Mover& a, const Mover& b, double radius) {
  const double both = std::min(a.until, b.until);
  const Offset relative = a.from - b.from;
  const Offset together = (a.motion - b.motion) * both;
  const double time = meets_disc(relative, together, radius);
  if (time <= 1.0) return time * both;
  const double one = std::max(a.until, b.until) - both;
  if (one <= 0.0) return kNever;
  const Offset alone = (a.until > b.until ? a.motion : b.motion * -1.0) * one;
  const double later = meets_disc(relative + together, alone, radius);
  return later <= 1.0 ? both + later * one : kNever;
}

double meets_edge(Point low, Point high, Point from, Offset motion) {
  double out = kNever;
  const auto meet_one = [&](double speed, double gap) {
    if (speed > 0.0 && gap < speed) out = std::min(out, std::max(0.0, gap) / speed);
  };
  meet_one(motion.x, high.x - from.x);
  meet_one(-motion.x, from.x - low.x);
  meet_one(motion.y, high.y - from.y);
  meet_one(-motion.y, from.y - low.y);
  return out;
}

}  // namespace mlab::binding
