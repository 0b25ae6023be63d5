#pragma once

#include <vector>

#include "mlab/lang/mdl/tree.h"
#include "mlab/text/word_changes.h"

namespace mlab::mdl {

/// The words that say a statement. Those of its parts that have a span stand there already, all others are
/// new.
///
/// @param keyword  where its first word stands; empty: nowhere yet
std::vector<text::Word> words_of(const statement::StartPlace& start, text::Span keyword);
std::vector<text::Word> words_of(const statement::Obstacle& obstacle, text::Span keyword);
std::vector<text::Word> words_of(const statement::MissionArea& area, text::Span keyword);

}  // namespace mlab::mdl
