#include <algorithm>
#include <filesystem>
#include <string_view>
#include <unordered_map>
#include <utility>

#include <fmt/core.h>

#include "mlab/lang/mdl/battery_check.h"
#include "mlab/lang/mdl/commands.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/lang/mdl/names.h"
#include "mlab/lang/mdl/plan_check.h"
#include "mlab/lang/mdl/preamble.h"
#include "mlab/lang/mdl/quoted.h"
#include "mlab/lang/mdl/settings.h"
#include "mlab/lang/mdl/tree.h"

namespace mlab::mdl {
namespace {

mission::RobotType predefined_type() {
  mission::RobotType out;
  out.name = "ROBOT";
  out.program = "robot";
  return out;
}

// Overlays warn of equal names among their own features; this is for the start places of the mission.
void check_names(const mission::Mission& mission, text::Diagnostics& diagnostics) {
  std::unordered_map<std::string_view, const overlay::ControlMeasure*> first;
  for (const overlay::ControlMeasure& measure : mission.overlay.measures) {
    const auto [entry, is_new] = first.try_emplace(measure.name, &measure);
    if (is_new || measure.name.empty() || measure.place.source != mission.source) continue;
    diagnostics
        .warning("duplicate-name", measure.place,
                 fmt::format("there is another place {}; commands mean this one", in_backticks(measure.name)))
        .notes.push_back({"the first one is here", entry->second->place});
  }
}

std::vector<mission::Step> read_steps(const Tree& tree, CommandReader& reader) {
  std::vector<mission::Step> out;
  for (const LabelledStep& written : tree.steps) {
    mission::Step& step = out.emplace_back();
    step.label = written.label.text;
    step.place = {tree.source, written.label.span};
    for (const Statement& statement : written.commands) {
      if (auto command = reader.read(statement)) step.commands.push_back(std::move(*command));
    }
  }
  return out;
}

// As `options`, and what is read is added to `texts`.
LoadOptions noting_texts(const LoadOptions& options, std::vector<text::SourcePtr>& texts) {
  LoadOptions out = options;
  out.files.read = [read = options.files.read, &texts](const std::string& path) {
    text::Result<text::SourcePtr> source = read(path);
    if (source) texts.push_back(*source);
    return source;
  };
  return out;
}

}  // namespace

std::shared_ptr<const mission::Mission> check_mission(const text::SourcePtr& source,
                                                      const std::string& folder,
                                                      text::Diagnostics& diagnostics,
                                                      const LoadOptions& options) {
  const std::size_t errors = diagnostics.error_count();
  Tree tree = parse(source, diagnostics);
  if (tree.is_immediate) {
    diagnostics.error("not-a-mission", {source, {}}, "this is a typed command, not a mission")
        .hints.emplace_back("a mission has a preamble and the line `COMMAND LIST:`");
    return nullptr;
  }
  auto mission = std::make_shared<mission::Mission>();
  mission->source = source;
  mission->folder = folder;
  for (const Setting& one : options.settings) mission->set.emplace_back(one.name, one.value);
  mission->types.push_back(predefined_type());
  Roster roster(*mission, source, tree.damage, diagnostics, options.societies);
  const LoadOptions noting = noting_texts(options, mission->texts);
  Settings settings(options.settings, diagnostics);
  Preamble preamble(*mission, roster, tree.damage, folder, noting, settings, diagnostics);
  preamble.run(tree);
  settings.set_parameters(*mission, tree.damage.types);
  if (!diagnostics.has_errors()) preamble.create_requested_obstacles();
  const PlaceIndex places(mission->overlay);
  CommandReader reader({*mission, places, roster, tree.damage, preamble.overlays()}, source, diagnostics);
  mission->steps = read_steps(tree, reader);
  for (mission::Step& step : mission->steps) settings.set_options(step, mission->options);
  settings.set_formations(mission->steps);
  if (diagnostics.error_count() > errors) return nullptr;
  std::ranges::sort(mission->robots, {}, &mission::Robot::id);
  check_names(*mission, diagnostics);
  check_batteries(*mission, diagnostics);
  check_plan(*mission, diagnostics);
  return mission;
}

overlay::Overlay check_map(const text::SourcePtr& source, const std::string& folder,
                           text::Diagnostics& diagnostics, const LoadOptions& options) {
  Tree tree = parse(source, diagnostics);
  mission::Mission mission;
  mission.source = source;
  mission.types.push_back(predefined_type());
  text::Diagnostics unsaid;  // of units and robots: none of the map's business
  Roster roster(mission, source, tree.damage, unsaid);
  std::erase_if(tree.preamble, [](const Statement& statement) {
    return std::holds_alternative<statement::NewRobot>(statement.what) ||
           std::holds_alternative<statement::UnitDefinition>(statement.what);
  });
  Settings settings(options.settings, unsaid);
  Preamble preamble(mission, roster, tree.damage, folder, options, settings, diagnostics);
  preamble.run(tree);
  preamble.create_requested_obstacles();
  return std::move(mission.overlay);
}

std::shared_ptr<const mission::Mission> load_mission(const std::string& path, text::Diagnostics& diagnostics,
                                                     const LoadOptions& options) {
  text::Result<text::SourcePtr> source = options.files.read(path);
  if (!source) {
    diagnostics.report(std::move(source.error()));
    return nullptr;
  }
  return check_mission(*source, std::filesystem::path(path).parent_path().string(), diagnostics, options);
}

}  // namespace mlab::mdl
