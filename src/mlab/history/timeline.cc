#include "mlab/history/timeline.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <utility>

#include <fmt/core.h>

namespace mlab::history {
namespace {

// Checkpoints may take up a quarter of the way to where somebody looks.
constexpr double kLeastOfWay = 4.0;

class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

std::string text_of(const Divergence& divergence) {
  return fmt::format("the run can't be computed beyond cycle {}: {}", divergence.cycle, divergence.why);
}

}  // namespace

Timeline::Timeline(std::unique_ptr<Replay> front, const Settings& settings)
    : settings_(settings), front_(std::move(front)), shown_(front_->again()), kept_(settings.most_bytes) {
  lay(*front_);
}

std::unique_ptr<Timeline> Timeline::make(std::shared_ptr<const History> history, ReplayTools tools,
                                         const Settings& settings, text::Diagnostics& sink) {
  auto front = Replay::make(std::move(history), std::move(tools), sink);
  if (!front) return nullptr;
  return std::unique_ptr<Timeline>(new Timeline(std::move(front), settings));
}

Timeline::Fork Timeline::fork(std::shared_ptr<const History> other, std::uint64_t cycle) const {
  const Replay::Checkpoint* const kept = kept_.before(cycle);
  Fork out{front_->again(), front_->branch(other, kept == nullptr ? 0 : kept->inputs)};
  if (kept == nullptr || (!out.own->restore(*kept) && !out.other->restore(*kept))) return out;
  return {front_->again(), front_->branch(std::move(other), 0)};
}

void Timeline::lay(const Replay& replay) {
  if (!why_slow_.empty() || kept_.has(replay.run().cycle())) return;
  const Stopwatch watch;
  auto checkpoint = replay.save();
  if (!checkpoint) {
    why_slow_ = std::move(checkpoint.error());
    return;
  }
  kept_.add(*checkpoint);
  cost_of_save_ = watch.seconds();
}

bool Timeline::step_front() {
  const Stopwatch watch;
  if (!front_->step()) return false;
  if (watcher_) watcher_(front_->run());
  since_laid_ += watch.seconds();
  if (since_laid_ >= std::max(settings_.spacing, cost_of_save_ / settings_.most_share)) {
    lay(*front_);
    since_laid_ = 0.0;
  }
  return true;
}

bool Timeline::advance(double seconds) {
  const Stopwatch watch;
  do {
    if (!step_front()) return false;
  } while (watch.seconds() < seconds);
  return known_to() < history().last_cycle();
}

std::optional<std::string> Timeline::go_to(std::uint64_t cycle) {
  cycle = std::min(cycle, history().last_cycle());
  while (known_to() < cycle) {
    if (step_front()) continue;
    if (divergence()) return text_of(*divergence());
    break;
  }
  if (auto problem = go_back_before(cycle)) return problem;
  return replay_to(cycle);
}

// To the last moment up to the cycle that is known, unless the run is nearer already.
std::optional<std::string> Timeline::go_back_before(std::uint64_t cycle) {
  const std::uint64_t here = shown_->run().cycle();
  const bool is_on_the_way = is_between_ ? here <= cycle : here < cycle;
  const Replay::Checkpoint* const kept = kept_.before(cycle);
  if (kept == nullptr) {
    if (is_on_the_way) return std::nullopt;
    shown_ = front_->again();
  } else if (!is_on_the_way || kept->run.cycle() > here) {
    if (auto problem = shown_->restore(*kept)) return problem;
  }
  is_between_ = true;
  return std::nullopt;
}

// Lays checkpoints half the way to the cycle, three quarters of it, and so on: whoever has a look at one
// moment next looks at those just before.
std::optional<std::string> Timeline::replay_to(std::uint64_t cycle) {
  kept_.look_at(cycle);
  double since_laid = 0.0;
  while (shown_->run().cycle() < cycle) {
    const Stopwatch watch;
    if (!shown_->step()) {
      is_between_ = false;
      return shown_->divergence() ? text_of(*shown_->divergence()) : "the history ends before";
    }
    is_between_ = true;
    since_laid += watch.seconds();
    const std::uint64_t left = cycle - shown_->run().cycle();
    if (!std::has_single_bit(left) || since_laid < kLeastOfWay * cost_of_save_) continue;
    lay(*shown_);
    since_laid = 0.0;
  }
  return std::nullopt;
}

std::optional<std::string> Timeline::go_to_end() {
  if (auto problem = go_to(history().last_cycle())) return problem;
  is_between_ = false;
  static_cast<void>(shown_->step());
  if (shown_->divergence()) return text_of(*shown_->divergence());
  return std::nullopt;
}

}  // namespace mlab::history
