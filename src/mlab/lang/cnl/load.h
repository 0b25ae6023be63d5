#pragma once

#include <string>
#include <vector>

#include "mlab/lang/cnl/tree.h"
#include "mlab/text/diagnostic.h"
#include "mlab/text/files.h"

namespace mlab::cnl {

/// Includes may stand this deep in each other.
inline constexpr int kMaxIncludeDepth = 64;

/// Reads a CNL file and everything it includes. Paths are relative to the including file. A file that was
/// read before is not read again, so headers need no guards.
///
/// @param files   takes the paths of all files that were read, the first one not among them; may be null
/// @param reader  how they are read
/// @errors  those of `parse`; `cannot-read` for a missing file; `include-cycle`; `include-too-deep`
Tree load(const text::SourcePtr& source, text::Diagnostics& diagnostics,
          std::vector<std::string>* files = nullptr, const text::Files& reader = text::files_on_disk());

/// Says where a declaration stands behind the first node: procedures come before the network that uses them.
void check_order(const Tree& tree, text::Diagnostics& diagnostics);

/// True where the text looks like CNL rather than one of the other languages: for files whose name does not
/// say.
bool looks_like_cnl(std::string_view text);

}  // namespace mlab::cnl
