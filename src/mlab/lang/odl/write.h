#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mlab/lang/odl/tree.h"
#include "mlab/text/word_changes.h"

namespace mlab::odl {

/// A new number: to 0.01, without zeros at its end: `12.5`. What would become 0 that way keeps its first
/// digits.
std::string written(double value);

/// A name with the quotes that it needs; empty where it can't be written at all. A `*` at its end, which
/// hides a label, needs none.
std::string written_name(const std::string& name);

/// The words that say a statement, in the order of its rule. Those of its parts that have a span stand there
/// already, and so do the keyword and the words inside of it as far as they are among the tokens of `tree`
/// that the statement names; all others are new. A point in degrees or of GEO is never new.
std::vector<text::Word> words_of(const Statement& statement, const Tree& tree);

/// A statement that stands nowhere yet, on one line.
std::string print(const Statement& statement);

}  // namespace mlab::odl
