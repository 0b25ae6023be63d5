#pragma once

#include <expected>
#include <memory>
#include <string>
#include <vector>

#include "mlab/agents/roster.h"
#include "mlab/agents/stop_switch.h"
#include "mlab/run/stop_line.h"

namespace mlab::cli {

/// The emergency stop of a fleet, for a run.
/// @param by        what others call it: `run patrol on base`
/// @param identity  folder of the identity that it takes part with; empty: the fleet is not secured. That
///                  somebody was withdrawn from the fleet is an alert: who has joined trusts whom it
///                  trusted then
/// @errors  a sentence
std::expected<std::shared_ptr<run::StopLine>, std::string> fleet_stop_line(
    std::shared_ptr<agents::Roster> roster, std::string by, const std::string& identity);

/// What is said behind the name of an agent that has not confirmed: how long nothing has been heard of it,
/// and who knows of it where it was never heard here. Empty: it was heard just now.
std::string about_unreached(const std::string& by, double silent);

/// What is said of agents that would forget the stop; empty: there are none.
std::string about_forgetful(const std::vector<agents::StopSwitch::Forgetful>& agents);

/// What is said of names that two agents have, as long as both are there; empty: there are none.
std::string about_doubles(const std::vector<agents::Member>& members);

/// What is said of those who are there, and of another version than this program; empty: there are none.
std::string about_versions(const std::vector<agents::Member>& members);

/// Who pulls it from here: the machine's name.
std::string stopping_person();

}  // namespace mlab::cli
