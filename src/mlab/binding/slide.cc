#include "mlab/binding/slide.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "mlab/binding/sweep.h"

namespace mlab::binding {
namespace {

using geom::Offset;
using geom::Point;

bool is_allowed(Offset motion, const Blockers& blockers, double tolerance) {
  return std::all_of(blockers.begin(), blockers.end(),
                     [&](const Blocker& b) { return dot(motion, b.toward) <= b.gap + tolerance; });
}

/// Keeps the allowed motion that is nearest to the wanted one.
struct Nearest {
  Offset wanted;
  const Blockers& blockers;
  double tolerance;
  Offset best;
  double best_distance = HUGE_VAL;

  void consider(Offset motion) {
    const double distance = length(motion - wanted);
    if (distance < best_distance && is_allowed(motion, blockers, tolerance)) {
      best = motion;
      best_distance = distance;
    }
  }
};

std::optional<Offset> nearest_allowed(Offset wanted, const Blockers& blockers) {
  const double tolerance = 1e-12 + 4e-15 * length(wanted);
  if (is_allowed(wanted, blockers, tolerance)) return wanted;
  Nearest nearest{wanted, blockers, tolerance, {}};
  for (const Blocker& b : blockers) {
    const double excess = dot(wanted, b.toward) - b.gap;
    if (excess > 0.0) nearest.consider(wanted - b.toward * excess);
  }
  if (nearest.best_distance < HUGE_VAL) return nearest.best;
  for (const Blocker* a = blockers.begin(); a != blockers.end(); ++a) {
    for (const Blocker* b = a + 1; b != blockers.end(); ++b) {
      const double area = cross(a->toward, b->toward);
      if (std::abs(area) < 1e-9) continue;
      nearest.consider({(a->gap * b->toward.y - b->gap * a->toward.y) / area,
                        (b->gap * a->toward.x - a->gap * b->toward.x) / area});
    }
  }
  if (nearest.best_distance < HUGE_VAL) return nearest.best;
  return std::nullopt;
}

}  // namespace

void Blockers::add(const Blocker& blocker) {
  const auto is_nearer = [](const Blocker& a, const Blocker& b) {
    return a.gap != b.gap ? a.gap < b.gap : a.thing < b.thing;
  };
  Blocker moving = blocker;
  for (std::size_t i = 0; i < count_; ++i) {
    if (list_[i].gap == blocker.gap && list_[i].toward == blocker.toward) return;
  }
  for (std::size_t i = 0; i < count_; ++i) {
    if (is_nearer(moving, list_[i])) std::swap(moving, list_[i]);
  }
  if (count_ < kMost) list_[count_++] = moving;
}

void Blockers::keep_off(Point body, Point nearest, double radius, double going_away, std::uint32_t thing) {
  const Offset toward = nearest - body;
  const double distance = length(toward);
  const double gap = distance - radius - kSkin;
  if (gap > kTouch || distance <= 0.0) return;
  add({toward * (1.0 / distance), gap + going_away, thing});
}

void Blockers::keep_within(Point low, Point high, Point body, double way, std::uint32_t thing) {
  const auto keep = [&](Offset toward, double gap) {
    if (gap < way) add({toward, std::max(0.0, gap), thing});
  };
  keep({1, 0}, high.x - body.x);
  keep({-1, 0}, body.x - low.x);
  keep({0, 1}, high.y - body.y);
  keep({0, -1}, body.y - low.y);
}

Blockers Blockers::without_backing_off() const {
  Blockers relaxed = *this;
  for (std::size_t i = 0; i < count_; ++i) relaxed.list_[i].gap = std::max(0.0, list_[i].gap);
  return relaxed;
}

Offset slide(Offset wanted, const Blockers& blockers) {
  const std::optional<Offset> slid = nearest_allowed(wanted, blockers);
  return slid ? *slid : nearest_allowed(wanted, blockers.without_backing_off()).value_or(Offset{});
}

}  // namespace mlab::binding
