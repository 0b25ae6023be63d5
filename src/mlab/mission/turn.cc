#include "mlab/mission/turn.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace mlab::mission {
namespace {

template <class Groups>
auto find_group_in(Groups& groups, std::uint32_t sequence) -> decltype(groups.data()) {
  const auto at = std::ranges::lower_bound(groups, sequence, {}, &Group::sequence);
  return at != groups.end() && at->sequence == sequence ? &*at : nullptr;
}

}  // namespace

void tell(Turn& turn, effect::Tell::Kind kind, std::string text, std::uint32_t owner, std::uint32_t command) {
  const State& s = turn.state;
  emit(turn, effect::Tell{kind, is_step(s, owner) ? s.step : kNoStep, command, std::move(text)});
}

Group* find_group(State& state, std::uint32_t sequence) {
  return find_group_in(state.groups, sequence);
}
const Group* find_group(const State& state, std::uint32_t sequence) {
  return find_group_in(state.groups, sequence);
}

const Run* order_of_robot(const State& state, base::RobotId id) {
  const RobotState* robot = find_robot(state, id);
  if (robot == nullptr || robot->run == kNoRun) return nullptr;
  const Run& run = state.runs[robot->run];
  return run.phase != Run::Phase::kEnded && !is_step(state, run.owner) ? &run : nullptr;
}

std::string owner_prefix(const State& state, std::uint32_t owner) {
  if (owner >= state.steps.size()) return {};
  const StepRecord& record = state.steps[owner];
  return record.step == kNoStep ? "typed: " : fmt::format("step {}: ", record.label);
}

}  // namespace mlab::mission
