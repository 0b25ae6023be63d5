#pragma once

#include <memory>
#include <string>
#include <vector>

#include "mlab/mission/effect.h"
#include "mlab/mission/event.h"
#include "mlab/mission/mission.h"
#include "mlab/mission/state.h"

namespace mlab::mission {

struct Advance {
  State state;
  std::vector<Effect> effects;  ///< in the order in which they are to happen
};

/// The executive before its first event: at the first step, nothing started.
///
/// @param mission  not null
State initial_state(std::shared_ptr<const Mission> mission, const ExecutiveOptions& options = {});

/// What one event changes. A pure function: the same state and event always give the same. Move the state in:
/// a cycle in which nothing happens then costs one look at each robot and no allocation.
///
/// @errors  none; events that make no sense (an unknown question, a step that isn't there, time that runs
/// backwards)
///          change nothing or are answered with a warning
Advance advance(State state, const Event& event);
/// The same, for who has no use for the state before.
std::vector<Effect> advance_in_place(State& state, const Event& event);

/// Up to then all robots were held by somebody else (an emergency stop): no command is behind because of that
/// time.
///
/// @param time  of the run [s]; earlier than the state's: changes nothing
void hold_until(State& state, double time);

/// True where nothing but the operator's answer can move the mission on: no robot has anything left to do and
/// no question answers itself. With speed `max` simulated time then stands still.
bool awaits_only_operator(const State& state);

/// What a running mission waits for, one line for each command that is not done: `unit scouts MOVETO
/// PP-Charlie: 3 of 4 robots`. Empty when nothing runs.
std::vector<std::string> waits_for(const State& state);

/// All orders in force, for a robot side that was started anew while the mission went on.
std::vector<effect::Order> standing_orders(const State& state);

}  // namespace mlab::mission
