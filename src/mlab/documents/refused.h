#pragma once

#include <string>
#include <string_view>

#include "mlab/text/diagnostic.h"

namespace mlab::documents {

/// An error about a document or a file as a whole: it has no place.
std::unexpected<text::Diagnostic> refused(std::string kind, std::string message);

/// A path as messages name it.
std::string shown(std::string_view path);

}  // namespace mlab::documents
