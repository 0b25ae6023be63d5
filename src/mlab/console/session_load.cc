#include <utility>

#include <fmt/core.h>

#include "mlab/console/session_parts.h"

namespace mlab::console {

robot::ProgramSources Session::Parts::program_sources() const {
  return {documents_.mission_folder(), settings_.include_root, settings_.version};
}

void Session::Parts::load(std::uint64_t seed) {
  const std::uint64_t number = ++loading_;
  seed_ = seed;
  const std::shared_ptr<const mission::Mission> mission = documents_.mission();
  changes_.project = changes_.documents = changes_.scene = changes_.edits = true;
  for (std::string& notice : documents_.take_notices())
    log_.add(sim_time(), {Log::EDIT, std::move(notice), 0, "", {}, false});
  if (!mission) {
    adopt(nullptr, nullptr);
    return;
  }
  is_loading_ = true;
  fleet::RunSettings run_settings = settings_.run;
  run_settings.seed = seed;
  workshop_->start([this, number, mission, run_settings, sources = program_sources()] {
    const auto problems = std::make_shared<text::Diagnostics>();
    const std::shared_ptr<const fleet::Crew> crew = fleet::make_crew(mission, sources, *problems);
    const auto run = std::make_shared<std::unique_ptr<fleet::MissionRun>>();
    if (crew) *run = std::make_unique<fleet::MissionRun>(crew, run_settings);
    inbox_.post([this, number, crew, run, problems] {
      if (number != loading_) return;
      report_problems(*problems);
      adopt(crew, std::move(*run));
    });
  });
}

void Session::Parts::adopt(std::shared_ptr<const fleet::Crew> crew, std::unique_ptr<fleet::MissionRun> run) {
  is_loading_ = false;
  live_.reset();
  if (run) {
    live_ = std::make_unique<LiveRun>(std::move(crew), std::move(run), log_);
    live_->run().set_stands_still_for_operator(pace_.speed() == 0.0);
    live_->run().set_emergency_stop(is_stopped_);
    named_units_ = live_->run().mission().units.size();
  }
  has_ended_ = false;
  has_nothing_to_do_ = time_runs_ = false;
  ++plan_revision_;
  ++version_;
  rows_.clear();
  changes_.roster = changes_.plan = changes_.status = changes_.questions = changes_.trails = true;
}

void Session::Parts::report_problems(const text::Diagnostics& problems) {
  for (const text::Diagnostic& problem : problems.items())
    log_.add(sim_time(),
             {Log::WARNING, problem.message, 0, "", {}, problem.severity == text::Severity::kError});
}

}  // namespace mlab::console
