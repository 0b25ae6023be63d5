#pragma once

#include "source_tree.h"

namespace mlab::repo {

/// Names behind `@param` in C++ that do not occur in the declaration below: it was changed, or the comment
/// stands over another one.
Findings stray_parameters(const Tree& tree);

}  // namespace mlab::repo
