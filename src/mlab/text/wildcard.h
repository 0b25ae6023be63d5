#pragma once

#include <string_view>

namespace mlab::text {

/// Whether a path matches a pattern, in which `*` stands for any number of characters. Takes time in
/// proportion to both lengths, whoever wrote the pattern.
bool matches(std::string_view path, std::string_view pattern);

}  // namespace mlab::text
