#pragma once

#include <string>
#include <string_view>

namespace mlab::text {

/// Whether every line ends in one CR and LF, as DOS and its successors write them. Of no line: false.
bool has_dos_lines(std::string_view text);

/// For work: with LF where every line ended in CR LF; a text of mixed line ends as it is.
std::string unix_lines(std::string text);

/// For writing: a text of `unix_lines` with the line ends of what stands in its place.
std::string lines_as_in(std::string_view old, std::string text);

}  // namespace mlab::text
