#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mlab/difference/difference.h"

namespace mlab::difference {

/// `+`, `-`, `~` (changed, renamed), `>` (moved): what a person sees where colours are not seen.
char sign_of(What what);
/// `added`, `removed`, `changed`, `renamed`, `moved`.
std::string_view word_of(What what);
/// `node`, `transition`, `parameter`, ...
std::string_view word_of(Thing thing);

/// Where it is: a page or a declaration, by its name afterwards; empty: the file itself.
std::string place_of(const Difference& difference);
/// What it is and what became of it, on one line: `Noise: persistence 12 s -> 6 s`.
std::string sentence(const Difference& difference);
/// One detail of it: `persistence 12 s -> 6 s`.
std::string sentence(const Detail& detail);

/// What else is to be said of both texts: that only comments differ, that something was moved. Sentences,
/// none where all has been told.
std::vector<std::string> remarks(const Comparison& comparison);

}  // namespace mlab::difference
