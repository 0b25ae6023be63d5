#include "mlab/console/run/live_run.h"

#include <utility>

#include <fmt/core.h>

#include "mlab/run/report.h"

namespace mlab::console {

LiveRun::LiveRun(std::shared_ptr<const run::Crew> crew, std::unique_ptr<run::MissionRun> run, EventLog& log,
                 std::unique_ptr<history::Recorder> recorder)
    : crew_(std::move(crew)),
      run_(std::move(run)),
      log_(&log),
      recorder_(std::move(recorder)),
      notes_(*run_, log) {
  run_->set_observer([this](const mission::Effect& effect) {
    if (recorder_) recorder_->see(effect);
    notes_.see(effect);
  });
}

LiveRun::~LiveRun() {
  if (recorder_) recorder_->end(run::outcome_name(*run_, run::RunEnd::kInterrupted));
}

// When there is one, and when it does not go on.
void LiveRun::tell_recording() {
  if (const std::string& path = recorder_->path(); path != told_path_ && recorder_->is_recording()) {
    told_path_ = path;
    std::string text = fmt::format("this run is recorded in {}", path);
    if (recorder_->is_same_file()) text = fmt::format("this run goes on being recorded in {}", path);
    if (const std::string& why = recorder_->why_anew(); !why.empty())
      text = fmt::format("this run is recorded anew from its beginning, in {}: {}", path, why);
    log_->add(run_->time(), {Log::MESSAGE, std::move(text), 0, "", {}, false});
  }
  if (const std::string& problem = recorder_->problem(); problem != told_problem_) {
    told_problem_ = problem;
    log_->add(run_->time(), {Log::WARNING,
                             fmt::format("the recording of this run does not go on: {}", problem),
                             0,
                             "",
                             {},
                             true});
  }
}

void LiveRun::edit(std::shared_ptr<const run::Crew> crew) {
  crew_ = std::move(crew);
  run_->edit(crew_);
  notes_.change();
}

std::expected<run::Takeover, std::string> LiveRun::take_over(std::shared_ptr<const run::Crew> crew) {
  auto out = run_->take_over(crew);
  if (out) crew_ = std::move(crew);
  notes_.change();
  return out;
}

run::MissionRun::Progress LiveRun::step() {
  const run::MissionRun::Progress progress = run_->step();
  if (recorder_) {
    if (progress == run::MissionRun::Progress::kStepped)
      recorder_->note_cycle();
    else
      recorder_->note_rest();
    tell_recording();
  }
  notes_.look(progress == run::MissionRun::Progress::kStepped);
  return progress;
}

void LiveRun::note_recomputed_cycle(bool is_known) {
  if (crew_ != run_->crew()) {
    crew_ = run_->crew();
    notes_.change();
  }
  if (recorder_) recorder_->note_cycle();
  notes_.look_again(is_known);
}

void LiveRun::go_on_in(EventLog& log) {
  log_ = &log;
  notes_.go_on_in(log);
  if (recorder_) tell_recording();  // it stands: nobody would be told otherwise until it goes on
}

bool LiveRun::was_started() const {
  return !run_->state().steps.empty() || run_->state().mode != mission::State::Mode::kIdle ||
         run_->cycle() > 0;
}

}  // namespace mlab::console
