#pragma once

#include <string>
#include <vector>

#include "mlab/lang/cdl/syntax/lexer.h"
#include "mlab/lang/cdl/syntax/tree.h"
#include "mlab/text/diagnostic.h"

namespace mlab::cdl {

/// Reads one configuration file. Reads no other file.
///
/// @return  the tree; after errors it lacks what could not be read
/// @errors  `syntax`, `unclosed-text`, `unclosed-comment`, `unclosed-block`, `nested-too-deep`,
///          `number-out-of-range`; one for each slip, then reading goes on at the next statement
Tree parse(const text::SourcePtr& source, text::Diagnostics& sink);

/// One expression, and nothing behind it; null where it is none.
ExpressionPtr parse_value(const text::SourcePtr& source);

/// A file as far as it is written, for whoever answers while somebody types.
struct PartialFile {
  /// With what is incomplete, too: where a value is missing stands a `Hole`, where a name is missing a word
  /// without text. The place of both is where it should stand.
  Tree tree;
  Tokens tokens;                  ///< without those of kind kUnknown
  std::vector<text::Span> words;  ///< words of the language, ascending
  /// Words of the language that could stand where the text ends, besides what fills a hole there.
  std::vector<std::string> next_words;
  bool ends_inside = false;  ///< the text ends inside of its last declaration
};

/// Reads any text, by the same rules as `parse`. Says nothing and never fails; deep nesting is cut off.
PartialFile read_as_written(const text::SourcePtr& source);

/// Whether this is a configuration, told by what it starts with.
bool looks_like_cdl(std::string_view text);

}  // namespace mlab::cdl
