#include "mlab/cli/batch_study.h"

#include <filesystem>
#include <utility>

#include <fmt/core.h>

#include "mlab/cli/clock.h"
#include "mlab/cli/files.h"
#include "mlab/cli/permission.h"
#include "mlab/study/study_file.h"
#include "mlab/text/shown.h"

namespace mlab::cli {
namespace {

run::RunSettings manner_of(const study::Definition& definition) {
  run::RunSettings out;
  out.executive.proceed_all = true;
  out.executive.patience = definition.patience;
  out.goes_on_when_done = definition.duration.has_value();
  if (const auto clock = parse_start_time(definition.start_time)) {
    out.executive.epoch_seconds = clock->epoch_seconds;
    out.executive.zone_offset = clock->zone_offset;
  }
  return out;
}

}  // namespace

std::optional<text::Diagnostic> wrong_start_time(const study::Definition& definition) {
  if (definition.start_time.empty() || parse_start_time(definition.start_time)) return std::nullopt;
  text::Diagnostic out;
  out.kind = "expected";
  out.message = fmt::format("expected YYYY-MM-DD HH:MM or YYYY-MM-DD HH:MM:SS, found `{}`",
                            text::shown(definition.start_time, 100));
  out.place = definition.start_time_place;
  return out;
}

Scenes scenes_of(const study::Definition& definition, const study::Plan& plan,
                 const cell::Permission& permission, const robot_host::Limits& limits,
                 text::Diagnostics& sink) {
  Scenes out;
  if (plan.combinations() > study::Plan::kMostCombinations) {
    sink.error("too-many-combinations", {},
               fmt::format("a batch has at most {} combinations of values", study::Plan::kMostCombinations));
    return out;
  }
  study::ReadOnce once;
  for (std::uint32_t version = 0; version < plan.versions(); ++version) {
    const study::Written& file = version == 0 ? definition.mission : definition.against;
    const std::string folder = std::filesystem::path(file.text).parent_path().string();
    robot::ProgramSources sources = program_sources(folder, permission);
    sources.limits = limits;
    sources.project = folder.empty() ? "." : folder;
    mdl::LoadOptions around;
    around.overlay_folders = overlay_folders();
    around.files = once.files();
    out.all.push_back(
        std::make_unique<study::Scene>(definition, plan, file, around, sources, manner_of(definition)));
    if (out.all.back()->prepare(sink)) continue;
    out.all.clear();
    return out;
  }
  out.texts = once.fingerprint();
  return out;
}

void check_study(const text::SourcePtr& source, bool without_cell, text::Diagnostics& sink) {
  study::Definition definition;
  if (!study::read_study(source, definition, sink)) return;
  if (auto problem = study::settle(definition)) {
    if (!problem->place.source) problem->place = {source, {0, 0}};
    sink.report(std::move(*problem));
    return;
  }
  if (auto problem = wrong_start_time(definition)) sink.report(std::move(*problem));
  const study::Plan plan(definition);
  scenes_of(definition, plan, permission_to_check(true, without_cell), {}, sink);
}

}  // namespace mlab::cli
