#include "mlab/documents/refused.h"

#include <utility>

#include <fmt/core.h>

#include "mlab/text/shown.h"

namespace mlab::documents {

std::unexpected<text::Diagnostic> refused(std::string kind, std::string message) {
  return std::unexpected(
      text::Diagnostic{text::Severity::kError, std::move(kind), std::move(message), {}, {}, {}, {}});
}

std::string shown(std::string_view path) {
  return fmt::format("`{}`", text::shown(path, 200));
}

}  // namespace mlab::documents
