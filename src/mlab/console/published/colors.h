#pragma once

#include <string>
#include <string_view>

namespace mlab::console {

/// An X11 colour name as `#rrggbb`; `#rgb` and `#rrggbb` stand for themselves, whatever else is blue. Spaces,
/// hyphens and letter case do not count.
std::string rgb_of(std::string_view color);

}  // namespace mlab::console
