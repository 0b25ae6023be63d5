#include "mlab/text/one_line.h"

#include <algorithm>

#include <fmt/core.h>

#include "mlab/text/shown.h"

namespace mlab::text {
namespace {

constexpr std::size_t kMostCharacters = 600;  // of each part

std::string part(std::string_view text) {
  return shown(text, kMostCharacters);
}

}  // namespace

std::string one_line(const Diagnostic& diagnostic) {
  std::string out;
  if (diagnostic.place.source) {
    const std::string& path = diagnostic.place.source->name();
    const LineColumn at = diagnostic.place.source->line_column(diagnostic.place.span.begin);
    out = fmt::format("{}:{}:{}: ", part(path.substr(path.find_last_of('/') + 1)), at.line, at.column);
  }
  out += part(diagnostic.message);
  if (!diagnostic.label.empty()) out += ": " + part(diagnostic.label);
  if (!diagnostic.hints.empty()) out += "; " + part(diagnostic.hints.front());
  return out;
}

std::string first_error(const Diagnostics& diagnostics) {
  const auto first = std::ranges::find(diagnostics.items(), Severity::kError, &Diagnostic::severity);
  if (first == diagnostics.items().end()) return "";
  const std::size_t others = diagnostics.error_count() - 1;
  if (others == 0) return one_line(*first);
  return fmt::format("{} (and {} more error{})", one_line(*first), others, others == 1 ? "" : "s");
}

}  // namespace mlab::text
