#pragma once

#include <string>

#include "mlab/cli/commands.h"

// Commands that messages tell a person to use, and names that a person gives.
namespace mlab::cli {

/// The options that a command on this machine needs to reach the same fleet, each with a blank in front:
/// ` --network eth0 --secure`. What a shell would take for something else is quoted.
std::string fleet_options(const NetworkOptions& options);

/// The same for a command on another machine, which has an address and an identity of its own.
std::string fleet_options_elsewhere(const NetworkOptions& options);

/// The command that releases the emergency stop of the fleet from here.
std::string release_command(const NetworkOptions& options);

/// Where a fleet has nobody: what starts somebody, or shows him, as a sentence.
std::string nobody_is_there(const std::string& fleet, const NetworkOptions& options);

/// Where nobody is seen: who may be there nevertheless, and which options show him, with `; ` in front;
/// empty: nobody.
std::string who_is_not_seen(const NetworkOptions& options);

/// Why this can't be the name of a fleet, or of an agent in it, as option parsers take it; empty: it can.
std::string refuse_unless_name(const std::string& text);

}  // namespace mlab::cli
