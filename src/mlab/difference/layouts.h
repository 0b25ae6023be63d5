#pragma once

#include "mlab/difference/difference.h"

namespace mlab::difference {

/// What was moved on pages that both have, and the notes on them.
/// @param out  its pages and owners say what is the same; `layout` is added to
void compare_layouts(const cdl::Tree& before, const cdl::Tree& after, Comparison& out);

}  // namespace mlab::difference
