#pragma once

#include <string>

namespace mlab::cnl {

/// Makes a folder below `folder` for one compilation alone, so that two that build the same do not disturb
/// each other, and what the compiler may write is not what others read. Whoever makes it removes it; those of
/// processes that were ended before they could are removed here.
/// @param key  what is compiled: the start of its name
/// @return  its path; where it could not be made, nothing can be written there
std::string make_compile_folder(const std::string& folder, const std::string& key);

}  // namespace mlab::cnl
