#include "mlab/schema/narrow.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mlab::schema {
namespace {

using geom::Offset;

constexpr double kBackwards = 0.4;  // of the wanted speed
constexpr double kAside = 0.5;      // likewise
constexpr double kMoves = 0.1;      // [m/s]
constexpr double kAhead = 15.0;     // so far ahead somebody counts who comes [m]
constexpr double kWallGap = 0.05;   // [m]

/// As seen along the way.
struct Seen {
  double ahead, right, speed;
};

Seen seen_along(const Neighbour& other, Offset along) {
  const Offset right{along.y, -along.x};
  return {dot(other.place, along), dot(other.place, right), dot(other.velocity, along)};
}

/// Who stands is none who comes: TurnTaker is for him.
bool comes(const Seen& seen, const SideRoom& room) {
  return seen.ahead > 0.0 && seen.ahead < kAhead && seen.speed < -kMoves &&
         std::abs(seen.right) < std::max(seen.ahead, room.left + room.right);
}

}  // namespace

bool SideRoom::is_narrow(double radius, double gap) const {
  return left + right < narrow_reach(radius, gap);
}

SideRoom side_room(Offset along, std::span<const geom::Segment> walls, std::span<const RoundThing> rounds) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  SideRoom out{kNone, kNone};
  const Offset left{-along.y, along.x};
  const auto add = [&](double at) {
    (at > 0.0 ? out.left : out.right) = std::min(at > 0.0 ? out.left : out.right, std::abs(at));
  };
  for (const geom::Segment& wall : walls) {
    const Offset a = wall.a - geom::Point{};
    const Offset b = wall.b - geom::Point{};
    const double from = dot(a, along);
    const double to = dot(b, along);
    if ((from > 0.0) == (to > 0.0)) continue;
    const double share = from / (from - to);
    add(dot(a + (b - a) * share, left));
  }
  for (const RoundThing& one : rounds) {
    const double ahead = dot(one.center, along);
    if (std::abs(ahead) >= one.radius) continue;
    const double aside = dot(one.center, left);
    const double half = std::sqrt(one.radius * one.radius - ahead * ahead);
    add(aside > 0.0 ? std::max(aside - half, 1e-9) : std::min(aside + half, -1e-9));
  }
  return out;
}

WayMade make_way(Offset wanted, double radius, double gap, const SideRoom& room,
                 std::span<const Neighbour> others) {
  constexpr double kOfRoom = 0.6;  // that is left when two pass
  const double speed = length(wanted);
  if (!(speed > 0.0)) return {wanted, gap};
  const Offset along = wanted * (1.0 / speed);
  bool is_met = false;
  bool gives_way = false;
  bool has_one_beside = false;
  double between = gap;
  for (const Neighbour& other : others) {
    const Seen seen = seen_along(other, along);
    const double bodies = radius + other.radius;
    if (comes(seen, room)) {
      is_met = true;
      const double left_over = room.left + room.right - 2.0 * bodies - 4.0 * kWallGap;
      gives_way = gives_way || (left_over < kLeastGap * gap && (other.is_mate || other.goes_first));
      between = std::clamp(kOfRoom * left_over, kLeastGap * gap, between);
    } else if (seen.right > 0.5 * bodies && seen.right < room.right && seen.ahead > -0.25 * bodies &&
               seen.ahead < bodies + gap) {
      has_one_beside = true;
    }
  }
  if (!is_met) return {wanted, gap};
  if (gives_way || has_one_beside) return {along * (-kBackwards * speed), between};
  const Offset right{along.y, -along.x};
  const double aside = room.right - radius - 2.0 * kWallGap;
  return {wanted + right * std::clamp(aside, -kAside * speed, kAside * speed), between};
}

}  // namespace mlab::schema
