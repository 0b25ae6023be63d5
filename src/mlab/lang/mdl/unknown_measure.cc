#include "mlab/lang/mdl/unknown_measure.h"

#include <algorithm>

#include <fmt/core.h>

#include "mlab/lang/mdl/quoted.h"
#include "mlab/lang/mdl/token.h"

namespace mlab::mdl {
namespace {

// A place's name as one writes it in a mission.
std::string reference(const overlay::ControlMeasure& measure, bool with_prefix) {
  const std::string name =
      (with_prefix ? std::string(overlay::keyword(measure.kind)) + "-" : "") + measure.name;
  const auto is_plain = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '-';
  };
  const bool starts_with_letter =
      !name.empty() && !(name[0] >= '0' && name[0] <= '9') && name[0] != '-' && name[0] != '_';
  return starts_with_letter && std::ranges::all_of(name, is_plain) ? name : "\"" + name + "\"";
}

void label(text::Diagnostic& error, const overlay::Overlay& overlay,
           const std::vector<std::string>& overlays) {
  if (overlays.empty())
    error.label = overlay.measures.empty() ? "the mission has no overlay" : "not on the map";
  else if (overlays.size() == 1)
    error.label = fmt::format("not in overlay {}", in_backticks(overlays.front()));
  else
    error.label = fmt::format("in none of the {} overlays", overlays.size());
}

}  // namespace

void report_unknown_measure(const Name& name, const overlay::Overlay& overlay,
                            const std::vector<std::string>& overlays, const PlaceIndex& places,
                            const text::SourcePtr& source, text::Diagnostics& diagnostics) {
  auto& error = diagnostics.error("unknown-control-measure", {source, name.span},
                                  fmt::format("unknown control measure {}", in_backticks(name.text)));
  if (diagnostics.error_count() > text::Diagnostics::kMaxErrors) return;
  label(error, overlay, overlays);
  if (!name.quoted && find_keyword(name.text) != nullptr) {
    error.hints.emplace_back("this is a word of the language; the name of a place is expected here");
    return;
  }
  if (name.text.size() > kLongestNameForHints) return;
  const std::string near = overlay::nearest_measure_name(overlay, name.text);
  const overlay::ControlMeasure* meant = near.empty() ? nullptr : places.find(near);
  if (meant == nullptr) return;
  const bool with_prefix = overlay::spellings(name.text)[1] != name.text;
  const std::string better = in_backticks(reference(*meant, with_prefix));
  error.hints.push_back(fmt::format("did you mean {}?", better));
  error.notes.push_back({fmt::format("{} declared here", better), meant->place});
}

}  // namespace mlab::mdl
