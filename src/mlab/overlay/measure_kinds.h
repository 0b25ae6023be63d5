#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>

#include "mlab/base/table.h"

namespace mlab::overlay {

/// The kinds of named control measures: what a mission may send a unit to, or follow. The numbers are those
/// of `Measure.Kind` on the wire, so a new kind comes last.
enum class MeasureKind : std::uint8_t {
  kAssemblyArea,
  kAttackPosition,
  kBattlePosition,
  kObjective,
  kPassagePoint,
  kStartPoint,
  kAxis,
  kGap,
  kBoundary,
  kLineOfDeparture,
  kPhaseLine,
  kWall,
  kRoom,
  kDoor,
  kHallway,
  kRoad,
  kMinefield,
  kLandingZone
};

/// Where the console's menu has it.
enum class MeasureGroup : std::uint8_t { kPlaces, kLines, kBuildings };
/// As the page has it.
constexpr std::string_view name(MeasureGroup group) {
  switch (group) {
    case MeasureGroup::kPlaces:
      return "Places";
    case MeasureGroup::kLines:
      return "Lines";
    case MeasureGroup::kBuildings:
      return "Buildings";
  }
  return "";
}

/// How somebody draws it: one click; the corners of a region, or a circle; the points of a line; a rectangle.
enum class MeasureShape : std::uint8_t { kPoint, kRegion, kLine, kHallway };
/// As the page has it.
constexpr std::string_view name(MeasureShape shape) {
  switch (shape) {
    case MeasureShape::kPoint:
      return "point";
    case MeasureShape::kRegion:
      return "region";
    case MeasureShape::kLine:
      return "line";
    case MeasureShape::kHallway:
      return "hallway";
  }
  return "";
}

/// What the number of its statement means.
enum class MeasureSize : std::uint8_t { kNone, kDiameter, kWidth, kHeight };
/// As the page has it.
constexpr std::string_view name(MeasureSize size) {
  switch (size) {
    case MeasureSize::kNone:
      return "";
    case MeasureSize::kDiameter:
      return "diameter";
    case MeasureSize::kWidth:
      return "width";
    case MeasureSize::kHeight:
      return "height";
  }
  return "";
}

/// What robots notice of it.
enum class Substance : std::uint8_t {
  kDrawn,      ///< nothing: it only stands on the map
  kSolid,      ///< sensed, hides what is behind it, stops robots
  kPerceived,  ///< the robots' map of the building has it
  kAvoided,    ///< they keep out of it as of an obstacle, though nothing stops or hides anything there
};

/// The sign that stands for it on maps; who draws has one function for each.
enum class MeasureSign : std::uint8_t {
  kArea,
  kHeldArea,     ///< an area that shows the size of who holds it
  kLandingArea,  ///< an area within a broken outline
  kPoint,
  kFlag,
  kArrow,
  kLine,
  kArcs,
  kRails,
  kBoundary,
  kWall,
  kRoom,
  kDoor,
  kHallway,
  kRoad
};
/// As the page has it.
constexpr std::string_view name(MeasureSign sign) {
  switch (sign) {
    case MeasureSign::kArea:
      return "area";
    case MeasureSign::kHeldArea:
      return "held_area";
    case MeasureSign::kLandingArea:
      return "landing_area";
    case MeasureSign::kPoint:
      return "point";
    case MeasureSign::kFlag:
      return "flag";
    case MeasureSign::kArrow:
      return "arrow";
    case MeasureSign::kLine:
      return "line";
    case MeasureSign::kArcs:
      return "arcs";
    case MeasureSign::kRails:
      return "rails";
    case MeasureSign::kBoundary:
      return "boundary";
    case MeasureSign::kWall:
      return "wall";
    case MeasureSign::kRoom:
      return "room";
    case MeasureSign::kDoor:
      return "door";
    case MeasureSign::kHallway:
      return "hallway";
    case MeasureSign::kRoad:
      return "road";
  }
  return "";
}

inline constexpr std::size_t kAnyNumber = std::numeric_limits<std::size_t>::max();

/// All that is to be known of one kind; what has no default must be said of each. Parsers, printers, checks,
/// completion, help, maps, editors' grammars and the documentation take it from here; `tools/tables` writes
/// what is not C++.
// In the order in which one reads a row; there are few of them.
// NOLINTNEXTLINE(clang-analyzer-optin.performance.Padding)
struct MeasureInfo {
  MeasureKind kind;
  std::string_view id;         ///< on the wire and in the page: `assembly_area`
  std::string_view keyword;    ///< of its statement: `AA`; it also stands before a hyphen in references
  std::string_view also = {};  ///< a second spelling of the keyword; empty: none
  std::string_view label;      ///< for people: `Assembly area`
  std::string_view purpose;    ///< what it is for, a line for menus and the documentation
  std::string_view help;       ///< what editors say of the keyword
  MeasureGroup group{};
  MeasureShape shape;
  std::size_t min_points = 1;  ///< that a statement may have
  std::size_t max_points = kAnyNumber;
  std::size_t min_drawn = 1;  ///< that somebody has to draw
  std::size_t max_drawn = kAnyNumber;
  MeasureSize size{};
  double default_size = 0.0;  ///< [m], where a statement gives none
  bool is_line = false;       ///< FOLLOW takes it
  Substance substance{};
  MeasureSign sign;
  std::string_view color;      ///< of the sign in the plain style: a colour of the map's palette
  std::string_view icon;       ///< in menus: an outline in SVG's language of paths, 24 units wide and high
  bool is_hatched = false;     ///< the inside of its sign
  std::string_view said = {};  ///< what stands before its name on the map in the plain style
  std::string_view code = {};  ///< the same in the military style
  int layer;                   ///< signs with a lower one are drawn first
  int weight = 2;              ///< names with a higher one are placed first; 2: written small
};

/// In the order of menus and of the documentation.
inline constexpr std::array kMeasures = {
    MeasureInfo{.kind = MeasureKind::kAssemblyArea,
                .id = "assembly_area",
                .keyword = "AA",
                .label = "Assembly area",
                .purpose = "Where units gather and start",
                .help = "assembly area",
                .shape = MeasureShape::kRegion,
                .size = MeasureSize::kDiameter,
                .default_size = 50.0,
                .sign = MeasureSign::kArea,
                .color = "assembly",
                .icon = "M4 8.5L12 4l8 3.5-1.5 10L8 20z",
                .code = "AA",
                .layer = 3,
                .weight = 8},
    MeasureInfo{.kind = MeasureKind::kPassagePoint,
                .id = "passage_point",
                .keyword = "PP",
                .label = "Passage point",
                .purpose = "A point on the way",
                .help = "passage point",
                .shape = MeasureShape::kPoint,
                .max_points = 1,
                .max_drawn = 1,
                .size = MeasureSize::kDiameter,
                .default_size = 10.0,
                .sign = MeasureSign::kPoint,
                .color = "passage",
                .icon = "M12 18a6 6 0 1 0 0-12 6 6 0 0 0 0 12zM12 12v.1",
                .layer = 14,
                .weight = 7},
    MeasureInfo{.kind = MeasureKind::kAttackPosition,
                .id = "attack_position",
                .keyword = "ATK",
                .label = "Attack position",
                .purpose = "The last place before the attack",
                .help = "attack position",
                .shape = MeasureShape::kRegion,
                .size = MeasureSize::kDiameter,
                .default_size = 50.0,
                .sign = MeasureSign::kArea,
                .color = "attack",
                .icon = "M5 5h14v14H5zM9 12h6M12 9v6",
                .code = "ATK",
                .layer = 6,
                .weight = 8},
    MeasureInfo{.kind = MeasureKind::kBattlePosition,
                .id = "battle_position",
                .keyword = "BP",
                .label = "Battle position",
                .purpose = "A place to hold",
                .help = "battle position",
                .shape = MeasureShape::kRegion,
                .size = MeasureSize::kDiameter,
                .default_size = 50.0,
                .sign = MeasureSign::kHeldArea,
                .color = "battle",
                .icon = "M4 12c0-5 3.5-7 8-7s8 2 8 7-3.5 7-8 7-8-2-8-7zM12 5V2.5M12 21.5V19",
                .code = "BP",
                .layer = 5,
                .weight = 8},
    MeasureInfo{.kind = MeasureKind::kObjective,
                .id = "objective",
                .keyword = "OBJ",
                .label = "Objective",
                .purpose = "What the mission is to reach",
                .help = "objective",
                .shape = MeasureShape::kRegion,
                .size = MeasureSize::kDiameter,
                .default_size = 50.0,
                .sign = MeasureSign::kArea,
                .color = "objective",
                .icon = "M12 20a8 8 0 1 0 0-16 8 8 0 0 0 0 16zM12 15a3 3 0 1 0 0-6 3 3 0 0 0 0 6z",
                .code = "OBJ",
                .layer = 4,
                .weight = 9},
    MeasureInfo{.kind = MeasureKind::kMinefield,
                .id = "minefield",
                .keyword = "MINEFIELD",
                .label = "Minefield",
                .purpose = "Robots keep out of it; nothing stops them",
                .help = "an area that robots keep out of, though nothing stops them",
                .group = MeasureGroup::kPlaces,
                .shape = MeasureShape::kRegion,
                .size = MeasureSize::kDiameter,
                .default_size = 50.0,
                .substance = Substance::kAvoided,
                .sign = MeasureSign::kArea,
                .color = "repelling",
                .icon = "M4 8.5L12 4l8 3.5-1.5 10L8 20zM9 15V9.5l3 3.5 3-3.5V15",
                .is_hatched = true,
                .code = "M",
                .layer = 3,
                .weight = 8},
    MeasureInfo{.kind = MeasureKind::kLandingZone,
                .id = "landing_zone",
                .keyword = "LANDING-ZONE",
                .label = "Landing zone",
                .purpose = "Where aircraft land; robots may go there",
                .help = "outline of an area where aircraft land",
                .shape = MeasureShape::kRegion,
                .min_points = 3,
                .min_drawn = 3,
                .sign = MeasureSign::kLandingArea,
                .color = "landing",
                .icon = "M5 5h14v14H5zM9.5 8.5v7M14.5 8.5v7M9.5 12h5",
                .code = "LZ",
                .layer = 3,
                .weight = 8},
    MeasureInfo{.kind = MeasureKind::kStartPoint,
                .id = "start_point",
                .keyword = "SP",
                .label = "Start point",
                .purpose = "Where a robot starts",
                .help = "start place",
                .shape = MeasureShape::kPoint,
                .max_points = 1,
                .max_drawn = 1,
                .sign = MeasureSign::kFlag,
                .color = "passage",
                .icon = "M7 21V4h11l-3 4 3 4H7",
                .said = "SP",
                .layer = 15,
                .weight = 7},
    MeasureInfo{.kind = MeasureKind::kAxis,
                .id = "axis",
                .keyword = "AXIS",
                .label = "Axis of advance",
                .purpose = "A line to follow, in its direction",
                .help = "axis of advance: a line to follow",
                .group = MeasureGroup::kLines,
                .shape = MeasureShape::kLine,
                .min_drawn = 2,
                .size = MeasureSize::kWidth,
                .default_size = 100.0,
                .is_line = true,
                .sign = MeasureSign::kArrow,
                .color = "axis",
                .icon = "M3 10h10V6l8 6-8 6v-4H3z",
                .said = "Axis",
                .layer = 7,
                .weight = 6},
    MeasureInfo{.kind = MeasureKind::kGap,
                .id = "gap",
                .keyword = "GAP",
                .label = "Gap",
                .purpose = "A way through; opens nothing",
                .help = "an opening between two points, to go through",
                .group = MeasureGroup::kLines,
                .shape = MeasureShape::kLine,
                .min_points = 2,
                .max_points = 2,
                .min_drawn = 2,
                .max_drawn = 2,
                .size = MeasureSize::kWidth,
                .default_size = 40.0,
                .is_line = true,
                .sign = MeasureSign::kRails,
                .color = "gap",
                .icon = "M4 5l4 4h8l4-4M4 19l4-4h8l4 4",
                .layer = 11,
                .weight = 5},
    MeasureInfo{.kind = MeasureKind::kBoundary,
                .id = "boundary",
                .keyword = "BOUNDARY",
                .label = "Boundary",
                .purpose = "Limit between units, or a closed zone",
                .help = "a drawn line, no wall",
                .group = MeasureGroup::kLines,
                .shape = MeasureShape::kLine,
                .min_drawn = 2,
                .is_line = true,
                .sign = MeasureSign::kBoundary,
                .color = "boundary",
                .icon = "M3 17l6-9 6 5 6-8M12 8.5l-2-2M18 10.5l-2-2",
                .layer = 8},
    MeasureInfo{.kind = MeasureKind::kPhaseLine,
                .id = "phase_line",
                .keyword = "PL",
                .label = "Phase line",
                .purpose = "Its crossing is told, or waited at",
                .help = "phase line: its crossing can be told",
                .group = MeasureGroup::kLines,
                .shape = MeasureShape::kLine,
                .min_drawn = 2,
                .is_line = true,
                .sign = MeasureSign::kLine,
                .color = "line",
                .icon = "M3 12c4-6 7 6 11 0 2-3 4-3 7-1M3 8v8M21 7v8",
                .said = "PL",
                .code = "PL",
                .layer = 9,
                .weight = 4},
    MeasureInfo{.kind = MeasureKind::kLineOfDeparture,
                .id = "line_of_departure",
                .keyword = "LDLC",
                .also = "LD/LC",
                .label = "Line of departure",
                .purpose = "Line of departure, line of contact",
                .help = "line of departure, line of contact",
                .group = MeasureGroup::kLines,
                .shape = MeasureShape::kLine,
                .min_drawn = 2,
                .is_line = true,
                .sign = MeasureSign::kArcs,
                .color = "line",
                .icon = "M2 15a3.3 3.3 0 0 1 6.6 0 3.3 3.3 0 0 1 6.6 0 3.3 3.3 0 0 1 6.6 0",
                .said = "LD/LC",
                .code = "LD/LC",
                .layer = 10,
                .weight = 4},
    MeasureInfo{.kind = MeasureKind::kRoad,
                .id = "road",
                .keyword = "ROAD",
                .label = "Road",
                .purpose = "A road, to follow and to perceive",
                .help = "a road that robots can follow",
                .group = MeasureGroup::kLines,
                .shape = MeasureShape::kLine,
                .min_drawn = 2,
                .size = MeasureSize::kWidth,
                .default_size = 10.0,
                .is_line = true,
                .sign = MeasureSign::kRoad,
                .color = "softInk",
                .icon = "M8 21L10 3M16 21L14 3M12 5v3M12 11v3M12 17v3",
                .layer = 0},
    MeasureInfo{.kind = MeasureKind::kWall,
                .id = "wall",
                .keyword = "WALL",
                .label = "Wall",
                .purpose = "Solid: stops robots, hides what is behind",
                .help = "solid line",
                .group = MeasureGroup::kBuildings,
                .shape = MeasureShape::kLine,
                .min_drawn = 2,
                .size = MeasureSize::kHeight,
                .default_size = 1.0,
                .is_line = true,
                .substance = Substance::kSolid,
                .sign = MeasureSign::kWall,
                .color = "wall",
                .icon = "M3 7h18v10H3zM3 12h18M9 7v5M15 7v5M6 12v5M12 12v5M18 12v5",
                .layer = 12},
    MeasureInfo{.kind = MeasureKind::kRoom,
                .id = "room",
                .keyword = "ROOM",
                .label = "Room",
                .purpose = "Robots know that they are inside",
                .help = "outline of a room",
                .group = MeasureGroup::kBuildings,
                .shape = MeasureShape::kRegion,
                .min_drawn = 3,
                .is_line = true,
                .substance = Substance::kPerceived,
                .sign = MeasureSign::kRoom,
                .color = "softInk",
                .icon = "M4 5h16v14H4zM14 19v-5h6",
                .layer = 1},
    MeasureInfo{.kind = MeasureKind::kDoor,
                .id = "door",
                .keyword = "DOOR",
                .label = "Door",
                .purpose = "Robots see it; opens no wall",
                .help = "a way through a wall",
                .group = MeasureGroup::kBuildings,
                .shape = MeasureShape::kLine,
                .min_drawn = 2,
                .max_drawn = 2,
                .is_line = true,
                .substance = Substance::kPerceived,
                .sign = MeasureSign::kDoor,
                .color = "wall",
                .icon = "M6 20V4M6 20h12M6 6c8 0 12 6 12 14",
                .layer = 13},
    MeasureInfo{.kind = MeasureKind::kHallway,
                .id = "hallway",
                .keyword = "HALLWAY",
                .label = "Hallway",
                .purpose = "Robots know that they are inside, and its direction",
                .help = "`HALLWAY name CENTERLINE points WIDTH number EXTENTS points`",
                .group = MeasureGroup::kBuildings,
                .shape = MeasureShape::kHallway,
                .min_drawn = 2,
                .max_drawn = 2,
                .size = MeasureSize::kWidth,
                .default_size = 2.0,
                .is_line = true,
                .substance = Substance::kPerceived,
                .sign = MeasureSign::kHallway,
                .color = "softInk",
                .icon = "M3 8h18M3 16h18M6 12h12M15 9.5l3 2.5-3 2.5",
                .layer = 2},
};
static_assert(base::has_a_row_for_each<kMeasures, &MeasureInfo::kind>());

constexpr const MeasureInfo& info(MeasureKind kind) {
  return base::row_of(kMeasures, &MeasureInfo::kind, kind);
}
/// `AA`, `ATK`, ...
constexpr std::string_view keyword(MeasureKind kind) {
  return info(kind).keyword;
}

}  // namespace mlab::overlay
