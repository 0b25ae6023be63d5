#pragma once

#include <string>
#include <string_view>

namespace mlab::console {

/// The content type of a picture that browsers show, told by its first bytes; empty: it is none.
std::string picture_type(std::string_view bytes);

}  // namespace mlab::console
