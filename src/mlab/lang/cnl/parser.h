#pragma once

#include "mlab/lang/cnl/lexer.h"
#include "mlab/lang/cnl/tree.h"
#include "mlab/text/diagnostic.h"

namespace mlab::cnl {

/// Where a line of the canonical layout starts, and how far it is set in.
struct LineStart {
  std::uint32_t offset = 0;
  int indent = 0;
  bool is_optional = false;  ///< stays behind what comes before where its author wrote it there
};

/// What `parse` found besides the tree; the printer needs it.
struct Layout {
  std::vector<LineStart> lines;        ///< ascending
  std::vector<text::Span> raw;         ///< user code between declarations, ascending
  std::vector<Comment> comments;       ///< those outside of user code, ascending
  std::vector<text::Span> one_liners;  ///< `node ... nend` that may stay on one line
};

/// Reads one CNL file. Reads no other file: `Include::tree` stays empty.
///
/// @return  the tree; after errors it lacks the declarations that could not be read
/// @errors  `syntax`, `unclosed-*`, `missing-section`, `section-order`, `declaration-after-node`, ...: see
/// the
///          tests; after an error reading goes on at the next declaration, input or link
Tree parse(const text::SourcePtr& source, text::Diagnostics& diagnostics, Layout* layout = nullptr);

}  // namespace mlab::cnl
