#pragma once

#include <span>

#include "mlab/robot/process/robot_main.h"

namespace mlab::robot_process {

/// The arguments want an executable to take part in a fleet.
bool names_fleet(std::span<char* const> arguments);

/// Becomes `mlab-agent`, which offers this executable to the runs of a fleet. It is looked for where
/// `MLAB_AGENT` says, in the folders of `PATH`, and where the program was made.
/// @param arguments  of the command line, for `mlab-agent`
/// @return  the exit status, where it can't
int become_member(const RobotProgramText& text, std::span<char* const> arguments);

}  // namespace mlab::robot_process
