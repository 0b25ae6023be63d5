#pragma once

#include "mlab/lang/cdl/tree.h"
#include "mlab/text/diagnostic.h"

namespace mlab::cdl {

/// Reads one configuration file. Reads no other file.
///
/// @return  the tree; after errors it lacks what could not be read
/// @errors  `syntax`, `unclosed-text`, `unclosed-comment`, `unclosed-block`, `nested-too-deep`,
///          `number-out-of-range`; one for each slip, then reading goes on at the next statement
Tree parse(const text::SourcePtr& source, text::Diagnostics& sink);

/// Whether this is a configuration, told by what it starts with.
bool looks_like_cdl(std::string_view text);

}  // namespace mlab::cdl
