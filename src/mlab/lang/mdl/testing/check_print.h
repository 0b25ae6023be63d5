#pragma once

#include <string>
#include <string_view>

namespace mlab::mdl {

/// For tests and fuzzers: parses, prints, parses again and compares. For a text without errors the second
/// print is the same as the first, no comment is lost, and the words are the same but for the spellings that
/// mean the same.
///
/// @return what differs, or empty
std::string what_print_changes(std::string_view text, bool& had_errors);

}  // namespace mlab::mdl
