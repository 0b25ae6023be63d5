#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "mlab/binding/slide.h"
#include "mlab/binding/world_view.h"
#include "mlab/geom/pose.h"

namespace mlab::binding {

/// What may be in the way of a body that somebody looks ahead for, as far as it is known. Motions go through
/// it by the laws of docs/simulator.md: straight until something is met, then along it; all things stand
/// still.
class Passage {
 public:
  /// The corners of a way, the first one where it begins.
  class Way {
   public:
    explicit Way(geom::Point from) { add(from); }
    void add(geom::Point corner) { corners_[count_++] = corner; }
    std::span<const geom::Point> corners() const { return {corners_.data(), count_}; }
    geom::Point end() const { return corners_[count_ - 1]; }

   private:
    std::array<geom::Point, kSlideRounds + 1> corners_;
    std::size_t count_ = 0;
  };

  /// Nothing is in the way.
  void clear();
  void add(const Disc& disc) { discs_.push_back(disc); }
  void add(const geom::Segment& wall) { walls_.push_back(wall); }
  /// The body's centre can't leave this box [m].
  void keep_within(geom::Point low, geom::Point high);

  /// Whether something of it is so near to the place [m].
  bool is_near(geom::Point place, double reach) const;
  /// How a body of this radius [m] goes that would go this step [m] if it were free.
  Way follow(geom::Point from, geom::Offset step, double radius) const;

 private:
  std::vector<Disc> discs_;
  std::vector<geom::Segment> walls_;
  geom::Point low_{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  geom::Point high_{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
};

}  // namespace mlab::binding
