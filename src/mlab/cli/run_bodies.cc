#include "mlab/cli/run_bodies.h"

#include <utility>

#include <fmt/core.h>

#include "mlab/base/counted.h"
#include "mlab/cli/run_settings.h"
#include "mlab/cli/terminal.h"
#include "mlab/recording/recording_binding.h"
#include "mlab/simulated/run.h"
#include "mlab/text/shown.h"

namespace mlab::cli {
namespace {

constexpr std::size_t kMostTold = 8;

}  // namespace

bool RunBodies::open(RunOptions& options) {
  save_path_ = options.save_percepts;
  outputs_ = outputs_of(options);
  if (options.percepts.empty()) return true;
  auto file = recording::PerceptsReader::open(options.percepts);
  if (!file) {
    tell(file.error());
    return false;
  }
  file_ = std::move(*file);
  options.seed = file_->head().seed();
  return true;
}

std::unique_ptr<run::MissionRun> RunBodies::make_run(const std::shared_ptr<const mission::Mission>& mission,
                                                     const robot::ProgramSources& sources,
                                                     const run::RunSettings& settings,
                                                     text::Diagnostics& sink) {
  std::shared_ptr<const run::Crew> crew = run::check_crew(mission, sources, sink);
  if (!crew) return nullptr;
  if (const std::string problem = problem_with_outputs(outputs_, files_read_for(*crew->mission, crew.get()));
      !problem.empty()) {
    sink.error("output-is-read", {}, problem);
    return nullptr;
  }
  std::unique_ptr<binding::Binding> bodies;
  if (file_) {
    if (file_->head().mission() != mission->name)
      sink.warning("other-mission", {},
                   fmt::format("`{}` has the percepts of mission `{}`, and this one is `{}`",
                               text::shown(file_->path()), text::shown(file_->head().mission()),
                               text::shown(mission->name)));
    auto recorded = std::make_unique<recording::RecordedBinding>(std::move(file_), settings.threads);
    read_ = recorded.get();
    bodies = std::move(recorded);
  } else {
    bodies = simulated::make_bodies(*mission, settings);
  }
  if (!save_path_.empty()) {
    auto file = recording::PerceptsWriter::create(save_path_, settings.seed, mission->name);
    if (!file) {
      sink.report(file.error());
      return nullptr;
    }
    written_ = std::move(*file);
    bodies = std::make_unique<recording::RecordingBinding>(std::move(bodies), written_);
  }
  return std::make_unique<run::MissionRun>(std::move(crew), settings, std::move(bodies));
}

bool RunBodies::conclude() {
  if (written_) {
    if (const auto problem = written_->finish()) {
      tell(*problem);
      return false;
    }
  }
  if (read_ == nullptr) return true;
  const auto& differences = read_->differences();
  if (differences.empty()) {
    fmt::print("as recorded: {}\n", base::counted(read_->same_actions(), "action"));
    return true;
  }
  for (std::size_t i = 0; i < differences.size() && i < kMostTold; ++i) {
    const recording::Difference& one = differences[i];
    fmt::print("not as recorded: robot {} in cycle {} ({:.1f} s) {}\n", one.robot.value, one.cycle, one.time,
               one.what);
  }
  if (differences.size() > kMostTold)
    fmt::print("not as recorded: {} more\n", base::counted(differences.size() - kMostTold, "robot"));
  return false;
}

}  // namespace mlab::cli
