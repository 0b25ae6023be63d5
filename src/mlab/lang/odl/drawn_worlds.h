#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "mlab/geom/pose.h"
#include "mlab/overlay/overlay.h"

namespace mlab::odl {

/// Worlds that are drawn by a seed, for studies of who finds the way.
enum class WorldKind : std::uint8_t { kRooms, kCorridor, kMaze, kBows, kTraffic, kGap };

struct WorldKindInfo {
  std::string_view name;
  std::string_view help;
};
/// In the order of WorldKind.
inline constexpr std::array kWorldKinds = {
    WorldKindInfo{"rooms", "twelve rooms of 30 m, whose doors are 2 to 4 m wide"},
    WorldKindInfo{"corridor", "a corridor of 8 m that turns, with pillars"},
    WorldKindInfo{"maze", "ten by eight cells of 12 m with one way from each to each"},
    WorldKindInfo{"bows", "twelve bows of rocks that lie across the way"},
    WorldKindInfo{"traffic", "rocks on 3 per cent of the area, and forty discs that go to and fro"},
    WorldKindInfo{"gap", "a wall with one gap of 12 m"},
};

struct DrawnWorld {
  overlay::Area size;  ///< from (0, 0)
  geom::Point start;   ///< free, and so is some space around it [m]
  geom::Point goal;
  std::string features = {};  ///< statements of an overlay, a line each
};

/// The same for the same seed on every machine.
DrawnWorld drawn_world(WorldKind kind, std::uint64_t seed);

/// The overlay: what stands there, and the passage points `Start` and `Goal`.
std::string text_of(const DrawnWorld& world, WorldKind kind, std::uint64_t seed);

}  // namespace mlab::odl
