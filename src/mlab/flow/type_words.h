#pragma once

#include <string>
#include <string_view>

#include "mlab/flow/type_info.h"

// Types as people call them who write values, and not C++.
namespace mlab::flow {

/// What a value is called: `number`, `truth value`, `formation reference`.
std::string noun_of(const TypeInfo& type);
/// A value of it, as who composes skills calls it: `a number`, `a truth value`, `a Vector`, `a list of
/// obstacles`.
std::string value_of(const TypeInfo& type);
/// The same of a number in a unit: `a length [m]`; `a number [m*m]` where no quantity has it.
/// @param unit  empty: none
std::string value_of(const TypeInfo& type, std::string_view unit);
/// Why nobody can set or hold a value of a type that has no form in writing.
std::string why_not_written(std::string_view port, const TypeInfo& type);
/// What can be written as one: `a number`, `true or false`, `one of Line, Column, Wedge`.
std::string expected_of(const TypeInfo& type);

}  // namespace mlab::flow
