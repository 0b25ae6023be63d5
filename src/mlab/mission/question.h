#pragma once

#include <cstddef>
#include <cstdint>

#include "mlab/mission/turn.h"

namespace mlab::mission {

/// The unit is in place: asks whether it may proceed, or completes the run where nobody has to be asked
/// (UNTIL has come, or every question is answered with yes).
void ask_to_proceed(Turn& turn, Run& run);
/// The unit waits at a phase line for the acknowledgement of its message.
void ask_to_acknowledge(Turn& turn, Run& run, std::uint32_t phase_line);

/// The robot's program asks whether it may go on. Its question outlives the step, as its program does.
void ask_for_robot(Turn& turn, base::RobotId robot);
/// The robot's program runs no longer: nobody waits for the answer.
void withdraw_of(Turn& turn, base::RobotId robot);

/// The run is over: nobody waits for answers to its questions.
void withdraw_of(Turn& turn, const Run& run);

/// The operator's answer; an unknown question is ignored.
void answer(Turn& turn, std::uint32_t question, bool proceed);
/// Questions whose time has come answer themselves with yes.
void expire_questions(Turn& turn);
/// Takes back the question at this place of State::questions.
void withdraw(Turn& turn, std::size_t index);

}  // namespace mlab::mission
