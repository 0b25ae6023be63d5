#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mlab::cdl {

/// What lines of help say together: an empty line starts a paragraph.
///
/// @param comments  with their `///`, `///<`
std::string help_of(const std::vector<std::string_view>& comments);

/// Help as lines with `///`.
std::vector<std::string> help_lines(std::string_view help);
/// Help as it stands behind a parameter, on one line with `///<`.
std::string help_behind(std::string help);

}  // namespace mlab::cdl
