#pragma once

#include <string>

#include "mlab/comparison/comparison.h"

namespace mlab::comparison {

/// All that a comparison says, for a terminal.
std::string report_of(const Comparison& comparison);

/// The same for a program: JSON, indented, ending with a newline. docs/recording.md has its fields.
std::string json_of(const Comparison& comparison);

/// One HTML page with plots: it needs nothing else, loads nothing, and has no scripts.
/// @param program_version  of who wrote it
std::string page_of(const Comparison& comparison, const std::string& program_version);

}  // namespace mlab::comparison
