#include <algorithm>
#include <filesystem>
#include <utility>

#include "mlab/lang/mdl/commands.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/lang/mdl/names.h"
#include "mlab/lang/mdl/plan_check.h"
#include "mlab/lang/mdl/preamble.h"
#include "mlab/lang/mdl/tree.h"

namespace mlab::mdl {
namespace {

mission::RobotType predefined_type() {
  mission::RobotType out;
  out.name = "ROBOT";
  out.program = "robot";
  return out;
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
  mission->types.push_back(predefined_type());
  Roster roster(*mission, source, tree.damage, diagnostics);
  Preamble preamble(*mission, roster, tree.damage, folder, options, diagnostics);
  preamble.run(tree);
  const PlaceIndex places(mission->overlay);
  CommandReader reader({*mission, places, roster, tree.damage, preamble.overlays()}, source, diagnostics);
  mission->steps = read_steps(tree, reader);
  if (diagnostics.error_count() > errors) return nullptr;
  std::ranges::sort(mission->robots, {}, &mission::Robot::id);
  check_plan(*mission, diagnostics);
  return mission;
}

std::shared_ptr<const mission::Mission> load_mission(const std::string& path, text::Diagnostics& diagnostics,
                                                     const LoadOptions& options) {
  text::Result<text::SourcePtr> source = text::read_source(path);
  if (!source) {
    diagnostics.report(std::move(source.error()));
    return nullptr;
  }
  return check_mission(*source, std::filesystem::path(path).parent_path().string(), diagnostics, options);
}

}  // namespace mlab::mdl
