#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace mlab::text {

/// A piece of a source as a message shows it: cut after `most` characters, control characters and bytes that
/// are not UTF-8 as `\x1b`, so that it can stand on one line of a terminal and in JSON.
std::string shown(std::string_view piece, std::size_t most = 40);

}  // namespace mlab::text
