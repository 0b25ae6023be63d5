#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mlab/sim/bodies.h"
#include "mlab/sim/point_grid.h"
#include "mlab/sim/statics.h"

namespace mlab::sim {

/// Tells free places from taken ones while bodies are added one by one.
class Placer {
 public:
  /// Forgets everything and takes in all bodies that are present. Wanted after bodies or solid things moved
  /// or went.
  void rebuild(const Bodies& bodies);
  void add(const Bodies& bodies, std::uint32_t body);
  /// Discs that move count, too, from now on, where they are now.
  void keep_free_of(std::span<const binding::MovingDisc> discs) { moving_ = discs; }

  /// True where a disc would overlap nothing solid and no body but `except`. Touching is free.
  bool is_free(const Bodies& bodies, const Statics& statics, geom::Point place, double radius,
               std::uint32_t except = kNone) const;
  /// The free place nearest to the wanted one, to 2 % of the way there or half a radius; always the same one.
  /// @param area  that the place must be in
  /// @return  nothing where none is free within kFarthestMove
  /// Many calls for one wanted place, each followed by add(), cost little: no ring is looked at in vain
  /// twice.
  std::optional<geom::Point> nearest_free(const Bodies& bodies, const Statics& statics, geom::Point wanted,
                                          double radius, const Box& area, std::uint32_t except = kNone);
  static constexpr double kFarthestMove = 1e4;  ///< [m]

  static constexpr std::uint32_t kNone = ~0U;  ///< of all bodies

 private:
  static constexpr std::uint32_t kEnd = ~0U;

  /// The last search. Bodies that came since have only taken places, so all before `away` are still taken.
  struct Search {
    geom::Point wanted;
    double radius = -1.0;
    Box area{};
    double away = 0.0;  ///< radius of the ring where a place was found [m]
    bool is_same(geom::Point place, double r, const Box& box) const {
      return place == wanted && r == radius && box.x0 == area.x0 && box.y0 == area.y0 && box.x1 == area.x1 &&
             box.y1 == area.y1;
    }
  };

  TorusCells cells_;
  std::vector<std::uint32_t> first_;  ///< by place: the body added last there
  std::vector<std::uint32_t> next_;   ///< by body: the one added before it at the same place
  double widest_ = 0.0;               ///< radius [m]
  std::span<const binding::MovingDisc> moving_;
  Search last_;
};

}  // namespace mlab::sim
