#include "mlab/console/documents/mission_references.h"

#include <variant>

#include "mlab/console/documents/mission_text.h"
#include "mlab/lang/mdl/names.h"

namespace mlab::console {

std::vector<PlaceReference> place_references(const mdl::Tree& mission, const overlay::Overlay& map) {
  std::vector<PlaceReference> out;
  const mdl::PlaceIndex places(map);
  const auto add = [&](const mdl::Name& name) {
    const overlay::ControlMeasure* found = places.find(name.text);
    if (found == nullptr) return;
    out.push_back({name.span, name.text, static_cast<std::uint32_t>(found - map.measures.data())});
  };
  for (const mdl::Statement& statement : mission.preamble) {
    const auto* failsafe = std::get_if<mdl::statement::Failsafe>(&statement.what);
    if (failsafe != nullptr && failsafe->fence) add(*failsafe->fence);
  }
  for (const mdl::LabelledStep& step : mission.steps) {
    for (const mdl::Statement& statement : step.commands) {
      const auto* action = std::get_if<mdl::statement::UnitAction>(&statement.what);
      if (action == nullptr) continue;
      if (action->location && action->location->name) add(*action->location->name);
      for (const mdl::Clause& clause : action->clauses) {
        if (const auto* line = std::get_if<mdl::clause::PhaseLine>(&clause.what)) add(line->line);
      }
    }
  }
  return out;
}

std::string renamed_reference(const PlaceReference& reference, const overlay::Overlay& changed,
                              std::uint32_t measure) {
  const overlay::ControlMeasure& meant = changed.measures[measure];
  const bool has_prefix = overlay::spellings(reference.name)[1] != reference.name;
  const std::string prefix = has_prefix ? std::string(overlay::keyword(meant.kind)) + '-' : "";
  for (const std::string& name : {prefix + meant.name, meant.name}) {
    if (overlay::find_measure(changed, name) == &meant) return written_reference(name);
  }
  return "";
}

}  // namespace mlab::console
