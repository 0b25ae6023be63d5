#pragma once

#include <string>

// What follows from cdl::kTestPercepts.

namespace mlab::tables {

/// What a test of a component may give, as a table of the documentation.
std::string test_percept_documentation();

}  // namespace mlab::tables
