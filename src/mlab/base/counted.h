#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace mlab::base {

/// `1 robot`, `3 robots`: in texts for people.
/// @param noun  that takes an s
inline std::string counted(std::size_t count, std::string_view noun) {
  return std::to_string(count).append(" ").append(noun).append(count == 1 ? "" : "s");
}

}  // namespace mlab::base
