#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "mlab/text/diagnostic.h"
#include "mlab/text/source.h"

namespace mlab::cdl {

/// The file in its canonical layout: indents, spaces and line breaks. Words, comments and their order stay, a
/// list that its author broke into lines stays broken, and so does a blank line. Formatting again changes
/// nothing.
///
/// @return  nothing where the file has errors, which are then in the sink
std::optional<std::string> format(const text::SourcePtr& source, text::Diagnostics& sink);

/// The same for a text that is known to be right.
std::string laid_out(std::string_view text);

}  // namespace mlab::cdl
