#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "mlab/geom/pose.h"
#include "mlab/percept/site_map.h"

namespace mlab::sim {

/// The rooms, doors and hallways of a world, as its map says. A plain value.
struct Building {
  std::vector<percept::Door> doors;
  std::vector<std::vector<geom::Point>> rooms;  ///< outlines [m]
  std::vector<percept::Hallway> hallways;
};

/// A building and the marks on its doors. Cheap to copy: what doesn't change is shared.
class Site {
 public:
  explicit Site(Building building);

  percept::SiteMap map() const;
  const std::vector<percept::Door>& doors() const { return doors_; }
  /// Marks a door that lies within reach of a place, or takes its mark away.
  /// @param number  1 for the first door
  /// @param reach   from the place to the nearest point of the door [m]
  void mark(std::uint32_t number, bool is_marked, geom::Point place, double reach);

 private:
  struct Fixed {
    std::vector<std::vector<geom::Point>> outlines;
    std::vector<percept::Room> rooms;
    std::vector<percept::Hallway> hallways;
  };
  std::shared_ptr<const Fixed> fixed_;
  std::vector<percept::Door> doors_;
};

}  // namespace mlab::sim
