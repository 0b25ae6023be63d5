#pragma once

#include "mlab/lang/cdl_historic/tree.h"
#include "mlab/text/diagnostic.h"

namespace mlab::cdl_historic {

/// Parses a historic configuration. Names are not looked up: what a word is follows from where it stands. One
/// error per broken statement, then it goes on at the next. Never fails: any bytes give a tree.
/// @errors  `expected-...`, `nested-too-deeply`, and what `lex` says
Tree parse(const text::SourcePtr& source, text::Diagnostics& sink);

/// Instances in instances in a file; a person writes a dozen.
inline constexpr int kMaxNesting = 300;

}  // namespace mlab::cdl_historic
