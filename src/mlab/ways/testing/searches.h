#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "mlab/geom/outline.h"
#include "mlab/ways/planner.h"
#include "mlab/ways/testing/grounds.h"

namespace mlab::ways::testing {

/// What a way really sees, told by looking at places close together on a square [0, side]: those that are
/// near enough to some place on it, with no wall in between.
class SeenPlaces {
 public:
  SeenPlaces(std::span<const geom::Point> outline, const Ground& ground, double clearance, double swath,
             double side, double step)
      : ground_(ground),
        clearance_(clearance),
        swath_(swath),
        step_(step),
        count_(static_cast<int>(side / step)) {
    const auto cells = static_cast<std::size_t>(count_) * static_cast<std::size_t>(count_);
    std::vector<int> part(cells, 0);
    is_wanted_.assign(cells, false);
    is_visible_.assign(cells, false);
    is_seen_.assign(cells, false);
    for (std::size_t i = 0; i < cells; ++i) {
      const geom::Point p = place(i);
      const double room = room_at(ground, p);
      is_wanted_[i] = room > 0.0 && geom::is_within(outline, p);
      if (room >= clearance && ground.bounds.contains(p)) part[i] = -1;
    }
    look_from(largest_part(part));
  }

  /// All that is seen from a piece of a way.
  void pass(geom::Segment piece) {
    each_seen(piece, is_seen_, [&](std::size_t i) { is_seen_[i] = true; });
  }
  double free_area() const {
    return static_cast<double>(std::ranges::count(is_wanted_, true)) * step_ * step_;
  }
  double visible_share() const {
    return static_cast<double>(std::ranges::count(is_visible_, true)) /
           static_cast<double>(std::ranges::count(is_wanted_, true));
  }
  /// Of what can be seen.
  double seen_share() const {
    double seen = 0.0;
    double all = 0.0;
    for (std::size_t i = 0; i < is_visible_.size(); ++i) {
      all += is_visible_[i] ? 1.0 : 0.0;
      seen += is_visible_[i] && is_seen_[i] ? 1.0 : 0.0;
    }
    return all > 0.0 ? seen / all : 1.0;
  }

 private:
  geom::Point place(std::size_t i) const {
    const auto columns = static_cast<std::size_t>(count_);
    const std::size_t row = i / columns;
    return {(static_cast<double>(i % columns) + 0.5) * step_, (static_cast<double>(row) + 0.5) * step_};
  }

  template <class Visit>
  void each_near(geom::Segment piece, Visit&& visit) {
    const double reach = 0.5 * swath_;
    const auto low = [&](double at) {
      return std::max(0, static_cast<int>(std::floor((at - reach) / step_ - 0.5)));
    };
    const auto high = [&](double at) {
      return std::min(count_ - 1, static_cast<int>(std::ceil((at + reach) / step_ - 0.5)));
    };
    for (int y = low(std::min(piece.a.y, piece.b.y)); y <= high(std::max(piece.a.y, piece.b.y)); ++y) {
      for (int x = low(std::min(piece.a.x, piece.b.x)); x <= high(std::max(piece.a.x, piece.b.x)); ++x) {
        const auto i =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(count_) + static_cast<std::size_t>(x);
        if (distance(nearest_point(piece, place(i)), place(i)) <= reach) visit(i);
      }
    }
  }

  /// The same without what walls hide, and what is known already.
  template <class Visit>
  void each_seen(geom::Segment piece, const std::vector<bool>& is_known, Visit&& visit) {
    const double reach = 0.5 * swath_;
    std::vector<geom::Segment> walls;
    const geom::Point middle = piece.a + (piece.b - piece.a) * 0.5;
    for (const geom::Segment& wall : ground_.walls) {
      if (distance(nearest_point(wall, middle), middle) <= reach + 0.5 * distance(piece.a, piece.b))
        walls.push_back(wall);
    }
    const auto is_hidden = [&](geom::Point p, geom::Point from) {
      return std::ranges::any_of(walls,
                                 [&](const geom::Segment& wall) { return intersects({p, from}, wall); });
    };
    const int samples = 1 + static_cast<int>(distance(piece.a, piece.b) / (0.05 * swath_));
    each_near(piece, [&](std::size_t i) {
      if (is_known[i]) return;
      const geom::Point p = place(i);
      bool is_seen = !is_hidden(p, nearest_point(piece, p));
      for (int k = 0; k <= samples && !is_seen; ++k) {
        const geom::Point from = piece.a + (piece.b - piece.a) * (1.0 * k / samples);
        is_seen = distance(from, p) <= reach && !is_hidden(p, from);
      }
      if (is_seen) visit(i);
    });
  }

  /// Of the free places that hang together, those with the most places to be seen among them.
  std::vector<bool> largest_part(std::vector<int>& part) const {
    int best = 0;
    std::size_t most = 0;
    int parts = 0;
    for (std::size_t first = 0; first < part.size(); ++first) {
      if (part[first] != -1) continue;
      std::vector<std::size_t> open{first};
      part[first] = ++parts;
      std::size_t wanted = 0;
      while (!open.empty()) {
        const std::size_t at = open.back();
        open.pop_back();
        wanted += is_wanted_[at] ? 1 : 0;
        const auto columns = static_cast<std::size_t>(count_);
        const auto go = [&](bool is_there, std::size_t to) {
          if (!is_there || part[to] != -1) return;
          part[to] = parts;
          open.push_back(to);
        };
        go(at % columns > 0, at - 1);
        go(at % columns + 1 < columns, at + 1);
        go(at >= columns, at - columns);
        go(at + columns < part.size(), at + columns);
      }
      if (wanted > most) best = parts;
      most = std::max(most, wanted);
    }
    std::vector<bool> out(part.size());
    for (std::size_t i = 0; i < part.size(); ++i) out[i] = best != 0 && part[i] == best;
    return out;
  }

  /// From all places where a robot may be, and from those beside them that touch a disc that has grown.
  void look_from(const std::vector<bool>& is_robots) {
    const auto look = [&](geom::Point p) {
      each_seen({p, p}, is_visible_, [&](std::size_t i) {
        if (is_wanted_[i]) is_visible_[i] = true;
      });
    };
    for (std::size_t i = 0; i < is_robots.size(); ++i) {
      if (!is_robots[i]) continue;
      if (is_wanted_[i]) is_visible_[i] = true;
      const auto columns = static_cast<std::size_t>(count_);
      const bool is_rim = (i >= 1 && !is_robots[i - 1]) || (i + 1 < is_robots.size() && !is_robots[i + 1]) ||
                          (i >= columns && !is_robots[i - columns]) ||
                          (i + columns < is_robots.size() && !is_robots[i + columns]);
      if (!is_rim) continue;
      look(place(i));
      for (const Round& disc : ground_.discs) {
        const geom::Offset out = place(i) - disc.center;
        if (length(out) > disc.radius + clearance_ + 1.5 * step_) continue;
        const geom::Point edge = disc.center + unit(out) * (disc.radius + clearance_ + 1e-6);
        if (room_at(ground_, edge) >= clearance_ && ground_.bounds.contains(edge)) look(edge);
      }
    }
  }

  const Ground& ground_;
  double clearance_;
  double swath_;
  double step_;
  int count_;
  std::vector<bool> is_wanted_, is_visible_, is_seen_;
};

}  // namespace mlab::ways::testing
