#pragma once

#include <cstdint>
#include <vector>

#include "mlab/text/diagnostic.h"

namespace mlab::envchange {

/// The keywords, and what else there is.
enum class TokenKind : std::uint8_t {
  kStepCount,
  kAdd,
  kRemove,
  kRegion,
  kObstacle,
  kWord,
  kNumber,
  kComma,
  kEnd
};

struct Token {
  TokenKind kind = TokenKind::kEnd;  ///< kWord: a word of letters that is no keyword
  bool starts_line = false;
  text::Span span;
};

/// Splits an environment-change file into tokens, the last of them kEnd; `//` and `/* */` are comments.
/// @errors  `stray-character`, once for a run of them: a number written in another way (`.5`, `+3`, `1e3`)
/// would
///          change its value if they were skipped in silence; `unterminated-comment`
std::vector<Token> lex(const text::SourcePtr& source, text::Diagnostics& sink);

}  // namespace mlab::envchange
