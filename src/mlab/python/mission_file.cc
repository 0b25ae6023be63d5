#include "mlab/python/mission_file.h"

#include <filesystem>
#include <utility>

#include "mlab/cli/places.h"
#include "mlab/lang/envchange/envchange.h"
#include "mlab/robot/program/configuration_file.h"
#include "mlab/simulated/run.h"

namespace mlab::python {
namespace {

constexpr std::uint64_t kSeedOfCrew = 1;  // that a mission is read with which no run has asked for yet

}  // namespace

MissionFile::MissionFile(Request request) : request_(std::move(request)), files_(once_.files()) {
  const std::string folder = std::filesystem::path(request_.path).parent_path().string();
  sources_ = cli::program_sources(folder, request_.permission);
  sources_.project = folder.empty() ? "." : folder;
  sources_.files = &files_;
}

mdl::LoadOptions MissionFile::options(std::uint64_t seed) const {
  mdl::LoadOptions out;
  out.seed = seed;
  out.overlay_folders = cli::overlay_folders();
  out.files = files_;
  out.societies = robot::society_reader(sources_);
  out.settings = request_.settings;
  return out;
}

std::shared_ptr<const run::Crew> MissionFile::read(std::uint64_t seed,
                                                   overlay::EnvironmentChanges& environment,
                                                   text::Diagnostics& sink) const {
  const auto mission = mdl::load_mission(request_.path, sink, options(seed));
  if (!mission) return nullptr;
  if (!request_.environment.empty()) {
    const text::Result<text::SourcePtr> source = files_.read(request_.environment);
    if (!source) {
      sink.report(source.error());
      return nullptr;
    }
    auto changes = envchange::parse(*source, mission->overlay.origin, sink);
    if (!changes) return nullptr;
    environment = std::move(*changes);
  }
  return crew_ ? run::make_crew(mission, sources_, sink, crew_.get())
               : run::check_crew(mission, sources_, sink);
}

std::shared_ptr<const MissionFile> MissionFile::load(Request request, std::stop_token ends,
                                                     text::Diagnostics& sink) {
  const std::shared_ptr<MissionFile> out(new MissionFile(std::move(request)));
  out->sources_.ends = std::move(ends);
  out->crew_ = out->read(kSeedOfCrew, out->environment_, sink);
  out->sources_.ends = {};
  return out->crew_ ? out : nullptr;
}

std::unique_ptr<run::MissionRun> MissionFile::make_run(run::RunSettings settings,
                                                       text::Diagnostics& sink) const {
  if (!crew_->mission->has_obstacles_by_seed) {
    settings.environment = environment_;
    return simulated::make_run(crew_, settings);
  }
  text::Diagnostics said;  // warnings were told when it was loaded
  auto crew = read(settings.seed, settings.environment, said);
  if (crew) return simulated::make_run(std::move(crew), settings);
  for (const text::Diagnostic& one : said.items()) sink.report(one);
  return nullptr;
}

std::optional<mdl::Immediate> MissionFile::read_line(const std::string& line, const run::MissionRun& run,
                                                     text::Diagnostics& sink) const {
  return mdl::parse_immediate(line, run.mission(), sink, options(run.seed()));
}

std::shared_ptr<const run::Crew> MissionFile::crew_after(const mdl::Immediate& line,
                                                         const run::MissionRun& run,
                                                         text::Diagnostics& sink) const {
  return run::make_crew(line.edited, sources_, sink, run.crew().get());
}

}  // namespace mlab::python
