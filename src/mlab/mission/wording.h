#pragma once

#include <string>
#include <string_view>

#include "mlab/mission/mission.h"
#include "mlab/mission/state.h"

namespace mlab::mission {

/// `MOVETO`, as missions write it.
std::string_view task_name(percept::Task task);
/// The unit's name, or `unit of robots 1, 2` where it has none.
std::string unit_name(const Mission& mission, std::uint32_t unit);

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
