#include "mlab/sim/placement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace mlab::sim {
namespace {

using geom::Point;

/// Rounding that a place may lack [m].
constexpr double kTolerance = 1e-9;
constexpr double kLeastStep = 0.05;
constexpr double kRelativeStep = 0.02;
constexpr double kBeside = 0.2;           // that one keeps from who stands, if need be [m]
constexpr double kFarthestApart = 200.0;  // farther away nobody looks for room [m]

}  // namespace

void Placer::rebuild(const Bodies& bodies) {
  widest_ = 0.0;
  last_.fill({});
  for (const double radius : bodies.radius) widest_ = std::max(widest_, radius);
  cells_.resize(2 * bodies.count() + 64, std::max(0.5, 2.0 * widest_));
  first_.assign(cells_.size(), kEnd);
  next_.clear();
  for (std::uint32_t body = 0; body < bodies.count(); ++body) add(bodies, body);
}

void Placer::add(const Bodies& bodies, std::uint32_t body) {
  if (body >= cells_.size()) {
    rebuild(bodies);
    return;
  }
  next_.resize(std::max<std::size_t>(next_.size(), body + 1), kEnd);
  if (!bodies.present[body]) return;
  widest_ = std::max(widest_, bodies.radius[body]);
  const std::uint32_t place = cells_.place(bodies.x[body], bodies.y[body]);
  next_[body] = first_[place];
  first_[place] = body;
}

bool Placer::is_free(const Bodies& bodies, const Statics& statics, Point place, double radius,
                     std::uint32_t except, double apart) const {
  bool is_free = true;
  cells_.for_each_run(
      Box::around(place.x, place.y, radius + widest_ + apart), [&](std::uint32_t first, std::uint32_t last) {
        for (std::uint32_t cell = first; cell <= last; ++cell) {
          for (std::uint32_t body = first_[cell]; body != kEnd; body = next_[body]) {
            is_free = is_free && (body == except || distance(bodies.position(body), place) >=
                                                        radius + bodies.radius[body] + apart - kTolerance);
          }
        }
      });
  if (!is_free) return false;
  const Box box = Box::around(place.x, place.y, radius);
  statics.visit_discs(box, [&](std::uint32_t, const Disc& disc) {
    is_free = is_free && distance(disc.center, place) >= radius + disc.radius - kTolerance;
  });
  for (const binding::MovingDisc& disc : moving_)
    is_free = is_free && distance(disc.center, place) >= radius + disc.radius - kTolerance;
  statics.visit_walls(box, [&](std::uint32_t, const Wall& wall) {
    const double gap = distance(nearest_point(wall.segment, place), place) - radius;
    is_free = is_free && gap >= -kTolerance && gap + radius > 0.0;
  });
  return is_free;
}

std::optional<Point> Placer::nearest_free(const Bodies& bodies, const Statics& statics, Point wanted,
                                          double radius, const Box& area, std::uint32_t except) {
  const bool is_within =
      wanted.x >= area.x0 && wanted.x <= area.x1 && wanted.y >= area.y0 && wanted.y <= area.y1;
  if (is_within && is_free(bodies, statics, wanted, radius, except)) return wanted;
  // Two bodies that stand so far from each other let one like them pass that keeps its distance.
  const double room_to_pass = 2.0 * radius + 2.0 * kBeside;
  const std::array<double, 3> rooms{room_to_pass, kApart, 0.0};
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    Search search{wanted, rooms[i], radius, area, std::max(kLeastStep, radius / 2)};
    if (except == kNone && last_[i].is_same(search)) search.away = last_[i].away;
    const auto out = nearest_apart(bodies, statics, search, except);
    if (except == kNone) last_[i] = search;
    if (out) return out;
  }
  return std::nullopt;
}

std::optional<Point> Placer::nearest_apart(const Bodies& bodies, const Statics& statics, Search& search,
                                           std::uint32_t except) const {
  const bool is_in_sight = search.apart > 0.0 && statics.in_sight(search.wanted, search.wanted);
  const auto is_good = [&](Point p) {
    return p.x >= search.area.x0 && p.x <= search.area.x1 && p.y >= search.area.y0 && p.y <= search.area.y1 &&
           is_free(bodies, statics, p, search.radius, except, search.apart) &&
           (!is_in_sight || statics.in_sight(search.wanted, p));
  };
  const double farthest = search.apart > 0.0 ? kFarthestApart : kFarthestMove;
  const double least = std::max(kLeastStep, search.radius / 2);
  for (double& away = search.away; away <= farthest;) {
    const double step = std::max(least, kRelativeStep * away);
    const int count = std::max(8, static_cast<int>(std::ceil(2.0 * std::numbers::pi * away / step)));
    for (int i = 0; i < count; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / count;
      const Point p = search.wanted + geom::Offset{away * std::cos(angle), away * std::sin(angle)};
      if (is_good(p)) return p;
    }
    away += step;
  }
  return std::nullopt;
}

}  // namespace mlab::sim
