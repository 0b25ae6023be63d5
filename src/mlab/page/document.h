#pragma once

#include <string>
#include <string_view>

namespace mlab::page {

/// A sentence as markup: what stands between two backticks in it is shown as code.
std::string prose(std::string_view sentence);

/// One HTML page that needs nothing else, loads nothing, and has no scripts.
/// @param title  as it is, no markup
/// @param body   markup that stands below the title
std::string document(std::string_view title, std::string_view body);

}  // namespace mlab::page
