#pragma once

#include <expected>
#include <memory>
#include <string>

#include "mlab/agents/roster.h"
#include "mlab/run/stop_line.h"

namespace mlab::cli {

/// The emergency stop of a fleet, for a run.
/// @errors  a sentence
std::expected<std::shared_ptr<run::StopLine>, std::string> fleet_stop_line(
    std::shared_ptr<agents::Roster> roster);

/// Who pulls it from here: the machine's name.
std::string stopping_person();

}  // namespace mlab::cli
