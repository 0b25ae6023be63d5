#pragma once

#include <string>
#include <string_view>

namespace mlab::page {

/// One HTML page that needs nothing else, loads nothing, and has no scripts.
/// @param title  as it is, no markup
/// @param body   markup that stands below the title
std::string document(std::string_view title, std::string_view body);

}  // namespace mlab::page
