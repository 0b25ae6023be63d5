#include "mlab/schema/swept.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "mlab/base/angle.h"

namespace mlab::schema {
namespace {

using geom::Point;
using percept::KnownGround;

constexpr double kLaneTolerance = 0.15;  // a robot may be so far beside its lane [m]
constexpr double kShareOfSwath = 0.05;   // but no more than so much of the swath
constexpr double kBetween = 0.25;        // from place to place along a lane, of the reach
constexpr double kTrailTolerance = 0.02;

bool is_hidden(const KnownGround& ground, Point place, Point from) {
  return std::ranges::any_of(ground.walls,
                             [&](const geom::Segment& wall) { return intersects({place, from}, wall); });
}

bool is_on_ground(const KnownGround& ground, Point place) {
  return ground.bounds.contains(place) && std::ranges::none_of(ground.discs, [&](const ways::Round& disc) {
           return distance(disc.center, place) <= disc.radius;
         });
}

// Whether near to a place on a lane something stands nearer to the lane than that was planned to keep: nobody
// knew of it then. A leg that begins and ends just beside a thing was planned round it.
bool is_obstructed(const KnownGround& ground, geom::Segment lane, Point on_lane, double margin,
                   double reach) {
  constexpr double kBeside = 0.75;  // body and rounding [m]
  return std::ranges::any_of(ground.discs, [&](const ways::Round& disc) {
    const double kept = disc.radius + margin;
    const auto is_beside = [&](Point end) { return distance(end, disc.center) < kept + kBeside; };
    return distance(on_lane, disc.center) < kept + 2.0 * reach &&
           distance(nearest_point(lane, disc.center), disc.center) < kept &&
           !(is_beside(lane.a) && is_beside(lane.b));
  });
}

bool sees(const KnownGround& ground, geom::Segment from, Point place, double reach) {
  const Point nearest = nearest_point(from, place);
  return distance(nearest, place) <= reach && !is_hidden(ground, place, nearest);
}

}  // namespace

bool is_covered(const KnownGround& ground, geom::Segment leg, double reach) {
  return std::ranges::any_of(ground.discs, [&](const ways::Round& disc) {
    const double deep = disc.radius - reach;
    return deep > 0.0 && distance(leg.a, disc.center) < deep && distance(leg.b, disc.center) < deep;
  });
}

bool is_covered(const KnownGround& ground, std::span<const Point> way, double reach) {
  for (std::size_t i = 0; i < way.size(); ++i) {
    if (!is_covered(ground, geom::Segment{way[i == 0 ? 0 : i - 1], way[i]}, reach)) return false;
  }
  return true;
}

void Trail::go_to(Point here, double tolerance) {
  if (count_ == 0) {
    corners_[0] = last_ = here;
    count_ = 1;
  }
  const Point from = corners_[count_ - 1];
  const double length = distance(from, here);
  if (length < tolerance) {
    last_ = here;
    return;
  }
  const double angle = geom::direction(here - from);
  const double half = std::asin(std::min(1.0, tolerance / length));
  if (is_open_) direction_ = angle;
  const double off = base::wrap_angle(angle - direction_);
  if (is_open_ || (off >= right_ && off <= left_ && length >= farthest_ - tolerance)) {
    right_ = is_open_ ? off - half : std::max(right_, off - half);
    left_ = is_open_ ? off + half : std::min(left_, off + half);
    farthest_ = is_open_ ? length : std::max(farthest_, length);
    is_open_ = false;
    last_ = here;
    return;
  }
  if (count_ == kMostCorners) {
    std::ranges::copy(std::span(corners_).subspan(1), corners_.begin());
    --count_;
  }
  corners_[count_++] = last_;
  is_open_ = true;
  go_to(here, tolerance);
}

void Swept::begin() {
  count_ = 0;
  leg_ = 1;
  along_ = 0.0;
}

bool Swept::has_seen(const KnownGround& ground, Point place, double reach) const {
  for (std::size_t back = 0; back < trail_.pieces(); ++back) {
    if (sees(ground, trail_.piece(back), place, reach)) return true;
  }
  return false;
}

void Swept::look(const KnownGround& ground, Point here, double reach) {
  trail_.go_to(here, kTrailTolerance * reach);
  const auto end = std::remove_if(missed_.begin(), missed_.begin() + static_cast<std::ptrdiff_t>(count_),
                                  [&](Point place) { return sees(ground, {here, here}, place, reach); });
  count_ = static_cast<std::size_t>(end - missed_.begin());
}

bool Swept::pass(const KnownGround& ground, std::span<const Point> way, std::size_t leg, double along,
                 double margin, double reach) {
  constexpr int kMostAtOnce = 16;
  for (int looked = 0; leg_ < way.size() && leg_ <= leg; ++looked) {
    const geom::Segment lane{way[leg_ - 1], way[leg_]};
    if (leg_ == leg && along_ > along) break;
    if (along_ > distance(lane.a, lane.b)) {
      ++leg_;
      along_ = 0.0;
      continue;
    }
    if (looked == kMostAtOnce || is_nearly_full()) return false;
    add_missed(ground, lane, along_, margin, reach);
    along_ += kBetween * reach;
  }
  return true;
}

void Swept::add_missed(const KnownGround& ground, geom::Segment leg, double along, double margin,
                       double reach) {
  const double swath = 2.0 * reach;
  const double sure = reach - 1.5 * std::min(kLaneTolerance, kShareOfSwath * swath) - kTrailTolerance * reach;
  const geom::Offset ahead = unit(leg.b - leg.a);
  const Point on_lane = leg.a + ahead * along;
  std::optional<bool> counts;  // most lanes are kept, and nobody asks
  for (int i = -kAcross; i <= kAcross; ++i) {
    const Point place = on_lane + geom::Offset{-ahead.y, ahead.x} * (sure * i / kAcross);
    const bool is_missed =
        !has_seen(ground, place, reach) && is_on_ground(ground, place) && !is_hidden(ground, place, on_lane);
    if (is_missed && !counts) counts = is_obstructed(ground, leg, on_lane, margin, reach);
    if (is_missed && *counts && count_ < kMostMissed) missed_[count_++] = place;
  }
}

bool Swept::misses(Point place) const {
  return std::ranges::find(missed(), place) != missed().end();
}

void Swept::give_up(Point place, double within) {
  const auto end = std::remove_if(missed_.begin(), missed_.begin() + static_cast<std::ptrdiff_t>(count_),
                                  [&](Point one) { return distance(one, place) <= within; });
  count_ = static_cast<std::size_t>(end - missed_.begin());
}

}  // namespace mlab::schema
