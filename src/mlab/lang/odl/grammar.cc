#include "mlab/lang/odl/grammar.h"

#include <algorithm>
#include <array>

namespace mlab::odl {
namespace {

using enum Keyword;

constexpr Rule word(Keyword keyword, std::string_view usage) {
  return {keyword, Form::kName, 0, 0, 0, 0, "", usage};
}
constexpr Rule numbers(Keyword keyword, std::size_t count, std::string_view what, std::string_view usage) {
  return {keyword, Form::kValues, 0, 0, count, count, what, usage};
}
// A named feature of at least one point, perhaps with a number.
constexpr Rule shape(Keyword keyword, std::string_view size, std::string_view usage) {
  return {keyword, Form::kNamed, 1, kAnyCount, 0, size.empty() ? std::size_t{0} : std::size_t{1},
          size,    usage};
}
// An unnamed feature at one point.
constexpr Rule spot(Keyword keyword, std::size_t least, std::size_t most, std::string_view what,
                    std::string_view usage) {
  return {keyword, Form::kValues, 1, 1, least, most, what, usage};
}

constexpr std::array kRules = {
    word(kScenario, "SCENARIO name"),
    word(kSite, "SITE name"),
    Rule{kOrigin, Form::kValues, 1, 1, 0, 0, "", "ORIGIN x y"},
    numbers(kGlobalRefPoint, 2, "the latitude", "GLOBAL_REF_POINT latitude longitude"),
    numbers(kHeading, 1, "the heading", "HEADING degrees"),
    numbers(kMissionArea, 2, "the width", "MISSION-AREA width height"),
    word(kLoadMap, "LOAD-MAP file"),
    Rule{kSet, Form::kSet, 0, 0, 1, 1, "the zoom factor", "SET ZOOM-FACTOR percent"},
    numbers(kScale, 1, "the scale", "SCALE number"),
    Rule{kHeightmap, Form::kFile, 0, 0, 4, 4, "the width", "HEIGHTMAP file width height sea-level z-scale"},
    shape(kAa, "a diameter", "AA name x y ... [diameter]"),
    shape(kAtk, "a diameter", "ATK name x y ... [diameter]"),
    shape(kAxis, "a width", "AXIS name x y ... [width]"),
    shape(kBoundary, "", "BOUNDARY name x y ..."),
    spot(kAttractor, 0, 1, "a diameter", "ATTRACTOR x y [diameter]"),
    Rule{kObject, Form::kObject, 1, 1, 1, 1, "the diameter",
         "OBJECT x y diameter MOVABLE|FIXED|CONTAINER color"},
    spot(kBasket, 0, 1, "a diameter", "BASKET x y [diameter]"),
    spot(kFlag, 0, 1, "a diameter", "FLAG x y [diameter]"),
    shape(kBp, "a diameter", "BP name x y ... [diameter]"),
    Rule{kGap, Form::kNamed, 2, 2, 0, 1, "a width", "GAP name x y x y [width]"},
    shape(kLdlc, "", "LDLC name x y ..."),
    shape(kObj, "a diameter", "OBJ name x y ... [diameter]"),
    spot(kObstacle, 1, 2, "the radius", "OBSTACLE x y radius [height]"),
    shape(kPl, "", "PL name x y ..."),
    Rule{kPp, Form::kNamed, 1, 1, 0, 1, "a diameter", "PP name x y [diameter]"},
    Rule{kSp, Form::kNamed, 1, 1, 0, 0, "", "SP name x y"},
    shape(kWall, "a height", "WALL name x y ... [height]"),
    shape(kRoom, "", "ROOM name x y ..."),
    shape(kDoor, "", "DOOR name x y ..."),
    Rule{kHallway, Form::kHallway, 1, kAnyCount, 1, 1, "the width",
         "HALLWAY name CENTERLINE x y ... WIDTH number EXTENTS x y ..."},
    shape(kRoad, "a width", "ROAD name x y ... [width]"),
    word(kWaypointFile, "WAYPOINT-FILE file"),
};

}  // namespace

const Rule& rule_of(Keyword keyword) {
  static constexpr Rule kNoRule;
  const auto* found = std::ranges::find(kRules, keyword, &Rule::keyword);
  return found == kRules.end() ? kNoRule : *found;
}

}  // namespace mlab::odl
