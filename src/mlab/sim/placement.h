#pragma once

#include <array>
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

  /// True where a disc would overlap nothing solid and no body but `except`, and is so far from bodies.
  /// Touching is free.
  bool is_free(const Bodies& bodies, const Statics& statics, geom::Point place, double radius,
               std::uint32_t except = kNone, double apart = 0.0) const;
  /// The wanted place where that is free, else the nearest one, to 2 % of the way there or half a radius:
  /// with room for others to pass between it and bodies, and no wall before it; where there is none, kApart
  /// from them; and where there is no such room, one that may touch them, or lie behind a wall. Always the
  /// same one.
  /// @param area  that the place must be in
  /// @return  nothing where none is free within kFarthestMove
  /// Many calls for one wanted place, each followed by add(), cost little: no ring is looked at in vain
  /// twice.
  std::optional<geom::Point> nearest_free(const Bodies& bodies, const Statics& statics, geom::Point wanted,
                                          double radius, const Box& area, std::uint32_t except = kNone);
  static constexpr double kFarthestMove = 1e4;  ///< [m]
  static constexpr double kApart =
      0.05;  ///< who touches another one can't begin to move without a contact [m]

  static constexpr std::uint32_t kNone = ~0U;  ///< of all bodies

 private:
  static constexpr std::uint32_t kEnd = ~0U;

  /// Bodies that came since have only taken places, so all before `away` are still taken.
  struct Search {
    geom::Point wanted;
    double apart = 0.0;  ///< from bodies [m]
    double radius = -1.0;
    Box area{};
    double away = 0.0;  ///< radius of the ring where a place was found [m]
    bool is_same(const Search& other) const {
      return other.wanted == wanted && other.apart == apart && other.radius == radius &&
             other.area.x0 == area.x0 && other.area.y0 == area.y0 && other.area.x1 == area.x1 &&
             other.area.y1 == area.y1;
    }
  };

  std::optional<geom::Point> nearest_apart(const Bodies& bodies, const Statics& statics, Search& search,
                                           std::uint32_t except) const;

  TorusCells cells_;
  std::vector<std::uint32_t> first_;  ///< by place: the body added last there
  std::vector<std::uint32_t> next_;   ///< by body: the one added before it at the same place
  double widest_ = 0.0;               ///< radius [m]
  std::span<const binding::MovingDisc> moving_;
  std::array<Search, 3> last_;  ///< the last searches: with room to pass, apart, and where it may touch
};

}  // namespace mlab::sim
