#pragma once

#include "mlab/comparison/comparison.h"
#include "mlab/history/history.h"

namespace mlab::comparison {

/// What differs before anything happens: texts, seed, settings, versions. Texts belong together by their
/// paths, and where that tells nothing, by the names of their files.
/// @param histories  have begun
Beginning compare_beginnings(const Both<const history::History*>& histories);

}  // namespace mlab::comparison
