#pragma once

#include <string>

namespace mlab::base {

/// The root of the clone that the tests were built from, where they find test data and pages. A function and
/// not a macro: so tests compile to the same in every clone, and clones share what the compiler made of them.
std::string source_folder();

}  // namespace mlab::base
