#pragma once

#include <string>
#include <string_view>

namespace mlab::lsp {

/// The path of a `file:` URI; any other URI stays as it is.
std::string path_of(std::string_view uri);
/// The `file:` URI of a path; what is a URI already stays as it is.
std::string uri_of(const std::string& path);

}  // namespace mlab::lsp
