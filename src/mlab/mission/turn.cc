#include "mlab/mission/turn.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace mlab::mission {
namespace {

template <class Robots>
auto find_robot_in(Robots& robots, base::RobotId id) -> decltype(robots.data()) {
  // Ids are dense from 1 in every mission that was not edited: try that first.
  const std::size_t guess = std::size_t{id.value} - 1;
  if (guess < robots.size() && robots[guess].id == id) return &robots[guess];
  const auto at = std::ranges::lower_bound(robots, id, {}, &RobotState::id);
  return at != robots.end() && at->id == id ? &*at : nullptr;
}

template <class Groups>
auto find_group_in(Groups& groups, std::uint32_t sequence) -> decltype(groups.data()) {
  const auto at = std::ranges::lower_bound(groups, sequence, {}, &Group::sequence);
  return at != groups.end() && at->sequence == sequence ? &*at : nullptr;
}

}  // namespace

void tell(Turn& turn, effect::Tell::Kind kind, std::string text, std::uint32_t command) {
  const State& s = turn.state;
  const bool in_step = s.mode == State::Mode::kRunning && !s.typed;
  emit(turn, effect::Tell{kind, in_step ? s.step : kNoStep, command, std::move(text)});
}

RobotState* find_robot(State& state, base::RobotId id) {
  return find_robot_in(state.robots, id);
}
const RobotState* find_robot(const State& state, base::RobotId id) {
  return find_robot_in(state.robots, id);
}
Group* find_group(State& state, std::uint32_t sequence) {
  return find_group_in(state.groups, sequence);
}
const Group* find_group(const State& state, std::uint32_t sequence) {
  return find_group_in(state.groups, sequence);
}

std::string step_prefix(const State& state) {
  if (state.typed) return "typed: ";
  if (state.step >= state.mission->steps.size()) return {};
  return fmt::format("step {}: ", state.mission->steps[state.step].label);
}

}  // namespace mlab::mission
