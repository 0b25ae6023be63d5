#include "mlab/lang/odl/token.h"

#include <algorithm>
#include <array>

namespace mlab::odl {
namespace {

constexpr std::array kBeforeFeatures = {
    Word{Keyword::kScenario, "SCENARIO", "", "`SCENARIO name`: a title"},
    Word{Keyword::kSite, "SITE", "", "`SITE name`: where it is"},
    Word{Keyword::kOrigin, "ORIGIN", "",
         "`ORIGIN x y`: added to all coordinates that follow; `ORIGIN GEO place`: where (0, 0) lies"},
    Word{Keyword::kGlobalRefPoint, "GLOBAL_REF_POINT", "",
         "`GLOBAL_REF_POINT latitude longitude` in degrees"},
    Word{Keyword::kHeading, "HEADING", "", "`HEADING degrees`: of all robots at the start"},
    Word{Keyword::kMissionArea, "MISSION-AREA", "", "`MISSION-AREA width height` in metres"},
    Word{Keyword::kLoadMap, "LOAD-MAP", "", "`LOAD-MAP file`: a background picture"},
    Word{Keyword::kSet, "SET", "", "`SET ZOOM-FACTOR percent`"},
    Word{Keyword::kScale, "SCALE", "", "`SCALE number`"},
    Word{Keyword::kHeightmap, "HEIGHTMAP", "", "`HEIGHTMAP file width height sea-level z-scale`"},
    Word{Keyword::kControlMeasures, "CONTROL MEASURES:", "", "the features follow"},
};
constexpr std::array kBehindMeasures = {
    Word{Keyword::kAttractor, "ATTRACTOR", "", "something that robots look for"},
    Word{Keyword::kObject, "OBJECT", "", "something that robots perceive, and perhaps carry"},
    Word{Keyword::kBasket, "BASKET", "", "takes what robots bring"},
    Word{Keyword::kFlag, "FLAG", "", "a flag"},
    Word{Keyword::kObstacle, "OBSTACLE", "",
         "`OBSTACLE x y radius [height] [ROUTE x y ... SPEED number]`: solid"},
    Word{Keyword::kWaypointFile, "WAYPOINT-FILE", "", "`WAYPOINT-FILE file`: features from another file"},
    Word{Keyword::kUtm, "UTM", "", "the point in degrees: `UTM LAT degrees LON degrees`"},
    Word{Keyword::kGeo, "GEO", "", "the point on the Earth: `GEO \"48.2 N 16.4 E\"`, or in UTM or MGRS"},
    Word{Keyword::kLat, "LAT", "", "degrees north"},
    Word{Keyword::kLon, "LON", "", "degrees east"},
    Word{Keyword::kMovable, "MOVABLE", "", "can be carried"},
    Word{Keyword::kFixed, "FIXED", "", "can't be carried"},
    Word{Keyword::kContainer, "CONTAINER", "", "holds things"},
    Word{Keyword::kCenterline, "CENTERLINE", "", "the middle of a hallway"},
    Word{Keyword::kWidth, "WIDTH", "", "of a hallway, in metres"},
    Word{Keyword::kExtents, "EXTENTS", "", "the outline of a hallway"},
    Word{Keyword::kRoute, "ROUTE", "", "where it goes, there and back; round and round where it ends at x y"},
    Word{Keyword::kSpeed, "SPEED", "", "along its route, in m/s"},
    Word{Keyword::kZoomFactor, "ZOOM-FACTOR", "", "10 to 400 per cent"},
};
static_assert(kBeforeFeatures.size() + kBehindMeasures.size() + 1 ==
              static_cast<std::size_t>(Keyword::kFirstMeasure));

constexpr auto kAllWords = [] {
  std::array<Word, kBeforeFeatures.size() + overlay::kMeasures.size() + kBehindMeasures.size()> out;
  auto next = std::ranges::copy(kBeforeFeatures, out.begin()).out;
  for (const overlay::MeasureInfo& measure : overlay::kMeasures)
    *next++ = {keyword_of(measure.kind), measure.keyword, measure.also, measure.help};
  std::ranges::copy(kBehindMeasures, next);
  return out;
}();

constexpr char upper(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

bool is_same(std::string_view spelling, std::string_view word) {
  return spelling.size() == word.size() && std::ranges::equal(spelling, word, {}, {}, upper);
}

}  // namespace

std::span<const Word> words() {
  return kAllWords;
}

std::string_view spelling(Keyword keyword) {
  const auto* found = std::ranges::find(kAllWords, keyword, &Word::keyword);
  return found == kAllWords.end() ? std::string_view{} : found->spelling;
}

Keyword find_keyword(std::string_view word) {
  if (word.empty()) return Keyword::kNone;
  for (const Word& entry : kAllWords) {
    if (is_same(entry.spelling, word) || is_same(entry.also, word)) return entry.keyword;
  }
  return Keyword::kNone;
}

}  // namespace mlab::odl
