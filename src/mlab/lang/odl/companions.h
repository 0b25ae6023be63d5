#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace mlab::odl {

/// Where a file that an overlay names is: beside `near_path`, or in the current directory. Only regular files
/// count, so that a name like `/dev/stdin` never makes a reader wait.
std::optional<std::string> find_companion(std::string_view name, const std::string& near_path);

}  // namespace mlab::odl
