#include "mlab/schema/clearance.h"

#include <algorithm>
#include <optional>

namespace mlab::schema {
namespace {

using geom::Offset;
using geom::Point;

constexpr double kClose = 1e-3;  // [m]; nearer than that they meet
constexpr int kMostSteps = 32;
constexpr int kMostTurns = 6;

struct Meeting {
  double share = 1.0;  // of the motion that is free
  Offset towards;      // of length 1, from there
};

// How near a body comes to what is round or straight is a convex function of the way, so that Newton's steps
// never go too far, and who does not come nearer never will.
std::optional<Meeting> meeting(Offset motion, const Bar& bar) {
  double share = 0.0;
  for (int step = 0; step < kMostSteps && share < 1.0; ++step) {
    const Point here = Point{} + motion * share;
    const Offset to = nearest_point(bar.line, here) - here;
    const double room = geom::length(to) - bar.reach;
    const Offset towards = unit(to);
    const double approach = dot(motion, towards);
    if (approach <= kClose * kClose) return std::nullopt;
    if (room <= kClose) return Meeting{share, towards};
    share += room / approach;
  }
  return std::nullopt;
}

// What takes most away of the motion that is not permitted any more.
std::optional<Meeting> first_meeting(Offset motion, std::span<const Bar> bars) {
  std::optional<Meeting> out;
  const auto take = [&](const Meeting& other) {
    if (!out || other.share < out->share) out = other;
  };
  for (const Bar& bar : bars) {
    if (bar.approach < 0.0) {
      if (const auto found = meeting(motion, bar)) take(*found);
      continue;
    }
    const Offset towards = unit(bar.line.a - Point{});
    const double nearer = dot(motion, towards);
    if (nearer > bar.approach + 1e-9) take({bar.approach / nearer, towards});
  }
  return out;
}

}  // namespace

geom::Offset clear_motion(geom::Offset motion, std::span<const Bar> bars) {
  for (int turn = 0; turn < kMostTurns; ++turn) {
    if (motion == Offset{}) return motion;
    const auto found = first_meeting(motion, bars);
    if (!found) return motion;
    motion = motion - found->towards * (dot(motion, found->towards) * (1.0 - found->share));
  }
  const auto left = first_meeting(motion, bars);
  return left ? motion * left->share : motion;
}

}  // namespace mlab::schema
