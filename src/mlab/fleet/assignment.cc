#include "mlab/fleet/assignment.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>

#include "mlab/percept/formation.h"

namespace mlab::fleet {
namespace {

using Assignment = std::vector<std::uint32_t>;

double all_ways(std::span<const geom::Point> robots, std::span<const geom::Point> stations,
                const Assignment& taken) {
  double out = 0.0;
  for (std::size_t i = 0; i < robots.size(); ++i) out += distance(robots[i], stations[taken[i]]);
  return out;
}

// Robot after robot is taken in, along the path of exchanges that costs least.
class Hungarian {
 public:
  Hungarian(std::span<const geom::Point> robots, std::span<const geom::Point> stations)
      : robots_(robots),
        stations_(stations),
        of_robot_(robots.size() + 1),
        of_station_(robots.size() + 1),
        taker_(robots.size() + 1) {}

  Assignment run() {
    for (std::size_t robot = 1; robot <= robots_.size(); ++robot) take_in(robot);
    Assignment out(robots_.size());
    for (std::size_t station = 1; station <= robots_.size(); ++station)
      out[taker_[station] - 1] = static_cast<std::uint32_t>(station - 1);
    return out;
  }

 private:
  // Robots and stations count from 1; 0 stands for none.
  void take_in(std::size_t robot) {
    const std::size_t count = robots_.size();
    std::vector<double> least(count + 1, std::numeric_limits<double>::infinity());
    std::vector<std::size_t> before(count + 1);
    std::vector<bool> is_seen(count + 1);
    taker_[0] = robot;
    std::size_t at = 0;
    do {
      is_seen[at] = true;
      double step = std::numeric_limits<double>::infinity();
      std::size_t next = 0;
      for (std::size_t station = 1; station <= count; ++station) {
        if (is_seen[station]) continue;
        const double cost = distance(robots_[taker_[at] - 1], stations_[station - 1]) -
                            of_robot_[taker_[at]] - of_station_[station];
        if (cost < least[station]) {
          least[station] = cost;
          before[station] = at;
        }
        if (least[station] < step) {
          step = least[station];
          next = station;
        }
      }
      for (std::size_t station = 0; station <= count; ++station) {
        if (is_seen[station]) {
          of_robot_[taker_[station]] += step;
          of_station_[station] -= step;
        } else {
          least[station] -= step;
        }
      }
      at = next;
    } while (taker_[at] != 0);
    for (; at != 0; at = before[at]) taker_[at] = taker_[before[at]];
  }

  std::span<const geom::Point> robots_;
  std::span<const geom::Point> stations_;
  std::vector<double> of_robot_;
  std::vector<double> of_station_;
  std::vector<std::size_t> taker_;  // of each station
};

// Robots and stations from left to right; then whoever gains exchanges with one nearby.
Assignment assign_many(std::span<const geom::Point> robots, std::span<const geom::Point> stations) {
  const auto in_order = [](std::span<const geom::Point> points) {
    Assignment out(points.size());
    std::iota(out.begin(), out.end(), 0U);
    std::ranges::stable_sort(out, {}, [&](std::uint32_t i) { return std::pair(points[i].x, points[i].y); });
    return out;
  };
  const Assignment by_robot = in_order(robots);
  const Assignment by_station = in_order(stations);
  Assignment out(robots.size());
  for (std::size_t i = 0; i < robots.size(); ++i) out[by_robot[i]] = by_station[i];
  constexpr std::size_t kNear = 32;
  constexpr int kMostPasses = 20;
  bool has_gained = true;
  for (int pass = 0; pass < kMostPasses && has_gained; ++pass) {
    has_gained = false;
    for (std::size_t i = 0; i < robots.size(); ++i) {
      for (std::size_t j = i + 1; j < std::min(robots.size(), i + kNear); ++j) {
        const std::uint32_t a = by_robot[i];
        const std::uint32_t b = by_robot[j];
        const double now = distance(robots[a], stations[out[a]]) + distance(robots[b], stations[out[b]]);
        const double then = distance(robots[a], stations[out[b]]) + distance(robots[b], stations[out[a]]);
        if (then >= now - 1e-9) continue;
        std::swap(out[a], out[b]);
        has_gained = true;
      }
    }
  }
  return out;
}

}  // namespace

std::vector<std::uint32_t> assign_stations(std::span<const geom::Point> robots,
                                           std::span<const geom::Point> stations) {
  Assignment own(robots.size());
  std::iota(own.begin(), own.end(), 0U);
  Assignment best =
      robots.size() <= kMostExact ? Hungarian(robots, stations).run() : assign_many(robots, stations);
  constexpr double kGain = 1e-6;  // [m]
  return all_ways(robots, stations, best) < all_ways(robots, stations, own) - kGain ? best : own;
}

void assign_ranks(Group& group, const std::vector<geom::Pose>& poses) {
  using percept::Formation;
  const std::size_t count = group.members.size();
  const bool is_centred = group.reference == percept::FormationReference::kUnitCenter;
  const Formation formation = group.order.formation;
  if (!group.assigns_stations || count < 2 || formation == Formation::kNone || formation == Formation::kSweep)
    return;
  const std::size_t first = is_centred ? 0 : 1;
  std::vector<geom::Point> robots;
  geom::Offset sum;
  for (const std::uint32_t member : group.members) {
    robots.push_back(poses[member].position);
    sum = sum + (robots.back() - geom::Point{});
  }
  const geom::Point center = geom::Point{} + sum * (1.0 / static_cast<double>(count));
  const geom::Offset to_goal = group.order.goal - center;
  double heading = group.formation_heading;
  if (group.order.has_heading)
    heading = group.order.heading;
  else if (group.order.route.size() > 1)
    heading = geom::direction(group.order.route[1] - group.order.route[0]);
  else if (geom::length(to_goal) >= group.heading_trigger)
    heading = geom::direction(to_goal);
  const auto station_of = [&](std::size_t rank) {
    return percept::station(formation, static_cast<int>(rank), static_cast<int>(count), group.spacing);
  };
  const geom::Pose origin{is_centred ? center : robots.front(), heading};
  const geom::Vector of_origin = is_centred ? geom::Vector{} : station_of(0);
  std::vector<geom::Point> stations;
  for (std::size_t rank = 0; rank < count; ++rank)
    stations.push_back(origin.point_at(station_of(rank) - of_origin));
  const Assignment taken =
      assign_stations(std::span(robots).subspan(first), std::span(stations).subspan(first));
  const std::vector<std::uint32_t> before = group.members;
  for (std::size_t i = 0; i < taken.size(); ++i) group.members[first + taken[i]] = before[first + i];
}

}  // namespace mlab::fleet
