#include "mlab/overlay/random_obstacles.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <unordered_map>

namespace mlab::overlay {

AdditiveFeedbackRandom::AdditiveFeedbackRandom(std::uint32_t seed) {
  // Lehmer's generator fills the state: 16807 x modulo 2^31 - 1, on signed numbers.
  constexpr std::int64_t kModulus = 2147483647;
  std::int64_t x = seed == 0 ? 1 : static_cast<std::int32_t>(seed);
  for (std::uint32_t& value : state_) {
    value = static_cast<std::uint32_t>(x);
    x = 16807 * x % kModulus;
    if (x < 0) x += kModulus;
  }
  // Ten rounds are thrown away, so that neighbouring seeds lose their likeness.
  for (std::size_t i = 0; i < 10 * kLong; ++i) static_cast<void>(next());
}

std::int32_t AdditiveFeedbackRandom::next() {
  const std::size_t recent = (at_ + kLong - kShort) % kLong;
  const std::uint32_t sum = state_[at_] += state_[recent];
  at_ = (at_ + 1) % kLong;
  return static_cast<std::int32_t>(sum >> 1);
}

std::uint32_t obstacle_seed(double written) {
  const double rounded = std::round(static_cast<double>(static_cast<float>(written)));
  if (!(std::abs(rounded) < 0x1p62)) return 1;
  return static_cast<std::uint32_t>(static_cast<std::int64_t>(rounded));
}

namespace {

// Finds discs that overlap, among many: the plane in squares as wide as the largest disc, so that only
// neighbouring squares matter.
class DiscGrid {
 public:
  explicit DiscGrid(double largest_radius) : width_(2.0 * largest_radius) {}

  void add(const ObstacleDisc& disc) {
    squares_[square(disc.center, 0, 0)].push_back({disc.center, disc.radius});
  }

  bool touches(geom::Point center, double radius) const {
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        const auto found = squares_.find(square(center, dx, dy));
        if (found == squares_.end()) continue;
        const auto near = [&](const Disc& d) { return geom::distance(d.center, center) < d.radius + radius; };
        if (std::ranges::any_of(found->second, near)) return true;
      }
    }
    return false;
  }

 private:
  struct Disc {
    geom::Point center;
    double radius;
  };

  std::uint64_t square(geom::Point p, int dx, int dy) const {
    const auto index = [&](double v, int d) {
      const double i = std::clamp(std::floor(v / width_), -1e9, 1e9);
      return static_cast<std::uint64_t>(static_cast<std::uint32_t>(static_cast<std::int32_t>(i) + d));
    };
    return index(p.x, dx) << 32 | index(p.y, dy);
  }

  double width_;
  std::unordered_map<std::uint64_t, std::vector<Disc>> squares_;
};

double largest(std::span<const ObstacleDisc> discs, double at_least) {
  for (const ObstacleDisc& d : discs) at_least = std::max(at_least, d.radius);
  return at_least;
}

// Where centres may lie along one axis.
struct Range {
  double low;
  double high;
};
Range with_margins(double low, double high) {
  constexpr double kLowMargin = 1.0;
  constexpr double kHighMargin = 2.0;
  return high - low > kLowMargin + kHighMargin ? Range{low + kLowMargin, high - kHighMargin}
                                               : Range{low, high};
}

std::optional<ObstacleDisc> find_free_place(Range x, Range y, const ObstacleField& field,
                                            AdditiveFeedbackRandom& random, const DiscGrid& taken) {
  for (int i = 0; i < kMaxTries; ++i) {
    ObstacleDisc disc;
    disc.center.x = random.uniform(x.low, x.high);
    disc.center.y = random.uniform(y.low, y.high);
    disc.radius = random.uniform(field.min_radius, field.max_radius);
    disc.height = random.uniform(1.0, 10.0);
    if (!taken.touches(disc.center, disc.radius)) return disc;
  }
  return std::nullopt;
}

}  // namespace

CreatedObstacles create_obstacles(const Region& region, const ObstacleField& field, std::uint32_t seed,
                                  double covered, std::span<const ObstacleDisc> keep_clear) {
  CreatedObstacles out;
  const double wanted =
      field.coverage_percent / 100.0 * (region.high.x - region.low.x) * (region.high.y - region.low.y);
  const double largest_radius = largest(keep_clear, std::max(field.min_radius, field.max_radius));
  if (!(largest_radius > 0.0) || !std::isfinite(wanted) || !std::isfinite(largest_radius)) return out;
  DiscGrid taken(largest_radius);
  for (const ObstacleDisc& disc : keep_clear) taken.add(disc);
  AdditiveFeedbackRandom random(seed);
  const Range x = with_margins(region.low.x, region.high.x);
  const Range y = with_margins(region.low.y, region.high.y);
  while (covered < wanted) {
    const auto disc = out.obstacles.size() < kMaxCreatedObstacles
                          ? find_free_place(x, y, field, random, taken)
                          : std::nullopt;
    if (!disc) {
      out.is_complete = false;
      break;
    }
    taken.add(*disc);
    out.obstacles.push_back(*disc);
    covered += std::numbers::pi * disc->radius * disc->radius;
  }
  return out;
}

CreatedObstacles create_obstacles(Area area, const ObstacleField& field, std::uint32_t seed) {
  return create_obstacles(Region{{0.0, 0.0}, {area.width, area.height}}, field, seed);
}

}  // namespace mlab::overlay
