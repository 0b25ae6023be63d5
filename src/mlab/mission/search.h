#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mlab/mission/state.h"

namespace mlab::mission {

/// The outline of a place that can be searched: of a region, or of a place with a diameter. Empty for others
/// [m].
std::vector<geom::Point> area_of(const overlay::ControlMeasure& measure);

/// The way by which a unit searches an area.
struct SearchWay {
  /// A share for each robot, as far as that is worth it, in four pieces of equal length, as percept::piece
  /// reads them. Empty where there is nothing to search [m, world].
  std::vector<geom::Point> route;
  double margin = 0.0;  ///< that it keeps from the edges of things, where there is room [m]
  std::string warning;  ///< what of the area will not be seen, and why; empty: nothing worth telling
};

/// Over all of the command's outline that is free of what the map shows and that a way leads to, at the
/// margin that its first robot keeps, or at less where less would be seen otherwise.
/// @param command  a SEARCH
/// @param robots   who shares it, at least one
/// @param places   where they are, of each one: shares are about as long, with the way there; empty: nobody
///                 knows [m, world]
/// @source  mlab/ways/coverage.h
SearchWay plan_search(const Mission& mission, const UnitCommand& command,
                      const std::vector<base::RobotId>& robots, std::span<const geom::Point> places);

/// What of the area no robot will see, and why, as far as that can be told at once; empty: nothing worth
/// telling.
/// @param name  of the area
std::string warn_of_search(const Mission& mission, const UnitCommand& command, base::RobotId robot,
                           std::optional<geom::Point> from, const std::string& name);

}  // namespace mlab::mission
