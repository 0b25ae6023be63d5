#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace mlab::study {

/// Where TOML can't have a character beyond ASCII: the first that stands neither in a comment nor in quotes,
/// or that follows a `\` and white space in a text of several lines. toml++ 3.3 must not be given such a
/// text: what it does with it is undefined.
/// @return its place [bytes]; nothing where there is none
std::optional<std::size_t> stray_character(std::string_view text);

}  // namespace mlab::study
