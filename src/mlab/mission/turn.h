#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "mlab/mission/effect.h"
#include "mlab/mission/state.h"

namespace mlab::mission {

/// One call of `advance` at work: the state that it changes, and what it wants to happen. Inside the module
/// only.
struct Turn {
  State& state;
  std::vector<Effect>& effects;
  double elapsed = 0.0;               ///< since the cycle before; 0 for other events [s]
  std::vector<std::uint32_t> shrunk;  ///< sequences of groups that lost robots to another order
};

template <class T>
void emit(Turn& turn, T effect) {
  turn.effects.emplace_back(std::in_place_type<T>, std::move(effect));
}
void tell(Turn& turn, effect::Tell::Kind kind, std::string text, std::uint32_t command = 0);
inline void message(Turn& turn, std::string text) {
  tell(turn, effect::Tell::Kind::kMessage, std::move(text));
}
inline void warn(Turn& turn, std::string text) {
  tell(turn, effect::Tell::Kind::kWarning, std::move(text));
}

/// Null where the mission has no robot of that id.
RobotState* find_robot(State& state, base::RobotId id);
const RobotState* find_robot(const State& state, base::RobotId id);
/// Null where nobody is under that order any more.
Group* find_group(State& state, std::uint32_t sequence);
const Group* find_group(const State& state, std::uint32_t sequence);

/// True where the robot reported in the last cycle.
inline bool in_sight(const State& state, const RobotState& robot) {
  return robot.seen != 0 && robot.seen == state.cycle;
}

/// `step 3: `, `typed: `
std::string step_prefix(const State& state);

}  // namespace mlab::mission
