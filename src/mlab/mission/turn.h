#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
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
/// In place of an index into State::steps: of no step and no order.
inline constexpr std::uint32_t kNoOwner = std::numeric_limits<std::uint32_t>::max();

/// @param owner  index into State::steps: the step or the order of which something is told
void tell(Turn& turn, effect::Tell::Kind kind, std::string text, std::uint32_t owner = kNoOwner,
          std::uint32_t command = 0);
inline void message(Turn& turn, std::string text, std::uint32_t owner = kNoOwner) {
  tell(turn, effect::Tell::Kind::kMessage, std::move(text), owner);
}
inline void warn(Turn& turn, std::string text, std::uint32_t owner = kNoOwner) {
  tell(turn, effect::Tell::Kind::kWarning, std::move(text), owner);
}

/// Null where nobody is under that order any more.
Group* find_group(State& state, std::uint32_t sequence);
const Group* find_group(const State& state, std::uint32_t sequence);

/// True where the robot reported in the last cycle.
inline bool in_sight(const State& state, const RobotState& robot) {
  return robot.seen != 0 && robot.seen == state.cycle;
}

/// True where the step or order of this record is the step of the plan that runs.
inline bool is_step(const State& state, std::uint32_t owner) {
  return state.in_step && owner == state.step_record;
}
/// The run of an order of the operator that this robot is under; null where there is none.
const Run* order_of_robot(const State& state, base::RobotId id);
/// Whether a robot has said last that it can do no more of what its unit shares.
inline bool can_do_no_more(const RobotState& robot) {
  return robot.reported == robot.sequence && std::isinf(robot.best);
}
/// Where the run stands in State::runs.
inline std::uint32_t index_of(const State& state, const Run& run) {
  return static_cast<std::uint32_t>(&run - state.runs.data());
}

/// `step 3: `, `typed: `
///
/// @param owner  index into State::steps
std::string owner_prefix(const State& state, std::uint32_t owner);

}  // namespace mlab::mission
