#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "mlab/mission/turn.h"

/// What owns the commands that run: the step of the plan, and every order of the operator. Each has one
/// record in State::steps, and its runs stand together in State::runs.
namespace mlab::mission {

/// Writes the beginning into the history. @return  the owner: an index into State::steps
std::uint32_t open_owner(Turn& turn, std::string label, std::uint32_t step);
/// Writes the end into the history and tells it; all runs of it have ended, and leave the state.
void close_owner(Turn& turn, std::uint32_t owner, Outcome outcome);

/// None where it has no unit command.
std::span<const Run> runs_of(const State& state, std::uint32_t owner);
inline bool has_ended(const Run& run) {
  return run.phase == Run::Phase::kEnded;
}

/// What became of an order all of whose commands have ended: failed where one failed, else done where one
/// was.
Outcome outcome_of_order(const State& state, std::uint32_t owner);
/// `step 3`, `typed commands`
std::string owner_text(const State& state, std::uint32_t owner);

}  // namespace mlab::mission
