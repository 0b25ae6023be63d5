#pragma once

#include <expected>
#include <string>
#include <utility>

#include "mlab/text/diagnostic.h"

namespace mlab::designer {

/// A change that can't be done: why, as a sentence for a person.
inline std::unexpected<text::Diagnostic> refusal(std::string message) {
  return std::unexpected(
      text::Diagnostic{text::Severity::kError, "cannot-edit", std::move(message), {}, {}, {}, {}});
}

/// That a change has been done, or noted; why not otherwise.
using Done = text::Result<bool>;

}  // namespace mlab::designer
