#pragma once

#include <expected>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "mlab/text/diagnostic.h"
#include "mlab/text/shown.h"
#include "mlab/text/source.h"

namespace mlab::console {

/// What an overlay begins as.
inline constexpr const char* kEmptyOverlay = "CONTROL MEASURES:\n";

inline std::unexpected<text::Diagnostic> refused(std::string kind, std::string message) {
  return std::unexpected(
      text::Diagnostic{text::Severity::kError, std::move(kind), std::move(message), {}, {}, {}, {}});
}

inline text::SourcePtr source_of(std::string name, std::string text) {
  return std::make_shared<const text::Source>(std::move(name), std::move(text));
}

/// A path as messages name it.
inline std::string shown(std::string_view path) {
  return fmt::format("`{}`", text::shown(path, 200));
}

}  // namespace mlab::console
