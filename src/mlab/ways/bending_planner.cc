#include "mlab/ways/bending_planner.h"

#include <algorithm>

namespace mlab::ways {

BendingPlanner::BendingPlanner(const Ground& ground, const Clearances& clearances) {
  planners_.reserve(clearances.all().size());
  for (const double clearance : clearances.all()) planners_.emplace_back(ground, clearance);
}

std::optional<geom::Point> BendingPlanner::nearest_free(geom::Point p) const {
  const Clearing& least = planners_.back().clearing();
  const auto wide = clearing().nearest_free(p);
  if (wide && (!least.is_free(p) || least.is_free(geom::Segment{p, *wide}))) return wide;
  return least.nearest_free(p);
}

std::optional<BendingPlanner::Rooms> BendingPlanner::rooms_of(geom::Point from, geom::Point to) const {
  if (!room_of_) return std::nullopt;
  const std::int32_t a = room_of_(from);
  const std::int32_t b = room_of_(to);
  return a < 0 || b < 0 ? std::nullopt : std::optional<Rooms>(std::minmax(a, b));
}

std::expected<Way, Planner::NoWay> BendingPlanner::find(geom::Point from, geom::Point to,
                                                        std::uint64_t most_effort) {
  if (planners_.size() == 1) return planners_.front().find(from, to, most_effort);
  const auto rooms = rooms_of(from, to);
  const auto known = rooms ? first_.find(*rooms) : first_.end();
  const std::size_t first = known == first_.end() ? 0 : known->second;
  Planner::NoWay no_way{true, from};
  for (std::size_t i = first; i < planners_.size(); ++i) {
    Planner& planner = planners_[i];
    if (!planner.clearing().is_free(from) || !planner.clearing().is_free(to)) continue;
    const std::uint64_t before = planner.effort();
    auto way = planner.find(from, to, most_effort);
    // What was given up at a wider clearance is no knowledge.
    if (way && rooms && no_way.is_certain) first_.emplace(*rooms, i);
    if (way) return way;
    most_effort -= std::min(most_effort, planner.effort() - before);
    no_way = {no_way.is_certain && way.error().is_certain, way.error().nearest};
  }
  if (rooms && no_way.is_certain) first_.emplace(*rooms, planners_.size());
  return std::unexpected(no_way);
}

std::uint64_t BendingPlanner::effort() const {
  std::uint64_t out = 0;
  for (const Planner& planner : planners_) out += planner.effort();
  return out;
}

}  // namespace mlab::ways
