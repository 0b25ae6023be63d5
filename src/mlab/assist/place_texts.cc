#include "mlab/assist/place_texts.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include "mlab/assist/cdl_scan.h"
#include "mlab/assist/statement_names.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/lang/mdl/tree.h"

namespace mlab::assist {
namespace {

std::string beside(const std::string& file, const std::string& name) {
  return canonical_path((std::filesystem::path(file).parent_path() / name).string());
}

}  // namespace

std::vector<Name> PlaceTexts::in(const Text& configuration) {
  std::vector<Name> out;
  const text::SourcePtr& source = configuration.source;
  const bool may_name = configuration.language == Language::kConfiguration && around_.project &&
                        source->text().find("place") != std::string_view::npos;
  if (!may_name) return out;
  const CdlScan scan = scan_cdl(source);
  if (scan.places.empty()) return out;
  read_missions();
  const auto maps = maps_of_.find(canonical_path(source->name()));
  if (maps == maps_of_.end()) return out;
  for (const CdlName& written : scan.places) {
    std::vector<Target> known;
    for (const Map* map : maps->second) {
      const overlay::ControlMeasure* const measure = map->places.find(written.text);
      if (measure == nullptr || !measure->place.source) continue;
      Name name;
      name.kind = NameKind::kPlace;
      name.span = own_part(source, written.span, *measure);
      name.text = source->text(name.span);
      name.target = {measure->place.source, bare_name(measure->place.source, measure->place.span)};
      Target target = *targets_.of(name);
      if (std::ranges::find(known, target) != known.end()) continue;
      known.push_back(std::move(target));
      out.push_back(std::move(name));
    }
  }
  return out;
}

void PlaceTexts::read_missions() {
  if (std::exchange(is_read_, true)) return;
  const std::vector<Text> texts = around_.project();
  for (const Text& one : texts) {
    if (one.language == Language::kConfiguration)
      sources_.try_emplace(canonical_path(one.source->name()), one.source);
  }
  for (const Text& one : texts) {
    if (around_.given_up && around_.given_up()) return;
    if (one.language == Language::kMission) read_mission(one);
  }
}

void PlaceTexts::read_mission(const Text& mission) {
  text::Diagnostics unsaid;
  std::set<std::string> programs;
  for (const mdl::Statement& one : mdl::parse(mission.source, unsaid).preamble) {
    const auto* const robot = std::get_if<mdl::statement::NewRobot>(&one.what);
    if (robot == nullptr || robot->program.text.find('\0') != std::string::npos) continue;
    const std::string file = robot->program.text.substr(0, robot->program.text.rfind('#'));
    if (file.ends_with(".cdl")) programs.insert(beside(mission.source->name(), file));
  }
  if (programs.empty()) return;
  const Map& map = maps_.emplace_back(mdl::check_map(mission.source, folder_of(mission), unsaid,
                                                     {1, around_.overlay_folders, around_.files}));
  for (const std::string& path : programs) join(path, map);
}

void PlaceTexts::join(const std::string& path, const Map& map) {
  std::vector<std::string> open{path};
  std::set<std::string> seen{path};
  while (!open.empty()) {
    const std::string one = std::move(open.back());
    open.pop_back();
    std::vector<const Map*>& maps = maps_of_[one];
    if (maps.empty() || maps.back() != &map) maps.push_back(&map);
    for (const std::string& used : used_by(one)) {
      if (seen.size() < kMostFiles && seen.insert(used).second) open.push_back(used);
    }
  }
}

const std::vector<std::string>& PlaceTexts::used_by(const std::string& path) {
  const auto [known, is_new] = used_by_.try_emplace(path);
  if (!is_new) return known->second;
  text::SourcePtr source;
  if (const auto found = sources_.find(path); found != sources_.end()) {
    source = found->second;
  } else if (const auto read = around_.files.read(path)) {
    source = *read;
  }
  if (!source) return known->second;
  for (const CdlName& use : scan_cdl(source).uses) {
    if (use.text.ends_with(".cdl") && use.text.find('\0') == std::string::npos)
      known->second.push_back(beside(path, use.text));
  }
  return known->second;
}

}  // namespace mlab::assist
