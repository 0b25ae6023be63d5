#include "mlab/history/replay.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "mlab/history/digest.h"
#include "mlab/history/recorded_runner.h"

namespace mlab::history {
namespace {

constexpr const char* kElsewhere = "robots are not where they were when the run was written";

}  // namespace

std::unique_ptr<Replay> Replay::make(std::shared_ptr<const History> history, ReplayTools tools,
                                     text::Diagnostics& sink) {
  if (const std::string why = history->why_not_recomputed(); !why.empty()) {
    sink.error("not-recomputed", {}, fmt::format("the run can't be computed again: {}", why));
    return nullptr;
  }
  std::unique_ptr<Replay> out(new Replay(std::make_shared<Understood>(std::move(history), std::move(tools))));
  out->own(out->understood_->remaker().begin(sink));
  return out->run_ ? std::move(out) : nullptr;
}

std::unique_ptr<Replay> Replay::again() const {
  std::unique_ptr<Replay> out(new Replay(understood_));
  out->own(understood_->remaker().begin_again());
  return out;
}

std::unique_ptr<Replay> Replay::branch(std::shared_ptr<const History> history, std::size_t inputs) const {
  std::unique_ptr<Replay> out(new Replay(understood_->branch(std::move(history), inputs)));
  out->own(out->understood_->remaker().begin_again());
  return out;
}

void Replay::own(std::unique_ptr<run::MissionRun> run) {
  owned_ = std::move(run);
  run_ = owned_.get();
}

std::expected<Replay::Checkpoint, std::string> Replay::save() const {
  auto run = run_->save();
  if (!run) return std::unexpected(std::move(run.error()));
  return Checkpoint{std::move(*run), next_input_};
}

std::optional<std::string> Replay::restore(const Checkpoint& checkpoint) {
  if (auto problem = run_->restore(checkpoint.run)) return problem;
  const std::vector<MarkEntry>& marks = history().marks();
  next_input_ = checkpoint.inputs;
  next_mark_ = static_cast<std::size_t>(
      std::ranges::upper_bound(marks, run_->cycle(), {}, &MarkEntry::cycle) - marks.begin());
  next_answers_ = 0;
  is_at_end_ = false;
  divergence_.reset();
  return std::nullopt;
}

std::optional<std::string> Replay::why_not_understood(std::uint64_t cycle) const {
  const std::vector<InputEntry>& inputs = history().inputs();
  for (std::size_t i = 0; i < inputs.size() && inputs[i].moment.cycle <= cycle; ++i) {
    if (const Understood::One& input = understood_->input(i); !input) return input.error();
  }
  return std::nullopt;
}

bool Replay::part(std::string why) {
  divergence_ = Divergence{run_->cycle(), std::move(why)};
  return false;
}

bool Replay::take_inputs() {
  const std::vector<InputEntry>& inputs = history().inputs();
  for (; next_input_ < inputs.size() && inputs[next_input_].moment.cycle == run_->cycle(); ++next_input_) {
    const InputEntry& next = inputs[next_input_];
    if (next.moment.has_looked && !run_->moment().has_looked) run_->look();
    const Understood::One& input = understood_->input(next_input_);
    if (!input) return part(input.error());
    run_->take(*input);
  }
  return true;
}

// Answers that nobody asked for are not of this run.
bool Replay::look_at_answers() {
  const std::vector<AnswersEntry>& all = history().answers();
  const auto next = std::ranges::upper_bound(all, run_->cycle(), {}, &AnswersEntry::cycle) - all.begin();
  if (static_cast<std::size_t>(next) < next_answers_ || next == std::ssize(all)) return true;
  next_answers_ = static_cast<std::size_t>(next) + 1;
  for (const wire::HistoryAnswer& one : all[static_cast<std::size_t>(next)].answers.answers()) {
    const fleet::FleetRobot* const robot = run_->fleet().find({one.robot()});
    if (robot == nullptr || dynamic_cast<const RecordedRunner*>(robot->runner) == nullptr)
      return part(
          fmt::format("robot {} has answered, though it is none whose answers are recorded", one.robot()));
  }
  return true;
}

bool Replay::step() {
  if (divergence_ || is_at_end_) return false;
  if (!take_inputs()) return false;
  if (run_->cycle() >= history().last_cycle()) return finish();
  if (!look_at_answers()) return false;
  if (run_->step() != run::MissionRun::Progress::kStepped) {
    part("no more time passes, though it did when the run was written");
    divergence_->stands = true;
    return false;
  }
  compare();
  return !divergence_;
}

void Replay::settle() {
  if (divergence_ || !take_inputs()) return;
  if (!run_->moment().has_looked) run_->look();
}

bool Replay::finish() {
  const std::optional<EndEntry>& end = history().end();
  if (!end) return false;
  if (end->has_looked && !run_->moment().has_looked) run_->look();
  is_at_end_ = true;
  if (end->digest != digest_of(*run_)) return part(kElsewhere);
  ++equal_marks_;
  return false;
}

void Replay::compare() {
  const std::vector<MarkEntry>& marks = history().marks();
  for (; next_mark_ < marks.size() && marks[next_mark_].cycle <= run_->cycle(); ++next_mark_) {
    if (marks[next_mark_].cycle < run_->cycle()) continue;  // of cycle 0
    if (marks[next_mark_].digest != digest_of(*run_)) {
      part(kElsewhere);
      return;
    }
    ++equal_marks_;
  }
}

}  // namespace mlab::history
