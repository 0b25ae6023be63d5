#include "mlab/fleet/known_ground.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "mlab/base/hash.h"
#include "mlab/mission/known_map.h"

namespace mlab::fleet {
namespace {

// The same for the same things in the same order, in every process.
std::uint64_t revision_of(const ways::Ground& ground, ways::Bounds bounds) {
  std::uint64_t out = 1;
  const auto add = [&](double number) {
    out = base::combine_bits(out, std::bit_cast<std::uint64_t>(number));
  };
  for (const auto& [center, radius] : ground.discs) {
    add(center.x);
    add(center.y);
    add(radius);
  }
  out = base::combine_bits(out, ground.discs.size());
  for (const auto& [a, b] : ground.walls) {
    add(a.x);
    add(a.y);
    add(b.x);
    add(b.y);
  }
  add(bounds.x1);
  add(bounds.y1);
  return out == 0 ? 1 : out;
}

}  // namespace

TeamGround::TeamGround(const overlay::Overlay& map)
    : TeamGround(mission::known_things(map), mission::known_bounds(map), mission::known_edges(map),
                 std::nullopt) {
  for (const overlay::ObstacleDisc& one : map.obstacles) {
    if (!one.is_moving()) continue;
    if (const auto all = mission::swept(one)) swaying_.push_back(all->center);
  }
}

TeamGround::TeamGround(ways::Ground ground, ways::Bounds bounds, std::size_t edges,
                       std::optional<std::size_t> mapped)
    : ground_(std::move(ground)),
      bounds_(bounds),
      edges_(edges),
      mapped_(mapped.value_or(ground_.discs.size())),
      revision_(revision_of(ground_, bounds)) {}

std::shared_ptr<const TeamGround> TeamGround::with_discs(std::vector<ways::Round> discs,
                                                         std::size_t mapped) const {
  ways::Ground ground{.discs = std::move(discs), .walls = ground_.walls, .bounds = ground_.bounds};
  std::shared_ptr<TeamGround> out(new TeamGround(std::move(ground), bounds_, edges_, mapped));
  out->swaying_ = swaying_;
  return out;
}

const ways::Clearing& TeamGround::things() const {
  std::call_once(looked_, [this] { things_.emplace(ground_, kSame); });
  return *things_;
}

bool TeamGround::knows(geom::Point place) const {
  return !things().is_free(place);
}

std::shared_ptr<const TeamGround> TeamGround::with(std::span<const ways::Round> sensed) const {
  std::vector<ways::Round> discs;
  for (const ways::Round& one : sensed) {
    if (ground_.discs.size() - mapped_ + discs.size() >= kMostSensed) break;
    const bool is_new = !knows(one.center) && std::ranges::none_of(discs, [&](const ways::Round& other) {
      return distance(other.center, one.center) < other.radius + kSame;
    });
    if (is_new) discs.push_back(one);
  }
  if (discs.empty()) return nullptr;
  discs.insert(discs.begin(), ground_.discs.begin(), ground_.discs.end());
  return with_discs(std::move(discs), mapped_);
}

std::vector<geom::Point> TeamGround::missed(const geom::Pose& pose, double reach,
                                            std::span<const percept::Obstacle> seen) const {
  constexpr double kWithin = 1.0;  // so much nearer than its sensors reach [m]
  std::vector<std::uint32_t> discs;
  std::vector<geom::Point> out;
  if (!(reach >= kWithin) || !std::isfinite(pose.position.x + pose.position.y)) return out;
  things().visit_discs(pose.position, reach, [&](std::uint32_t disc) {
    const auto& [center, radius] = ground_.discs[disc];
    if (radius < kSmallest || distance(pose.position, center) - radius > reach - kWithin) return;
    const geom::Vector there = pose.to_robot(center);
    const auto is_it = [&](const percept::Obstacle& one) { return length(one.center - there) <= kSame; };
    if (std::ranges::none_of(seen, is_it) && std::ranges::find(swaying_, center) == swaying_.end())
      discs.push_back(disc);
  });
  std::ranges::sort(discs);
  for (const std::uint32_t disc : discs) out.push_back(ground_.discs[disc].center);
  return out;
}

std::shared_ptr<const TeamGround> TeamGround::without(std::span<const geom::Point> gone) const {
  std::vector<ways::Round> discs;
  std::size_t mapped = 0;
  for (std::size_t i = 0; i < ground_.discs.size(); ++i) {
    if (std::ranges::find(gone, ground_.discs[i].center) != gone.end()) continue;
    discs.push_back(ground_.discs[i]);
    mapped += i < mapped_ ? 1 : 0;
  }
  if (discs.size() == ground_.discs.size()) return nullptr;
  return with_discs(std::move(discs), mapped);
}

}  // namespace mlab::fleet
