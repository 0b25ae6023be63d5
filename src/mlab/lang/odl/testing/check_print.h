#pragma once

#include <string>
#include <string_view>

namespace mlab::odl {

/// For tests and fuzzers: parses, prints, parses again and compares. For a text without errors the second
/// print is the same as the first, the comments are the same and so is the overlay that both mean.
/// @return what differs, or empty
std::string what_print_changes(std::string_view text, bool& had_errors);

}  // namespace mlab::odl
