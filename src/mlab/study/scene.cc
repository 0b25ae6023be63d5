#include "mlab/study/scene.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "mlab/base/hash.h"
#include "mlab/lang/envchange/envchange.h"
#include "mlab/robot/program/configuration_file.h"
#include "mlab/simulated/run.h"

namespace mlab::study {

text::Files ReadOnce::files() {
  text::Files out;
  out.is_file = [kept = kept_](const std::string& path) {
    const std::lock_guard lock(kept->mutex);
    const auto [entry, is_new] = kept->is_file.try_emplace(path, false);
    if (is_new) entry->second = text::files_on_disk().is_file(path);
    return entry->second;
  };
  out.read = [kept = kept_](const std::string& path) {
    const std::lock_guard lock(kept->mutex);
    auto entry = kept->texts.find(path);
    if (entry == kept->texts.end()) entry = kept->texts.emplace(path, text::files_on_disk().read(path)).first;
    return entry->second;
  };
  out.beginning = text::files_on_disk().beginning;
  return out;
}

std::uint64_t ReadOnce::fingerprint() const {
  const std::lock_guard lock(kept_->mutex);
  std::vector<std::uint64_t> hashes;
  for (const auto& [path, text] : kept_->texts) {
    if (text) hashes.push_back(base::hash_text((*text)->text()));
  }
  std::ranges::sort(hashes);
  std::uint64_t out = 0;
  for (const std::uint64_t hash : hashes) out = base::combine_bits(out, hash);
  return out;
}

namespace {

// A file that a definition names is missing where it is named.
void report_unread(text::Diagnostic problem, const Written& named, text::Diagnostics& sink) {
  if (!problem.place.source) problem.place = named.place;
  sink.report(std::move(problem));
}

}  // namespace

Scene::Scene(const Definition& definition, const Plan& plan, Written mission_file, mdl::LoadOptions around,
             robot::ProgramSources sources, run::RunSettings manner)
    : definition_(definition),
      plan_(plan),
      file_(std::move(mission_file)),
      around_(std::move(around)),
      sources_(std::move(sources)),
      manner_(std::move(manner)) {
  sources_.files = &around_.files;
  around_.societies = robot::society_reader(sources_);
}

std::shared_ptr<const run::Crew> Scene::read(std::uint64_t seed, std::vector<mdl::Setting> settings,
                                             overlay::EnvironmentChanges& environment,
                                             text::Diagnostics& sink) const {
  mdl::LoadOptions around = around_;
  around.seed = seed;
  around.settings = std::move(settings);
  if (const auto source = around_.files.read(file_.text); !source) {
    report_unread(source.error(), file_, sink);
    return nullptr;
  }
  const std::shared_ptr<const mission::Mission> mission = mdl::load_mission(file_.text, sink, around);
  if (!mission) return nullptr;
  if (!definition_.environment.empty()) {
    const text::Result<text::SourcePtr> source = around_.files.read(definition_.environment.text);
    if (!source) {
      report_unread(source.error(), definition_.environment, sink);
      return nullptr;
    }
    auto changes = envchange::parse(*source, mission->overlay.origin, sink);
    if (!changes) return nullptr;
    environment = std::move(*changes);
  }
  // The first one is checked as `mlab run` does it; the programs of all others are its.
  return prepared_.empty() ? run::check_crew(mission, sources_, sink)
                           : run::make_crew(mission, sources_, sink, prepared_.front().crew.get());
}

bool Scene::prepare(text::Diagnostics& sink) {
  for (std::uint32_t i = 0; i < plan_.combinations(); ++i) {
    // What is only a warning is the same for all of them, and said once.
    text::Diagnostics own;
    text::Diagnostics& said = i == 0 ? sink : own;
    Prepared one;
    one.crew =
        read(plan_.seed(0), plan_.draws() ? plan_.extremes(i, false) : plan_.settings({.combination = i}),
             one.environment, said);
    if (one.crew && plan_.draws()) {
      overlay::EnvironmentChanges unused;
      text::Diagnostics highest;
      if (!read(plan_.seed(0), plan_.extremes(i, true), unused, highest)) {
        one.crew = nullptr;
        for (const text::Diagnostic& d : highest.items()) sink.report(d);
      }
    }
    if (!one.crew) {
      for (const text::Diagnostic& d : own.items()) sink.report(d);
      return false;
    }
    name_ = one.crew->mission->name;
    one.is_of_all_runs = !plan_.draws() && !plan_.names_seeds() && !one.crew->mission->has_obstacles_by_seed;
    prepared_.push_back(std::move(one));
  }
  return true;
}

std::expected<std::unique_ptr<run::MissionRun>, std::string> Scene::make_run(const RunKey& key) const {
  const Prepared& prepared = prepared_[key.combination];
  run::RunSettings settings = manner_;
  settings.seed = plan_.seed(key.run);
  if (prepared.is_of_all_runs) {
    settings.environment = prepared.environment;
    return simulated::make_run(prepared.crew, settings);
  }
  text::Diagnostics sink;
  std::shared_ptr<const run::Crew> crew =
      read(settings.seed, plan_.settings(key), settings.environment, sink);
  if (crew) return simulated::make_run(std::move(crew), settings);
  for (const text::Diagnostic& d : sink.items()) {
    if (d.severity == text::Severity::kError) return std::unexpected(d.message);
  }
  return std::unexpected("the mission can't be read");
}

}  // namespace mlab::study
