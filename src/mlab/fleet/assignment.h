#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mlab/fleet/group.h"
#include "mlab/geom/pose.h"

namespace mlab::fleet {

/// Which of the stations each robot takes, so that all ways to them together are shortest; then no two of
/// them cross. Where nothing is gained each keeps its own. Exact up to kMostExact robots; with more of them
/// no two that are near each other gain by an exchange.
/// @param robots    where they are, in rank order [m, world]
/// @param stations  where their stations are, likewise, as many
/// @return  for each robot the index of its station
/// @source  Hungarian method with potentials: Kuhn 1955, Jonker and Volgenant 1987
std::vector<std::uint32_t> assign_stations(std::span<const geom::Point> robots,
                                           std::span<const geom::Point> stations);
inline constexpr std::size_t kMostExact = 200;

/// Puts the members of a group that is to take stations by assignment in the order of those that it takes.
/// Who others measure their stations from keeps its own.
void assign_ranks(Group& group, const std::vector<geom::Pose>& poses);

}  // namespace mlab::fleet
