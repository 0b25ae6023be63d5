#pragma once

#include <vector>

#include "mlab/lang/cdl_historic/token.h"
#include "mlab/text/diagnostic.h"

namespace mlab::cdl_historic {

/// Splits a historic configuration into tokens, the last of them kEnd.
///
/// Lines that start with `#` are left out, without a word where the historic tools expected them (line
/// markers of the C preprocessor, pragmas).
/// @errors  `unterminated-comment`, `unterminated-initializer`, `unterminated-description`; warnings
///          `stray-character`, `unknown-directive`
std::vector<Token> lex(const text::SourcePtr& source, text::Diagnostics& sink);

}  // namespace mlab::cdl_historic
