#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "mlab/text/files.h"

namespace mlab::odl {

/// Where a file that an overlay names is: beside `near_path`, or in the current directory. Nothing
/// where `files` has neither.
std::optional<std::string> find_companion(std::string_view name, const std::string& near_path,
                                          const text::Files& files);

}  // namespace mlab::odl
