#pragma once

#include <string>
#include <system_error>

namespace mlab::cell {

/// Gives a file the name under which everybody looks for it, unless one of that name is there already: two
/// processes may make the same thing at the same time. Landlock knows files, not names: replacing one would
/// take it away from a cell that was just handed it.
/// @param from  on the same file system; may or may not be there afterwards
/// @return  why the name could not be given
[[nodiscard]] std::error_code keep_first(const std::string& from, const std::string& name);

}  // namespace mlab::cell
