#pragma once

#include <string>

namespace mlab::cli {

/// Where runs of a project are recorded without being asked for; empty: nowhere, since nothing is kept.
/// @param project  its folder
std::string runs_folder(const std::string& project);

}  // namespace mlab::cli
