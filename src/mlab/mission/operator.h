#pragma once

#include "mlab/mission/event.h"
#include "mlab/mission/turn.h"

namespace mlab::mission {

/// What the operator does: one function for each event that is his.
void handle(Turn& turn, const event::Execute& event);
void handle(Turn& turn, const event::Pause& event);
void handle(Turn& turn, const event::Resume& event);
void handle(Turn& turn, const event::SingleStep& event);
void handle(Turn& turn, const event::StopAfterStep& event);
void handle(Turn& turn, const event::Jump& event);
void handle(Turn& turn, const event::Rewind& event);
void handle(Turn& turn, const event::Abort& event);
void handle(Turn& turn, const event::Answer& event);
void handle(Turn& turn, const event::RobotAsks& event);
void handle(Turn& turn, const event::Typed& event);
void handle(Turn& turn, const event::Edited& event);
void handle(Turn& turn, const event::TeleoperationComplete& event);

}  // namespace mlab::mission
