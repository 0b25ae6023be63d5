#include "mlab/lang/odl/token.h"

#include <algorithm>
#include <array>

namespace mlab::odl {
namespace {

struct Entry {
  Keyword keyword;
  std::string_view spelling;
};
// The first spelling of a keyword is the canonical one.
constexpr std::array kEntries = {
    Entry{Keyword::kScenario, "SCENARIO"},
    Entry{Keyword::kSite, "SITE"},
    Entry{Keyword::kOrigin, "ORIGIN"},
    Entry{Keyword::kGlobalRefPoint, "GLOBAL_REF_POINT"},
    Entry{Keyword::kHeading, "HEADING"},
    Entry{Keyword::kMissionArea, "MISSION-AREA"},
    Entry{Keyword::kLoadMap, "LOAD-MAP"},
    Entry{Keyword::kSet, "SET"},
    Entry{Keyword::kScale, "SCALE"},
    Entry{Keyword::kHeightmap, "HEIGHTMAP"},
    Entry{Keyword::kControlMeasures, "CONTROL MEASURES:"},
    Entry{Keyword::kAa, "AA"},
    Entry{Keyword::kAtk, "ATK"},
    Entry{Keyword::kAxis, "AXIS"},
    Entry{Keyword::kBoundary, "BOUNDARY"},
    Entry{Keyword::kAttractor, "ATTRACTOR"},
    Entry{Keyword::kObject, "OBJECT"},
    Entry{Keyword::kBasket, "BASKET"},
    Entry{Keyword::kFlag, "FLAG"},
    Entry{Keyword::kBp, "BP"},
    Entry{Keyword::kGap, "GAP"},
    Entry{Keyword::kLdlc, "LDLC"},
    Entry{Keyword::kLdlc, "LD/LC"},
    Entry{Keyword::kObj, "OBJ"},
    Entry{Keyword::kObstacle, "OBSTACLE"},
    Entry{Keyword::kPl, "PL"},
    Entry{Keyword::kPp, "PP"},
    Entry{Keyword::kSp, "SP"},
    Entry{Keyword::kWall, "WALL"},
    Entry{Keyword::kRoom, "ROOM"},
    Entry{Keyword::kDoor, "DOOR"},
    Entry{Keyword::kHallway, "HALLWAY"},
    Entry{Keyword::kRoad, "ROAD"},
    Entry{Keyword::kWaypointFile, "WAYPOINT-FILE"},
    Entry{Keyword::kZoomFactor, "ZOOM-FACTOR"},
    Entry{Keyword::kLat, "LAT"},
    Entry{Keyword::kLon, "LON"},
    Entry{Keyword::kUtm, "UTM"},
    Entry{Keyword::kCenterline, "CENTERLINE"},
    Entry{Keyword::kWidth, "WIDTH"},
    Entry{Keyword::kExtents, "EXTENTS"},
    Entry{Keyword::kMovable, "MOVABLE"},
    Entry{Keyword::kFixed, "FIXED"},
    Entry{Keyword::kContainer, "CONTAINER"},
};

constexpr char upper(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

}  // namespace

std::string_view spelling(Keyword keyword) {
  const auto* found = std::ranges::find(kEntries, keyword, &Entry::keyword);
  return found == kEntries.end() ? std::string_view{} : found->spelling;
}

Keyword find_keyword(std::string_view word) {
  for (const Entry& entry : kEntries) {
    if (entry.spelling.size() == word.size() && std::ranges::equal(entry.spelling, word, {}, {}, upper)) {
      return entry.keyword;
    }
  }
  return Keyword::kNone;
}

}  // namespace mlab::odl
