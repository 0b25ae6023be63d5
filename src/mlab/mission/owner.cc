#include "mlab/mission/owner.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "mlab/mission/question.h"

namespace mlab::mission {
namespace {

std::span<const CommandRecord> records_of(const State& state, std::uint32_t owner) {
  const StepRecord& record = state.steps[owner];
  return std::span(state.commands).subspan(record.first_command, record.command_count);
}

bool any_ended(const State& state, std::uint32_t owner, Outcome outcome) {
  return std::ranges::any_of(records_of(state, owner),
                             [&](const CommandRecord& c) { return c.outcome == outcome; });
}

// Who was in them waits for nobody, and the runs behind them move up.
void remove_runs(State& state, std::uint32_t owner) {
  const std::span<const Run> gone = runs_of(state, owner);
  if (gone.empty()) return;
  const std::uint32_t begin = index_of(state, gone.front());
  const auto count = static_cast<std::uint32_t>(gone.size());
  for (RobotState& robot : state.robots) {
    if (robot.run == kNoRun || robot.run < begin) continue;
    robot.run = robot.run < begin + count ? kNoRun : robot.run - count;
  }
  for (Question& question : state.questions) {
    if (question.robot.value == 0 && question.run >= begin) question.run -= count;
  }
  const auto first = state.runs.begin() + static_cast<std::ptrdiff_t>(begin);
  state.runs.erase(first, first + static_cast<std::ptrdiff_t>(count));
}

}  // namespace

std::uint32_t open_owner(Turn& turn, std::string label, std::uint32_t step) {
  State& s = turn.state;
  StepRecord record;
  record.label = std::move(label);
  record.step = step;
  record.start = record.end = s.time;
  record.first_command = static_cast<std::uint32_t>(s.commands.size());
  s.steps.push_back(std::move(record));
  return static_cast<std::uint32_t>(s.steps.size()) - 1;
}

void close_owner(Turn& turn, std::uint32_t owner, Outcome outcome) {
  State& s = turn.state;
  s.steps[owner].outcome = outcome;
  s.steps[owner].end = s.time;
  std::string text = fmt::format("{} {}", owner_text(s, owner), name(outcome));
  if (outcome == Outcome::kDone && any_ended(s, owner, Outcome::kReplaced))
    text += any_ended(s, owner, Outcome::kDone) ? " as far as orders left it" : ": orders took all of it";
  remove_runs(s, owner);
  tell(turn, effect::Tell::Kind::kStepEnded, std::move(text), owner);
  if (is_step(s, owner)) s.in_step = false;
}

std::span<const Run> runs_of(const State& state, std::uint32_t owner) {
  const auto first = std::ranges::find(state.runs, owner, &Run::owner);
  const auto last = std::find_if(first, state.runs.end(), [&](const Run& run) { return run.owner != owner; });
  return {first, last};
}

Outcome outcome_of_order(const State& state, std::uint32_t owner) {
  if (any_ended(state, owner, Outcome::kFailed)) return Outcome::kFailed;
  return any_ended(state, owner, Outcome::kDone) ? Outcome::kDone : Outcome::kReplaced;
}

std::string owner_text(const State& state, std::uint32_t owner) {
  const StepRecord& record = state.steps[owner];
  return record.step == kNoStep ? "typed commands" : fmt::format("step {}", record.label);
}

}  // namespace mlab::mission
