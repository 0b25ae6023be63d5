#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace mlab::text {

/// The longest name of a fleet's member [bytes].
inline constexpr std::size_t kMostInMemberName = 64;

/// What such a name may be, as messages say it.
inline constexpr std::string_view kMemberNameRule =
    "1 to 64 letters, digits, `-`, `_` and `.`, not dots alone";

/// Whether members of a fleet (agents, vehicles) can have this name: it stands in the names of topics and
/// files.
inline bool is_member_name(std::string_view name) {
  const auto is_fit = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || c == '.';
  };
  const bool is_dots = name.find_first_not_of('.') == std::string_view::npos;  // also where it is empty
  return !is_dots && name.size() <= kMostInMemberName && std::ranges::all_of(name, is_fit);
}

}  // namespace mlab::text
