#pragma once

#include "mlab/difference/difference.h"
#include "mlab/difference/match.h"
#include "mlab/lang/cdl/lower/owner_model.h"

namespace mlab::difference {

/// Compares what an assemblage or a robot draws, page by page. Its parameters are compared by their
/// declaration.
/// @param renames  of declarations and their parameters, and of the owner's own names
/// @param out      is added to
void compare_owner(const cdl::OwnerModel& before, const cdl::OwnerModel& after, const Renames& renames,
                   Comparison& out);

/// What the author wrote; in canonical words where nobody wrote it.
std::string words_of(const cdl::Expression& expression);
/// Puts a detail, unless both are the same.
void note(Difference& out, const char* what, std::string before, std::string after);
/// What became of a thing that both have; false: nothing, and it is not told.
bool settle(Difference& out);

}  // namespace mlab::difference
