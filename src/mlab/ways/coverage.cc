#include "mlab/ways/coverage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "mlab/ways/search_route.h"

namespace mlab::ways {
namespace {

// What is told by cells is a little more or less; so somewhat more is seen than is wanted.
constexpr double kUnseen = 0.6 * (1.0 - Coverage::kWanted);

// A share of the area that may be out of sight at a wider clearance, and seen at the least one.
constexpr double kLost = 0.0005;

// About five seconds: a square of 1,000 m with 10 % of obstacles takes half of it at a swath of 10 m.
constexpr std::uint64_t kMostEffort = 250'000'000;
// A tenth of a second.
constexpr std::uint64_t kMostOutlookEffort = 1'000'000;

bool is_finite(geom::Point p) {
  return std::isfinite(p.x) && std::isfinite(p.y);
}

bool is_usable(std::span<const geom::Point> outline, const Ground& ground, const Clearances& clearances,
               double swath) {
  const auto is_disc = [](const Round& disc) {
    return is_finite(disc.center) && std::isfinite(disc.radius) && disc.radius >= 0.0;
  };
  const auto is_wall = [](const geom::Segment& wall) { return is_finite(wall.a) && is_finite(wall.b); };
  const auto is_clearance = [](double one) { return std::isfinite(one) && one >= 0.0; };
  return std::ranges::all_of(clearances.all(), is_clearance) && std::isfinite(swath) && swath > 0.0 &&
         std::ranges::all_of(outline, is_finite) && std::ranges::all_of(ground.discs, is_disc) &&
         std::ranges::all_of(ground.walls, is_wall);
}

/// What is cheap first, and of what is dear no more than must be.
void improve(SearchRoute& route, std::size_t most_unseen) {
  route.shorten(0.05, SIZE_MAX);
  route.complete(most_unseen / 2);
  for (const double price : {0.05, 0.2}) route.shorten(price, most_unseen);
}

using Opaque = std::optional<std::vector<geom::Segment>>;

/// What is to be searched, and by whom: as coverage_route takes it.
struct Task {
  std::span<const geom::Point> outline;
  const Ground& ground;
  double swath;
  std::optional<geom::Point> from;
  std::span<const geom::Segment> opaque;
};

/// Four times as far as its farthest corners are apart: who sees so wide sees all of it from anywhere in it.
double widest_swath(std::span<const geom::Point> outline) {
  double extent = 0.0;
  for (const geom::Point a : outline) {
    for (const geom::Point b : outline) extent = std::max(extent, geom::distance(a, b));
  }
  constexpr double kLeast = 1.0;  // [m]
  return std::max(4.0 * extent, kLeast);
}

bool has_area(std::span<const geom::Point> outline) {
  if (outline.empty()) return false;
  constexpr double kFlat = 1e-9;
  const geom::Point first = outline.front();
  const auto away = [&](geom::Point p) { return geom::distance(first, p); };
  const geom::Offset axis = *std::ranges::max_element(outline, {}, away) - first;
  return std::ranges::any_of(outline, [&](geom::Point p) {
    return std::abs(geom::cross(axis, p - first)) > kFlat * geom::dot(axis, axis);
  });
}

Task task_of(std::span<const geom::Point> outline, const Ground& ground, double swath,
             std::optional<geom::Point> from, const Opaque& opaque) {
  if (std::isfinite(swath)) swath = std::min(swath, widest_swath(outline));
  return {outline, ground, swath, from, opaque ? std::span(*opaque) : std::span(ground.walls)};
}

// The area in cells, and which of them can be seen.
struct Outlook {
  Outlook(const Task& task, const Clearances& clearances, std::uint64_t most_effort) {
    const auto& [outline, ground, swath, from, opaque] = task;
    if (!is_usable(outline, ground, clearances, swath)) {
      told.end = CoverageEnd::kUnusable;
      return;
    }
    if (outline.size() < 3) return;
    const auto lanes = shortest_lanes(outline, swath, Coverage::kMostLanes);
    if (lanes) grid = SearchGrid::over(*lanes, swath);
    if (!grid) {
      told.end = CoverageEnd::kTooLarge;
      return;
    }
    if (!has_area(outline)) {
      told.end = CoverageEnd::kNoArea;
      return;
    }
    planner.emplace(ground, clearances);
    told.clearance = clearances.widest();
    is_known = grid->enter(outline, ground, opaque, *planner, from, most_effort);
    told.free_area = static_cast<double>(grid->to_search()) * grid->cell_area();
    if (!is_known || grid->to_see() == 0) return;
    told.visible = static_cast<double>(grid->visible()) / static_cast<double>(grid->to_search());
    told.end = CoverageEnd::kPartly;
  }

