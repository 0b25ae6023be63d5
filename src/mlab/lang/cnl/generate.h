#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mlab/lang/cnl/tree.h"

namespace mlab::cnl {

struct GenerateOptions {
  std::string output_name;  ///< of the file that the text goes to, for `#line`
  bool is_module = false;   ///< also what makes it a shared library that `flow/module.h` describes
};

/// C++ for the procedures of a file: one namespace with a `fire` function each, and the function
/// `mlab_cnl_<stem>()` that gives their descriptors. The tree has passed `check_declarations` without an
/// error. The same tree gives the same text, byte for byte.
std::string generate(const Tree& tree, const GenerateOptions& options);

/// C++ for a function `name`, which gives the descriptors of all these files.
std::string generate_table(const std::vector<std::string>& cnl_files, std::string_view name);

/// `move_to_goal` for `a/move_to_goal.cnl`: what its functions are named after.
std::string stem_of(std::string_view cnl_file);

}  // namespace mlab::cnl
