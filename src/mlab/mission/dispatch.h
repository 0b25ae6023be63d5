#pragma once

#include <memory>
#include <vector>

#include "mlab/mission/turn.h"

namespace mlab::mission {

/// Starts commands together, in their order: orders go out, SET, PRINT and QUIT act at once. Nothing is
/// completed yet.
///
/// @param owner  keeps `commands` alive as long as an order of them stands
void begin_commands(Turn& turn, const std::vector<Command>& commands,
                    const std::shared_ptr<const void>& owner);

/// Puts the group's members under a new order, whose sequence is given here.
/// @return  the sequence
std::uint32_t give_order(Turn& turn, Group group);
/// Halts the group, or lets it go on; nothing is sent where that is so already.
void set_halted(Turn& turn, Group& group, bool halted);
/// The standing order of a group, as robots get it.
effect::Order order_of(const Group& group);

/// Stops the robot, out of every order.
void stop_robot(Turn& turn, RobotState& robot);

/// Groups that lost robots to other orders are told who is left; empty ones end.
void repair_groups(Turn& turn);

}  // namespace mlab::mission
