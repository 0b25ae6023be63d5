#include "mlab/flow/builder_hints.h"

#include <fmt/core.h>

namespace mlab::flow {

std::string did_you_mean(std::string_view name, const std::vector<std::string>& candidates) {
  const std::string nearest = text::nearest_name(name, candidates);
  return nearest.empty() ? "" : fmt::format("did you mean `{}`?", nearest);
}

void hint(text::Diagnostic& diagnostic, const std::string& text) {
  if (!text.empty()) diagnostic.hints.push_back(text);
}

}  // namespace mlab::flow
