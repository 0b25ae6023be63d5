#pragma once

#include <string_view>
#include <vector>

namespace mlab::text {

/// The lines of a text, each with its end. They point into it.
std::vector<std::string_view> lines_of(std::string_view text);

/// For each line of `base` the line of `other` that it is still, or -1. As many as can be are kept, in their
/// order; where more than a thousand are not, none is.
std::vector<int> kept_lines(const std::vector<std::string_view>& base,
                            const std::vector<std::string_view>& other);

}  // namespace mlab::text
