#pragma once

#include <string>
#include <string_view>

namespace mlab::designer {

/// What a text without a file is called: the file that it was imported from, what it declares, or that it is
/// new.
std::string unsaved_title(std::string_view text);

/// What a configuration is for: the first sentence of the comment that it begins with, at most some 140
/// letters; empty where it begins with none.
/// @param text  its beginning is enough
std::string said_of(std::string_view text);

}  // namespace mlab::designer
