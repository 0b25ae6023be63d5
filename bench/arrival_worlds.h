#pragma once

// The worlds of arrival_study.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "mlab/geom/pose.h"

namespace mlab::bench {

constexpr double kOutdoors = 5.2;  // body and margin [m]
constexpr double kIndoors = 0.3;   // body and what is left of the margin [m]

/// A world as a mission and its overlay, from (0, 0) to `size`.
struct World {
  geom::Point size;
  geom::Point start;
  geom::Point goal;
  geom::Offset step{0, 20};  ///< from one robot to the next at the start; their row has its middle there
  double spacing = 50.0;     ///< of formations [m]
  double clearance = kOutdoors;
  std::string overlay = {};
  std::string settings = {};  ///< lines of the mission
  bool has_others = false;    ///< another unit of as many goes the other way
};

inline constexpr std::array<std::string_view, 8> kWorlds = {"field", "unknown", "rooms",  "corridor",
                                                            "maze",  "bows",    "moving", "swap"};

/// The same for the same seed.
/// @param name      one of kWorlds
/// @param coverage  of fields [per cent]
World world_of(std::string_view name, double coverage, std::uint64_t seed);

}  // namespace mlab::bench
