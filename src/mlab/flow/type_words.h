#pragma once

#include <string>

#include "mlab/flow/type_info.h"

// Types as people call them who write values, and not C++.
namespace mlab::flow {

/// What a value is called: `number`, `truth value`, `formation reference`.
std::string noun_of(const TypeInfo& type);
/// What can be written as one: `a number`, `true or false`, `one of Line, Column, Wedge`.
std::string expected_of(const TypeInfo& type);

}  // namespace mlab::flow
