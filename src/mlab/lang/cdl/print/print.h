#pragma once

#include <string>

#include "mlab/lang/cdl/syntax/tree.h"

namespace mlab::cdl {

/// The tree as a file, in the canonical layout. Parsing it gives the tree again.
std::string print(const Tree& tree);
/// One expression on one line, or on several where it holds blocks.
std::string print(const Expression& expression);

}  // namespace mlab::cdl
