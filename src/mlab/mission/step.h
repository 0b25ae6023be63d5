#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mlab/mission/turn.h"

namespace mlab::mission {

/// Starts that step of the plan; the index is in range and no step runs.
void begin_step(Turn& turn, std::uint32_t step);
/// Starts an order of the operator, beside whatever runs.
void begin_order(Turn& turn, const std::vector<Command>& commands);

/// Ends commands, orders and steps that have nothing left to wait for, lets commands begin that waited for
/// orders, and starts steps, until something is waited for.
void go_on(Turn& turn);

/// Writes a command's end into the history and tells it.
///
/// @param owner  index into State::steps: of which step or order it is
void end_command(Turn& turn, std::uint32_t owner, std::uint32_t record, Outcome outcome,
                 const std::string& why, Failure failure = Failure::kNone);
/// The run ends, however: nobody is asked for it any more.
void end_run(Turn& turn, Run& run, Outcome outcome, const std::string& why = {},
             Failure failure = Failure::kNone);
/// The run has what it waits for.
void complete(Turn& turn, Run& run);
/// The run can't be completed. In a step that fails the step and the mission; an order's other commands go
/// on.
void fail(Turn& turn, Run& run, Failure failure, const std::string& why);

/// Ends the step that runs, if any. Its commands that are not done end with the same outcome; orders go on.
void abandon_step(Turn& turn, Outcome outcome);
/// No step is left: the mission is done, or will be when the orders are over.
void end_plan(Turn& turn);
/// Stops every robot, ends all orders, goes back to the first step (the ABORT button).
void abort_mission(Turn& turn);
void quit(Turn& turn);
/// The mission is over; orders that are under way go on.
void end_mission(Turn& turn, Outcome outcome, const std::string& text);
/// Running where a step or an order is under way, else idle.
void rest(Turn& turn);

}  // namespace mlab::mission
