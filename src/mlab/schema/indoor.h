#pragma once

#include <cstdint>
#include <optional>

#include "mlab/geom/pose.h"
#include "mlab/geom/vector.h"
#include "mlab/percept/site_map.h"

namespace mlab::schema {

/// Whether a place lies in a room, by the even-odd rule.
bool is_in(const percept::Room& room, geom::Point place);
/// Whether a place lies in a hallway, walls and ends included.
bool is_in(const percept::Hallway& hallway, geom::Point place);
bool is_in_room(const percept::SiteMap& map, geom::Point place);
/// The first hallway that holds the place; null where none does.
const percept::Hallway* hallway_at(const percept::SiteMap& map, geom::Point place);

/// Number of the door whose nearest point is nearest, from 1; 0 where there is none.
/// @param only_unmarked  marked doors count as not there
std::uint32_t nearest_door(const percept::SiteMap& map, geom::Point place, bool only_unmarked);
/// The door of that number; nothing where the map has no such door.
std::optional<percept::Door> door(const percept::SiteMap& map, std::uint32_t number);

/// How a robot goes through a door: to a place straight behind its middle, along the door's normal.
struct Passage {
  geom::Point middle;       ///< of the door [m, world]
  geom::Point target;       ///< behind it [m, world]
  double half_width = 0.0;  ///< of the door [m]
};
/// @param from   on which side the robot is [m, world]
/// @param depth  of the target behind the door [m]
Passage passage(const percept::Door& door, geom::Point from, double depth);

/// The field that leads to a place from one side of it: straight towards it from afar, inside the controlled
/// radius first onto the axis of approach and then along it.
struct DockField {
  double controlled_radius = 2.0;  ///< [m]
  double cone = 0.5;               ///< inside of this angle from the axis it goes on towards the place [rad]
  double ballistic_gain = 1.0;     ///< outside of the controlled radius
  double controlled_gain = 1.0;    ///< inside
};
/// @param robot     [m, world]
/// @param dock      [m, world]
/// @param approach  direction from the dock to where the robot has to come from [rad, world]
/// @return  wanted direction and strength, in the world frame; zero within 5 cm of the dock
/// @source  Arkin and Murphy 1990 (docking)
geom::Offset dock_direction(geom::Point robot, geom::Point dock, double approach, const DockField& field);

/// Whether a look to the side meets a door: a cone of 12 degrees, by its axis and edges.
/// @param heading  direction of the look [rad, world]
/// @param range    how far it goes [m]
bool looks_at(const percept::Door& door, geom::Point from, double heading, double range);

}  // namespace mlab::schema
