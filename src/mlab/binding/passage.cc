#include "mlab/binding/passage.h"

#include <algorithm>
#include <limits>

#include "mlab/binding/sweep.h"

namespace mlab::binding {
namespace {

using geom::Offset;
using geom::Point;

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

}  // namespace

void Passage::clear() {
  discs_.clear();
  walls_.clear();
  low_ = {-kUnbounded, -kUnbounded};
  high_ = {kUnbounded, kUnbounded};
}

void Passage::keep_within(Point low, Point high) {
  low_ = low;
  high_ = high;
}

bool Passage::is_near(Point place, double reach) const {
  const bool is_at_edge = place.x - low_.x < reach || high_.x - place.x < reach || place.y - low_.y < reach ||
                          high_.y - place.y < reach;
  return is_at_edge ||
         std::ranges::any_of(
             discs_,
             [&](const Disc& one) { return geom::distance(one.center, place) < reach + one.radius; }) ||
         std::ranges::any_of(walls_, [&](const geom::Segment& one) {
           return geom::distance(nearest_point(one, place), place) < reach;
         });
}

Passage::Way Passage::follow(Point from, Offset step, double radius) const {
  Way out(from);
  for (int round = 0; round < kSlideRounds && length(step) > kLeastRest; ++round) {
    Blockers blockers;
    for (const Disc& disc : discs_) blockers.keep_off(from, disc.center, radius + disc.radius, 0.0, 0);
    for (const geom::Segment& wall : walls_)
      blockers.keep_off(from, nearest_point(wall, from), radius, 0.0, 0);
    blockers.keep_within(low_, high_, from, length(step), 0);
    const Offset motion = slide(step, blockers);
    double until = std::min(1.0, meets_edge(low_, high_, from, motion));
    for (const Disc& disc : discs_)
      until = std::min(until, meets_disc(from - disc.center, motion, disc.radius + radius + kSkin));
    for (const geom::Segment& wall : walls_)
      until = std::min(until, meets_wall(wall, from, motion, radius + kSkin));
    from = from + motion * until;
    from = {std::clamp(from.x, low_.x, high_.x), std::clamp(from.y, low_.y, high_.y)};
    out.add(from);
    if (until >= 1.0) break;
    step = step * (1.0 - until);
  }
  return out;
}

}  // namespace mlab::binding