  Coverage told;         ///< `kPartly`: grid and planner are there, and something can be seen
  bool is_known = true;  ///< false: given up
  std::optional<SearchGrid> grid;
  std::optional<BendingPlanner> planner;
};

/// At the widest clearance from which about as much can be seen as from the least one.
std::unique_ptr<Outlook> widest_outlook(const Task& task, const Clearances& clearances,
                                        std::uint64_t most_effort) {
  const auto at = [&](std::size_t number) {
    return std::make_unique<Outlook>(task, clearances.bent(number), most_effort);
  };
  const std::size_t last = clearances.all().size() - 1;
  auto out = at(0);
  if (last == 0 || !out->planner || out->told.visible >= 1.0 - kLost) return out;
  auto least = at(last);
  if (!least->is_known) return least;
  const auto sees_enough = [&] { return out->told.visible >= least->told.visible - kLost; };
  for (std::size_t number = 1; number < last && out->is_known && !sees_enough(); ++number) out = at(number);
  return !out->is_known || sees_enough() ? std::move(out) : std::move(least);
}

}  // namespace

std::optional<Coverage> coverage_outlook(std::span<const geom::Point> outline, const Ground& ground,
                                         const Clearances& clearances, double swath,
                                         std::optional<geom::Point> from, const Opaque& opaque) {
  const auto outlook =
      widest_outlook(task_of(outline, ground, swath, from, opaque), clearances, kMostOutlookEffort);
  return outlook->is_known ? std::optional(outlook->told) : std::nullopt;
}

Coverage coverage_route(std::span<const geom::Point> outline, const Ground& ground,
                        const Clearances& clearances, double swath, std::span<const geom::Point> robots,
                        const Opaque& opaque) {
  const auto from = robots.empty() ? std::nullopt : std::optional(robots.front());
  const auto outlook =
      widest_outlook(task_of(outline, ground, swath, from, opaque), clearances, Planner::kNoLimit);
  Coverage out = outlook->told;
  if (out.end != CoverageEnd::kPartly) return out;
  SearchGrid& grid = *outlook->grid;
  BendingPlanner& planner = *outlook->planner;
  planner.know_rooms([&](geom::Point p) { return grid.room_of(p, planner.clearing()); });
  const auto shares = shared_out(lane_pieces_in_order(grid, planner), planner, robots, swath);
  SearchRoute route(grid, planner, shares, kMostEffort);
  const auto to_see = static_cast<double>(grid.to_see());
  const auto most_unseen = static_cast<std::size_t>(kUnseen * to_see);
  improve(route, most_unseen);
  auto [stops, corners, first_stops] = route.waypoints();
  out.waypoints = std::move(stops);
  out.corners = std::move(corners);
  out.shares = std::move(first_stops);
  out.length = route.length();
  out.seen = 1.0 - static_cast<double>(grid.unseen()) / to_see;
  out.end = out.seen >= Coverage::kWanted ? CoverageEnd::kCovered : CoverageEnd::kPartly;
  if (out.waypoints.size() <= Coverage::kMostWaypoints) return out;
  out = {};
  out.end = CoverageEnd::kTooLarge;
  return out;
}

}  // namespace mlab::ways
