#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mlab/lang/cdl/syntax/tree.h"

namespace mlab::cdl {

/// A text after its tree has changed.
struct Reprinted {
  std::string text;
  text::Span changed;       ///< of the old text: what is around it stays as it is
  std::int64_t longer = 0;  ///< than the old text [bytes]
  /// Words of what was changed: where they began, ascending, and where they begin now. [bytes]
  std::vector<std::pair<std::uint32_t, std::uint32_t>> words;

  /// Where the word stands now that began at a byte of the old text; nothing: it has gone.
  std::optional<std::uint32_t> now(std::uint32_t old) const;
};

/// The text of a tree that was made of another by `Changes`, or by hand: then what was changed has no `whole`
/// any more. What has one is taken over word for word, with the comments and blanks in it, from this text or,
/// where it came from another one, from there; only what is new and what is around it is laid out
/// (canonically: all of a declaration, where all of it was before). A help goes with what it describes; every
/// other comment stays with the word behind it, or with the word before it on its line, or with the next one
/// that is left.
///
/// @param was  the tree of a text without errors
/// @param now  the items of the new one: of the old tree where they are the same
Reprinted reprint(const Tree& was, const std::vector<const Item*>& now);
Reprinted reprint(const Tree& was, const Tree& now);

}  // namespace mlab::cdl
