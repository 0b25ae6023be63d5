#include "mlab/sim/site.h"

#include <utility>

namespace mlab::sim {

Site::Site(Building building) : doors_(std::move(building.doors)) {
  auto fixed = std::make_shared<Fixed>();
  fixed->outlines = std::move(building.rooms);
  fixed->hallways = std::move(building.hallways);
  for (const auto& outline : fixed->outlines) fixed->rooms.push_back({outline});
  fixed_ = std::move(fixed);
}

percept::SiteMap Site::map() const {
  return {doors_, fixed_->rooms, fixed_->hallways};
}

void Site::mark(std::uint32_t number, bool is_marked, geom::Point place, double reach) {
  if (number == 0 || number > doors_.size()) return;
  percept::Door& door = doors_[number - 1];
  if (distance(nearest_point({door.a, door.b}, place), place) <= reach) door.is_marked = is_marked;
}

}  // namespace mlab::sim
