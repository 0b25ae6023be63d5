#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mlab/mission/turn.h"

namespace mlab::mission {

/// Starts that step of the plan; the index is in range.
void begin_step(Turn& turn, std::uint32_t step);
/// Starts typed commands in place of a step.
void begin_typed(Turn& turn, const std::vector<Command>& commands);

/// Ends commands and steps that have nothing left to wait for, and starts steps, until something is waited
/// for.
void go_on(Turn& turn);

/// Writes a command's end into the history and tells it.
void end_command(Turn& turn, std::uint32_t record, Outcome outcome, const std::string& why);
/// The run has what it waits for.
void complete(Turn& turn, Run& run);
/// The run can't be completed: it and the mission have failed.
void fail(Turn& turn, Run& run, const std::string& why);

/// Ends the step that runs, if any. Its commands that are not done end with the same outcome; with kReplaced
/// only those that lose robots to others, `taken` in ascending order, and the rest is skipped.
void abandon_step(Turn& turn, Outcome outcome, const std::vector<base::RobotId>& taken = {});
/// Stops every robot, goes back to the first step (the ABORT button).
void abort_mission(Turn& turn);
void quit(Turn& turn);
void end_mission(Turn& turn, Outcome outcome, const std::string& text);

}  // namespace mlab::mission
