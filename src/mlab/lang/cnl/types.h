#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mlab::cnl {

/// A type of values on wires that the language knows without a declaration.
struct PortType {
  std::string_view name;    ///< as new networks write it
  std::string_view cpp;     ///< in generated code, within `using namespace mlab::schema`
  bool is_reading = false;  ///< procedures see a view of this cycle's readings, not the value itself
  bool is_scalar = false;   ///< passed by value
};

/// By its name or by its historic name (`obs_array`, `boolean`, `float`, ...). Null: none of them.
const PortType* find_port_type(std::string_view name);
/// All names that `find_port_type` knows, for "did you mean".
std::vector<std::string> port_type_names();
/// True for a type of the historic headers that has no counterpart here (`type_pry`, ...).
bool is_lost_historic_type(std::string_view name);

}  // namespace mlab::cnl
