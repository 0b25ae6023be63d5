#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mlab/flow/value_types.h"

namespace mlab::cnl {

/// A type of values that the language knows without a declaration, by its name or by its historic name
/// (`obs_array`, `boolean`, `float`, ...). Null: none of them.
const flow::ValueTypeInfo* find_port_type(std::string_view name);
/// Procedures see a view of this cycle's readings, not the value itself.
bool is_reading(const flow::ValueTypeInfo& type);
/// Passed by value.
bool is_scalar(const flow::ValueTypeInfo& type);
/// All names that `find_port_type` knows, for "did you mean".
std::vector<std::string> port_type_names();
/// True for a type of the historic headers that has no counterpart here (`type_pry`, ...).
bool is_lost_historic_type(std::string_view name);

}  // namespace mlab::cnl
