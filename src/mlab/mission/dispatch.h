#pragma once

#include <memory>
#include <vector>

#include "mlab/mission/turn.h"

namespace mlab::mission {

/// Starts commands together, in their order: orders go out, SET, PRINT and QUIT act at once. Nothing is
/// completed yet.
///
/// @param keeper  keeps `commands` alive as long as an order of them stands
/// @param owner   index into State::steps: the step or the order that they belong to, the last one there
void begin_commands(Turn& turn, const std::vector<Command>& commands,
                    const std::shared_ptr<const void>& keeper, std::uint32_t owner);
/// Commands of the plan that waited for orders of the operator begin where the orders are over. @return
/// whether one did
bool begin_held(Turn& turn);

/// Robots that did not run as a command began, and run now, take part in it from here on, with the last of
/// its parts.
void take_in(Turn& turn, Run& run);

/// Puts the group's members under a new order, whose sequence is given here.
/// @return  the sequence
std::uint32_t give_order(Turn& turn, Group group);
/// Halts the group, or lets it go on; nothing is sent where that is so already.
void set_halted(Turn& turn, Group& group, bool halted);
/// All parts of the run halt, for good.
void halt(Turn& turn, Run& run);
/// The standing order of a group, as robots get it.
effect::Order order_of(const Group& group);

/// Stops the robot, out of every order.
void stop_robot(Turn& turn, RobotState& robot);

/// Groups that lost robots to other orders are told who is left; empty ones end.
void repair_groups(Turn& turn);

}  // namespace mlab::mission
