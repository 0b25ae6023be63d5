#pragma once

#include <expected>
#include <string>

#include "mlab/cli/commands.h"
#include "mlab/journal/journal_folder.h"

namespace mlab::cli {

/// Where the consoles of a project keep journals; empty: nowhere.
/// @param project  its folder
std::string journal_folder(const std::string& project);

/// The newest run that did not end: of the mission that is named, else of the project, else of a project
/// below this folder.
/// @errors  a sentence: there is none
std::expected<journal::Unfinished, std::string> find_resumable(const RunOptions& options);
/// The file of its mission on this machine; empty: there is none any more.
std::string mission_file(const journal::Unfinished& run);
/// Neither is the file of its mission there, nor what was not saved of it.
bool is_mission_gone(const journal::Unfinished& run);

}  // namespace mlab::cli
