#include "mlab/run/places.h"

#include <charconv>
#include <cmath>
#include <string>

#include <fmt/core.h>

namespace mlab::run {
namespace {

constexpr std::size_t kLongestNameForHints = 200;

// `310 205`, `310, 205`
std::optional<geom::Point> coordinates_in(std::string_view words) {
  double values[2] = {};
  const char* at = words.data();
  const char* const end = at + words.size();
  const auto skip = [&](std::string_view what) {
    while (at < end && what.find(*at) != std::string_view::npos) ++at;
  };
  for (double& value : values) {
    skip(" \t,");
    const auto [behind, failure] = std::from_chars(at, end, value);
    if (failure != std::errc() || !std::isfinite(value)) return std::nullopt;
    at = behind;
  }
  skip(" \t");
  return at == end ? std::optional(geom::Point{values[0], values[1]}) : std::nullopt;
}

}  // namespace

std::optional<geom::Point> MissionPlaces::find(std::string_view words) const {
  if (const overlay::ControlMeasure* measure = overlay::find_measure(mission_.overlay, words))
    return measure->center();
  const std::optional<geom::Point> point = coordinates_in(words);
  return point ? std::optional(*point + mission_.overlay.origin) : std::nullopt;
}

void MissionPlaces::explain(std::string_view words, text::Diagnostic& diagnostic) const {
  if (mission_.overlay.measures.empty()) {
    diagnostic.label = "the mission has no overlay with places";
    return;
  }
  const std::string near =
      words.size() > kLongestNameForHints ? "" : overlay::nearest_measure_name(mission_.overlay, words);
  if (near.empty()) {
    diagnostic.hints.emplace_back("a place is one of the mission's overlays, or two coordinates");
    return;
  }
  diagnostic.hints.push_back(fmt::format("did you mean `{}`?", near));
  const overlay::ControlMeasure* meant = overlay::find_measure(mission_.overlay, near);
  if (meant != nullptr && meant->place.source)
    diagnostic.notes.push_back({fmt::format("`{}` declared here", near), meant->place});
}

}  // namespace mlab::run
