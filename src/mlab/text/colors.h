#pragma once

#include <string>

#include "mlab/text/diagnostic.h"

namespace mlab::text {

/// As `render`, with the level, carets and hints in colours, by the escape sequences of terminals.
std::string render_in_colors(const Diagnostic& diagnostic);
std::string render_in_colors(const Diagnostics& diagnostics);

}  // namespace mlab::text
