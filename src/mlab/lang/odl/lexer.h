#pragma once

#include <vector>

#include "mlab/lang/odl/token.h"
#include "mlab/text/diagnostic.h"

namespace mlab::odl {

/// Splits an overlay into tokens, the last of them kEnd, and collects its comments.
///
/// The longest match wins, as in the historic language: `abc--x` is one word and no comment, `0.3--x` a file
/// name.
/// @errors  `unterminated-string`; a run of characters that no token begins with is a warning,
/// `stray-character`,
///          and skipped. A carriage return before a line end and a byte order mark are white space.
void lex(const text::SourcePtr& source, std::vector<Token>& tokens, std::vector<Comment>& comments,
         text::Diagnostics& sink);

/// True where the whole text is one number as the language writes it.
bool is_number(std::string_view text);

/// The value of a kNumber token's text; infinite where a double cannot hold it.
double number_value(std::string_view text);

}  // namespace mlab::odl
