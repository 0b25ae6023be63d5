#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace mlab::documents {

/// Two changes of the same text as one: by lines, as `diff3` does.
/// @return  nothing where both changed the same lines in different ways
std::optional<std::string> merged(std::string_view base, std::string_view ours, std::string_view theirs);

}  // namespace mlab::documents
