#pragma once

#include <optional>
#include <string>

#include "mlab/lang/cnl/tree.h"
#include "mlab/text/diagnostic.h"

namespace mlab::cnl {

/// The file in its canonical layout: one declaration, input or link a line; comments kept; user code as it
/// stands. Printing what was printed changes nothing, and it means the same as before.
///
/// @return  nothing where the file has errors; `diagnostics` says which
std::optional<std::string> format(const text::SourcePtr& source, text::Diagnostics& diagnostics);

}  // namespace mlab::cnl
