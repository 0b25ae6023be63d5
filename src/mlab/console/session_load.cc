#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include "mlab/console/session_parts.h"
#include "mlab/simulated/run.h"

namespace mlab::console {
namespace {

bool is_in(const std::filesystem::path& path, const std::string& folder) {
  if (folder.empty()) return false;
  std::error_code failure;
  const std::filesystem::path root = std::filesystem::weakly_canonical(folder, failure);
  return !failure && std::ranges::mismatch(root, path).in1 == root.end();
}

// The folder that a mission's programs come from: the project, or the examples; of a mission that the command
// line named elsewhere, its own.
std::string root_of(const std::string& mission_folder, const SessionSettings& settings) {
  std::error_code failure;
  const std::filesystem::path folder = std::filesystem::weakly_canonical(mission_folder, failure);
  for (const std::string& root : {settings.project_folder, settings.example_folder}) {
    if (is_in(folder, root)) return root;
  }
  return mission_folder;
}

}  // namespace

robot::ProgramSources Session::Parts::program_sources() const {
  robot::ProgramSources out = {settings_.permission, documents_.mission_folder(), settings_.include_root,
                               settings_.version, documents_.is_trial() ? trial_files_.get() : nullptr};
  // What is tried reads through the project by itself.
  if (out.files == nullptr) out.project = root_of(documents_.mission_folder(), settings_);
  out.limits = settings_.limits;
  out.ends = jobs_end_.get_token();
  return out;
}

void Session::Parts::try_out(Trial trial, TrialDone done) {
  inbox_.post([this, trial = std::move(trial), done = std::move(done)] { start_trial(trial, done); });
}

void Session::Parts::look_at_run(RunLook look) {
  inbox_.post([this, look = std::move(look)] { look(live_ ? &live_->run() : nullptr); });
}

void Session::Parts::start_trial(const Trial& trial, TrialDone done) {
  const auto files_before = std::exchange(trial_files_, trial.files);  // the text names programs among them
  if (const text::Result<bool> opened = documents_.open_trial(trial, now()); !opened) {
    trial_files_ = files_before;
    done({opened.error().message, {}});
    return;
  }
  note(trial.who, fmt::format("try {}", trial.path));
  parameters_.clear();
  from_documents_.reset();
  changes_.project = true;
  follow_documents(Follow::kAnew);
  trial_done_ = std::move(done);
  executes_trial_ = trial.execute;
  if (!is_loading_) answer_trial("the mission of the trial has errors", documents_.problems());
}

void Session::Parts::answer_trial(const std::string& error, const text::Diagnostics& problems) {
  const TrialDone done = std::exchange(trial_done_, nullptr);
  if (done) done({error, problems});
}

void Session::Parts::load(std::uint64_t seed, const std::shared_ptr<const fleet::Crew>& known) {
  const std::uint64_t number = ++loading_;
  answer_trial("another run has taken its place", {});
  seed_ = seed;
  log_.begin_run();
  from_documents_ = plain_ = documents_.mission();
  typed_edits_.clear();
  if (!plain_) {
    adopt(nullptr, nullptr);
    return;
  }
  is_loading_ = true;
  fleet::RunSettings run_settings = settings_.run;
  run_settings.seed = seed;
  if (documents_.is_trial()) run_settings.executive.patience = 0.0;  // what is tried need not get anywhere
  workshop_->start([this, number, mission = plain_, run_settings, known, sources = program_sources(),
                    files = trial_files_] {
    if (number != loading_) return;
    const auto problems = std::make_shared<text::Diagnostics>();
    const std::shared_ptr<const fleet::Crew> crew =
        fleet::make_crew(mission, sources, *problems, known.get());
    const auto run = std::make_shared<std::unique_ptr<fleet::MissionRun>>();
    if (crew) *run = simulated::make_run(crew, run_settings);
    inbox_.post([this, number, crew, run, problems] {
      if (number != loading_) return;
      report_problems(*problems);
      adopt(crew, std::move(*run));
      if (trial_done_ && live_ && executes_trial_ && !why_not_now()) post(mission::event::Execute{});
      answer_trial(live_ ? "" : "it can't run: it has errors", *problems);
    });
  });
}

void Session::Parts::adopt(std::shared_ptr<const fleet::Crew> crew, std::unique_ptr<fleet::MissionRun> run) {
  is_loading_ = false;
  breakpoints_.begin(nullptr);
  live_.reset();
  if (run) {
    run->set_meanwhile([this] { return attend_during_cycle(); });
    live_ = std::make_unique<LiveRun>(std::move(crew), std::move(run), log_);
    live_->run().set_stands_still_for_operator(pace_.speed() == 0.0);
    live_->run().set_emergency_stop(is_stopped_);
    for (const auto& [robot, ports] : parameters_) {
      for (const auto& [port, value] : ports) live_->run().set_parameter({robot}, port, value);
    }
  }
  breakpoints_.begin(live_ ? &live_->run() : nullptr);
  halted_.Clear();
  has_nothing_to_do_ = time_runs_ = false;
  ++plan_revision_;
  ++version_;
  rows_.clear();
  teleoperations_ = {};
  sentences_.clear();
  for (auto& [id, channel] : channels_) channel.series_seen.clear();
  update_watches();
  changes_.roster = changes_.starts = changes_.plan = changes_.status = changes_.questions = changes_.trails =
      changes_.scene = true;
}

void Session::Parts::report_problems(const text::Diagnostics& problems) {
  for (const text::Diagnostic& problem : problems.items()) {
    const bool is_error = problem.severity == text::Severity::kError;
    const DocumentPlace place = documents_.place(problem.place);
    const std::string where =
        place.document.empty() ? "" : fmt::format("{}:{}: ", place.document, place.line);
    log_.add(sim_time(), {Log::WARNING, where + problem.message, 0, "", {}, is_error});
  }
}

}  // namespace mlab::console
