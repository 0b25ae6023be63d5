#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mlab/overlay/overlay.h"

namespace mlab::overlay {

/// The additive feedback generator that the C library `rand` of GNU systems is, written out so that a seed
/// gives the same obstacles on every machine: x(n) = x(n-3) + x(n-31) modulo 2^32, of which the lowest bit is
/// dropped.
/// @source D. E. Knuth, "The Art of Computer Programming", volume 2, section 3.2.2 (additive number
/// generators)
class AdditiveFeedbackRandom {
 public:
  static constexpr std::int32_t kMax = 0x7fffffff;

  /// A seed of 0 is taken as 1.
  explicit AdditiveFeedbackRandom(std::uint32_t seed);

  /// In 0 .. kMax.
  std::int32_t next();
  /// In [low, high], both ends included.
  double uniform(double low, double high) { return low + static_cast<double>(next()) / kMax * (high - low); }

 private:
  static constexpr std::size_t kLong = 31;
  static constexpr std::size_t kShort = 3;

  std::array<std::uint32_t, kLong> state_{};
  std::size_t at_ = kShort;  // of x(n-31), which the next value replaces
};

/// The seed that a mission's SET SEED means: the number as a 32-bit float, rounded half away from zero.
/// Historic files rely on it: 945816565 becomes 945816576.
std::uint32_t obstacle_seed(double written);

/// How many obstacles of what size: the SET options of CREATE-OBSTACLES.
struct ObstacleField {
  double coverage_percent = 3.0;  ///< of the area, 0..30
  double min_radius = 2.0;        ///< [m], > 0
  double max_radius = 10.0;       ///< [m]; may be below min_radius, then the two change places
};

/// A part of the world with its edges [m].
struct Region {
  geom::Point low;
  geom::Point high;
  bool contains(geom::Point p) const {
    return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y;
  }
};

struct CreatedObstacles {
  std::vector<ObstacleDisc> obstacles;
  bool is_complete = true;  ///< false where the coverage was not reached: no free place found, or too many
};

/// More obstacles than this no field gets.
inline constexpr std::size_t kMaxCreatedObstacles = 100000;
/// So often a place is looked for before giving up.
inline constexpr int kMaxTries = 1000;

/// Fills a region at random with discs that touch neither each other nor what is to be kept clear, until
/// their areas sum up to the coverage. Centres keep 1 m from the low edges and 2 m from the high ones, where
/// there is room.
///
/// @param covered     area of the region that obstacles cover already [m^2]
/// @param keep_clear  obstacles that stand, robots
/// @source  simulator of the historic system: four draws for each try (x, y, radius, height), all four again
/// after
///          a collision; so its seeds give its fields
CreatedObstacles create_obstacles(const Region& region, const ObstacleField& field, std::uint32_t seed,
                                  double covered = 0.0, std::span<const ObstacleDisc> keep_clear = {});
/// CREATE-OBSTACLES: a field for the whole mission area.
CreatedObstacles create_obstacles(Area area, const ObstacleField& field, std::uint32_t seed);

}  // namespace mlab::overlay
