#pragma once

#include <string>
#include <vector>

#include "mlab/lang/cnl/tree.h"

namespace mlab::cnl {

/// What a file says of its procedures, without what they do.
struct Declarations {
  std::string file;  ///< without its folder
  std::string text;  ///< CNL; every line where its author wrote it, blanks in place of C++
};

/// Of the file and all that it includes, in the order in which they hold.
std::vector<Declarations> declarations_of(const Tree& tree);

}  // namespace mlab::cnl
