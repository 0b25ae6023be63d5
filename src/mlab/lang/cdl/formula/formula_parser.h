#pragma once

#include <vector>

#include "mlab/lang/cdl/formula/formula_term.h"
#include "mlab/text/diagnostic.h"

namespace mlab::cdl {

/// The sentences of a text. None where one has an error.
std::vector<Term> parse_sentences(const text::SourcePtr& source, text::Diagnostics& sink);

/// Whether each instance stands for one thing, in one robot, and teams are alike.
bool check_sentences(const std::vector<Term>& sentences, text::Diagnostics& sink);

}  // namespace mlab::cdl
