#pragma once

#include "mlab/comparison/comparison.h"
#include "mlab/history/history.h"

namespace mlab::comparison {

/// What stands in the recordings themselves, for those that can't be computed again: where robots were, once
/// a second, and marks, by which the same run is told.
void compare_recorded(const Both<const history::History*>& histories, Comparison& out);

}  // namespace mlab::comparison
