#pragma once

#include <string>
#include <string_view>

#include "mlab/mission/mission.h"
#include "mlab/mission/state.h"

namespace mlab::mission {

/// `MOVETO`, as missions write it.
std::string_view task_name(Task task);
/// The unit's name, or `unit of robots 1, 2` where it has none.
std::string unit_name(const Mission& mission, std::uint32_t unit);

/// Robots by all their ids, as a name for them: `robot 3`, `robots 1-4, 7`.
std::string robots_name(const std::vector<base::RobotId>& robots);
/// Whom a command is for: the unit's name, or the robots'.
std::string addressee(const Mission& mission, const UnitCommand& command);
/// Whom a run is for, in a sentence: `unit scouts`, `robots 1-4, 7`.
std::string addressee(const State& state, const Run& run);
/// It takes the verb's singular: a unit, or one robot.
bool is_one(const Run& run);

/// How the command is called in every text for people: `unit scouts OCCUPY ATK-AP1 (Diamond)`.
std::string command_text(const Mission& mission, const Command& command);
/// The record of a command that starts now.
CommandRecord record_of(const Mission& mission, const Command& command, double time);

/// Robots by their ids: `robot 3`, `robots 1, 2, 5 and 20 more`.
std::string robots_text(const std::vector<base::RobotId>& robots);
/// Who of a command is not done, where, how far from done and why, as far as the executive knows.
std::string undone_text(const State& state, const Run& run);
/// What a command waits for: `3 of 4 robots`, `Proceed?`.
std::string waiting_text(const State& state, const Run& run);

}  // namespace mlab::mission
