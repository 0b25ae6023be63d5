#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mlab/text/diagnostic.h"

namespace mlab::flow {

/// "did you mean `x`?" with the candidate that is most like the name; empty where none is near.
std::string did_you_mean(std::string_view name, const std::vector<std::string>& candidates);

/// Adds a hint, unless it is empty.
void hint(text::Diagnostic& diagnostic, const std::string& text);

}  // namespace mlab::flow
