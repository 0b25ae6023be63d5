#pragma once

#include "mlab/assist/statement_candidates.h"
#include "mlab/console.pb.h"

namespace mlab::console {

using assist::KnownNames;

/// What could stand at the cursor of a typed command, a mission or an overlay, as a message. In the middle of
/// a comment or where only a new name or a number can stand, there is nothing.
///
/// @param request  its cursor may be anywhere; text that is not UTF-8 and broken statements do no harm
Completions complete(const Complete& request, const KnownNames& names);

}  // namespace mlab::console
