#include "mlab/overlay/overlay.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>

#include "mlab/text/diagnostic.h"

namespace mlab::overlay {
namespace {

// More names than this are not compared for a hint: it is about a few hundred microseconds.
constexpr std::size_t kNamesForHints = 2000;

char lower(char c) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}
char upper(char c) {
  return static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
}

// `AA1` of `AA-AA1`; the whole where it has no prefix.
std::string_view without_prefix(std::string_view reference) {
  // Keywords have hyphens of their own (`LANDING-ZONE`), so the hyphen behind one need not be the first.
  const auto is_head = [&](const MeasureInfo& info) {
    const std::size_t length = info.keyword.size();
    return reference.size() > length && reference[length] == '-' &&
           std::ranges::equal(info.keyword, reference.substr(0, length), {}, {}, upper);
  };
  const auto* const kind = std::ranges::find_if(kMeasures, is_head);
  return kind != kMeasures.end() ? reference.substr(kind->keyword.size() + 1) : reference;
}

}  // namespace

geom::Point ControlMeasure::center() const {
  if (points.empty()) return {};
  geom::Offset sum;
  for (const geom::Point& p : points) sum = sum + (p - geom::Point{});
  const auto count = static_cast<double>(points.size());
  return {sum.x / count, sum.y / count};
}

ZoneKind zone_kind(const ControlMeasure& measure) {
  if (measure.kind != MeasureKind::kBoundary) return ZoneKind::kNone;
  if (measure.name.contains("WeatherZone")) return ZoneKind::kWeather;
  if (measure.name.contains("NoFlyZone")) return ZoneKind::kNoFly;
  if (measure.name.contains("NoCommZone")) return ZoneKind::kNoCommunication;
  return ZoneKind::kNone;
}

std::array<std::string, 5> spellings(std::string_view reference) {
  const std::string bare(without_prefix(reference));
  if (bare.empty()) return {std::string(reference), bare, bare, bare, bare};
  std::string lowered = bare;
  std::transform(lowered.begin() + 1, lowered.end(), lowered.begin() + 1, lower);
  std::string raised = lowered;
  raised[0] = upper(raised[0]);
  std::string capitals = raised;
  std::ranges::transform(capitals, capitals.begin(), upper);
  return {std::string(reference), bare, lowered, raised, capitals};
}

const ControlMeasure* find_measure(const Overlay& overlay, std::string_view reference) {
  const std::array<std::string, 5> wanted = spellings(reference);
  const ControlMeasure* best = nullptr;
  std::size_t best_rank = wanted.size();
  // Backwards, since the last of equal names wins.
  for (auto measure = overlay.measures.rbegin(); measure != overlay.measures.rend() && best_rank > 0;
       ++measure) {
    const auto rank = static_cast<std::size_t>(std::ranges::find(wanted, measure->name) - wanted.begin());
    if (rank < best_rank) {
      best = &*measure;
      best_rank = rank;
    }
  }
  return best;
}

std::string nearest_measure_name(const Overlay& overlay, std::string_view reference) {
  const std::string_view bare = without_prefix(reference);
  std::vector<std::string> names;
  for (const ControlMeasure& measure : overlay.measures) {
    if (names.size() == kNamesForHints) break;
    if (!measure.name.empty()) names.push_back(measure.name);
  }
  return text::nearest_name(bare, names);
}

}  // namespace mlab::overlay
