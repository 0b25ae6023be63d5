#include "mlab/overlay/environment_change.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mlab/base/hash.h"

namespace mlab::overlay {
namespace {

// One change, done to the obstacles. False where it could not be done in full.
struct Applier {
  std::uint64_t execution;
  std::uint64_t run_key;  // differs for each change of each event of a run
  std::span<const ObstacleDisc> robots;
  std::vector<ObstacleDisc>& obstacles;
  text::Place place;

  bool operator()(const AddObstacle& add) const {
    obstacles.push_back({add.center, add.radius, 0.0, place});
    return true;
  }

  bool operator()(const RemoveObstacle& remove) const {
    std::erase_if(obstacles, [&](const ObstacleDisc& d) {
      return std::abs(d.center.x - remove.center.x) <= kSamePlace &&
             std::abs(d.center.y - remove.center.y) <= kSamePlace;
    });
    return true;
  }

  bool operator()(const ClearRegion& clear) const {
    std::erase_if(obstacles, [&](const ObstacleDisc& d) { return clear.region.contains(d.center); });
    return true;
  }

  bool operator()(const FillRegion& fill) const {
    double covered = 0.0;
    for (const ObstacleDisc& d : obstacles) {
      if (fill.region.contains(d.center)) covered += std::numbers::pi * d.radius * d.radius;
    }
    std::vector<ObstacleDisc> keep_clear = obstacles;
    keep_clear.insert(keep_clear.end(), robots.begin(), robots.end());
    CreatedObstacles created = create_obstacles(fill.region, fill.field, seed(fill), covered, keep_clear);
    for (ObstacleDisc& disc : created.obstacles) {
      disc.place = place;
      obstacles.push_back(std::move(disc));
    }
    return created.is_complete;
  }

  std::uint32_t seed(const FillRegion& fill) const {
    if (fill.seed) return obstacle_seed(*fill.seed + static_cast<double>(execution) * fill.seed_increment);
    return static_cast<std::uint32_t>(base::combine_bits(run_key, execution));
  }
};

}  // namespace

std::uint64_t executions(const EnvironmentEvent& event, double time) {
  // A millionth of a second of grace: cycles of 0.1 s do not sum up exactly.
  constexpr double kGrace = 1e-6;
  const double since = time + kGrace - event.start;
  if (!(since >= 0.0)) return 0;
  if (!(event.period > 0.0)) return 1;
  return 1 + static_cast<std::uint64_t>(std::min(since / event.period, 0x1p62));
}

bool apply(const EnvironmentEvent& event, std::uint64_t execution, std::uint64_t run_seed,
           std::span<const ObstacleDisc> robots, std::vector<ObstacleDisc>& obstacles) {
  bool is_complete = true;
  std::uint64_t number = event.place.span.begin;  // tells events of the same file apart
  for (const EnvironmentChange& change : event.changes) {
    const Applier applier{execution, base::combine_bits(run_seed, ++number), robots, obstacles, event.place};
    is_complete = std::visit(applier, change) && is_complete;
  }
  return is_complete;
}

}  // namespace mlab::overlay
