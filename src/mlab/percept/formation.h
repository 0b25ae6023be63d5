#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "mlab/geom/vector.h"

namespace mlab::percept {

/// The shape in which a unit moves. The numbers are those of the historic command messages.
enum class Formation : std::uint8_t {
  kNone,
  kLine,
  kLineLeft,
  kLineRight,
  kWedge,
  kWedgeLeft,
  kWedgeRight,
  kDiamond,
  kColumn,
  kSweep
};
inline constexpr int kFormationCount = 10;

/// What a robot measures its station from.
enum class FormationReference : std::uint8_t { kUnitCenter, kLeader, kNeighbor };

/// `Wedge-Left`, as a mission writes it.
std::string_view name(Formation formation);
/// The formation of that name, letter case aside.
std::optional<Formation> formation_named(std::string_view wanted);

/// The place of one robot in its unit's formation, relative to the unit's centre: x forward along the
/// formation heading, y to the left [m]. The stations of all ranks of a unit sum to zero.
///
/// @param rank     0-based rank of the robot among the members of its unit (0 is the leader), < count
/// @param count    members of the unit, >= 1
/// @param spacing  distance between neighbours, s [m], >= 0
/// @return  the station; zero for `kNone` and `kSweep` (a sweep has no sideways stations)
/// @source  stations for 2 to 4 robots: the historic tables, re-centred where they did not sum to zero; for
/// more:
///          line and column at s, wedge as a V of s/2 back and s/2 out for each rank, diamond along its
///          outline
geom::Vector station(Formation formation, int rank, int count, double spacing);

}  // namespace mlab::percept
