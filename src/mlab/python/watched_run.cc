#include "mlab/python/watched_run.h"

#include <chrono>
#include <utility>
#include <variant>

#include "mlab/base/overloaded.h"
#include "mlab/cli/clock.h"
#include "mlab/cli/places.h"
#include "mlab/cli/version.h"
#include "mlab/run/report.h"

namespace mlab::python {
namespace {

using mission::effect::Tell;
using Progress = run::MissionRun::Progress;

// A program that does not answer is given up where somebody wants an end, and no other one.
constexpr auto kIsSlow = std::chrono::milliseconds(500);

const char* name_of(Tell::Kind kind) {
  switch (kind) {
    case Tell::Kind::kStepStarted:
      return "step started";
    case Tell::Kind::kStepEnded:
      return "step ended";
    case Tell::Kind::kCommandStarted:
      return "command started";
    case Tell::Kind::kCommandEnded:
      return "command ended";
    case Tell::Kind::kMessage:
      return "message";
    case Tell::Kind::kWarning:
      return "warning";
    case Tell::Kind::kMissionEnded:
      return "mission ended";
  }
  return "message";
}

}  // namespace

WatchedRun::WatchedRun(std::shared_ptr<const MissionFile> file, std::unique_ptr<run::MissionRun> run,
                       const std::string& record)
    : file_(std::move(file)), run_(std::move(run)) {
  run_->set_observer([this](const mission::Effect& effect) { see(effect); });
  if (record.empty()) return;
  recorder_ = std::make_unique<history::Recorder>(
      [record] { return record; }, *run_,
      history::Circumstances{cli::kVersion, cli::overlay_folders(), run_->seed(),
                             cli::wall_clock().epoch_seconds});
}

WatchedRun::~WatchedRun() {
  end_recording();
}

void WatchedRun::see(const mission::Effect& effect) {
  if (recorder_) recorder_->see(effect);
  std::visit(base::Overloaded{
                 [&](const mission::effect::Ask& ask) { questions_[ask.question] = ask.text; },
                 [&](const mission::effect::Withdraw& gone) { questions_.erase(gone.question); },
                 [&](const Tell& told) {
                   said_.push_back({run_->time(), name_of(told.kind), told.text});
                   if (said_.size() > kMostSaid) said_.pop_front();
                 },
                 [](const auto&) {},
             },
             effect);
}

std::uint64_t WatchedRun::step(std::uint64_t cycles, const std::function<bool()>& wants_end,
                               const std::function<void()>& after) {
  auto began = std::chrono::steady_clock::now();
  run_->set_meanwhile([&] { return std::chrono::steady_clock::now() - began > kIsSlow && wants_end(); });
  std::uint64_t done = 0;
  for (; done < cycles && !wants_end(); ++done) {
    began = std::chrono::steady_clock::now();
    const Progress progress = run_->step();
    is_waiting_ = progress == Progress::kWaits;
    if (recorder_) progress == Progress::kStepped ? recorder_->note_cycle() : recorder_->note_rest();
    if (progress != Progress::kStepped) break;
    if (after) after();
  }
  run_->set_meanwhile({});
  return done;
}

void WatchedRun::answer(std::uint32_t question, bool proceed) {
  questions_.erase(question);
  note_input();
  run_->post(mission::event::Answer{question, proceed});
}

bool WatchedRun::order(const std::string& line, text::Diagnostics& sink) {
  const auto read = file_->read_line(line, *run_, sink);
  if (!read) return false;
  if (read->edited) {
    auto crew = file_->crew_after(*read, *run_, sink);
    if (!crew) return false;
    run_->edit(std::move(crew));
  }
  note_input();
  run_->post(mission::event::Typed{read->commands, line});
  return true;
}

std::string WatchedRun::end_recording() {
  if (!recorder_) return "";
  recorder_->end(
      run::outcome_name(*run_, run_->is_over() ? run::RunEnd::kByItself : run::RunEnd::kInterrupted));
  const auto ended = std::exchange(recorder_, nullptr);
  return ended->problem();
}

}  // namespace mlab::python
