#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "mlab/difference/match.h"
#include "mlab/lang/cdl/syntax/tree.h"

namespace mlab::difference {

/// What is known of a declaration, of whatever kind. Points into the tree.
struct Declaration {
  const cdl::Item* item = nullptr;
  const char* kind = "";  ///< `assemblage`
  const cdl::Word* name = nullptr;
  const std::string* help = nullptr;
  const std::vector<cdl::Parameter>* parameters = nullptr;  ///< null: it can have none
  text::Span whole;
};

/// All that a file declares, and no layouts, uses, architecture.
std::vector<Declaration> declarations_of(const cdl::Tree& tree);

/// Which of them are the same: by kind and name; then by what they say; then by their words.
Pairs match_declarations(const std::vector<Declaration>& before, const std::vector<Declaration>& after,
                         const cdl::Tree& before_tree, const cdl::Tree& after_tree);

/// Which parameters are the same: by name; then by all else; then the only one of its type.
Pairs match_parameters(const std::vector<cdl::Parameter>& before, const std::vector<cdl::Parameter>& after);

/// What `let`s are called afterwards that are called otherwise.
/// @param renames  of all that is known before
Renames::Names renamed_lets(const std::vector<cdl::Let>& before, const std::vector<cdl::Let>& after,
                            const Renames& renames);

}  // namespace mlab::difference
