#include "mlab/lang/odl/grammar.h"

#include <vector>

#include <fmt/core.h>

namespace mlab::odl {
namespace {

constexpr std::string_view kRouteUsage = "[ROUTE x y ... SPEED number]";

using enum Keyword;
using overlay::MeasureInfo;

Rule word(Keyword keyword, std::string usage) {
  return {keyword, Form::kName, 0, 0, 0, 0, "", std::move(usage)};
}
Rule numbers(Keyword keyword, std::size_t count, std::string_view what, std::string usage) {
  return {keyword, Form::kValues, 0, 0, count, count, what, std::move(usage)};
}
// An unnamed feature that begins at one point.
Rule spot(Keyword keyword, std::size_t least, std::size_t most, std::string_view what,
          std::string_view usage) {
  return {keyword, Form::kMoving, 1, 1, least, most, what, fmt::format("{} {}", usage, kRouteUsage)};
}

std::string_view number_of(overlay::MeasureSize size) {
  switch (size) {
    case overlay::MeasureSize::kNone:
      return "";
    case overlay::MeasureSize::kDiameter:
      return "a diameter";
    case overlay::MeasureSize::kWidth:
      return "a width";
    case overlay::MeasureSize::kHeight:
      return "a height";
  }
  return "";
}

// A control measure: a name, points, perhaps a number.
Rule measure_rule(const MeasureInfo& measure) {
  const Keyword keyword = keyword_of(measure.kind);
  if (measure.shape == overlay::MeasureShape::kHallway) {
    return {keyword,
            Form::kHallway,
            measure.min_points,
            measure.max_points,
            1,
            1,
            "the width",
            fmt::format("{} name CENTERLINE x y ... WIDTH number EXTENTS x y ...", measure.keyword)};
  }
  const std::string_view number = number_of(measure.size);
  std::string usage = fmt::format("{} name", measure.keyword);
  const bool is_any_number = measure.max_points == overlay::kAnyNumber;
  for (std::size_t i = 0; i < (is_any_number ? measure.min_points : measure.max_points); ++i) usage += " x y";
  if (is_any_number) usage += " ...";
  if (!number.empty()) usage += fmt::format(" [{}]", number.substr(2));
  return {keyword, Form::kNamed,    measure.min_points, measure.max_points, 0, number.empty() ? 0U : 1U,
          number,  std::move(usage)};
}

std::vector<Rule> all_rules() {
  std::vector<Rule> out = {
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
      spot(kAttractor, 0, 1, "a diameter", "ATTRACTOR x y [diameter]"),
      Rule{kObject, Form::kObject, 1, 1, 1, 1, "the diameter",
           fmt::format("OBJECT x y diameter MOVABLE|FIXED|CONTAINER color {}", kRouteUsage)},
      spot(kBasket, 0, 1, "a diameter", "BASKET x y [diameter]"),
      spot(kFlag, 0, 1, "a diameter", "FLAG x y [diameter]"),
      spot(kObstacle, 1, 2, "the radius", "OBSTACLE x y radius [height]"),
      word(kWaypointFile, "WAYPOINT-FILE file"),
  };
  for (const MeasureInfo& measure : overlay::kMeasures) out.push_back(measure_rule(measure));
  return out;
}

// By the keyword's number.
std::vector<Rule> by_keyword() {
  std::vector<Rule> out(static_cast<std::size_t>(kFirstMeasure) + overlay::kMeasures.size());
  for (Rule& rule : all_rules()) {
    const auto number = static_cast<std::size_t>(rule.keyword);
    out[number] = std::move(rule);
  }
  return out;
}

}  // namespace

const Rule& rule_of(Keyword keyword) {
  static const std::vector<Rule> kRules = by_keyword();
  return kRules[static_cast<std::size_t>(keyword)];
}

}  // namespace mlab::odl
