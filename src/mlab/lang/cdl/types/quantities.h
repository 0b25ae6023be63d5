#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mlab::cdl {

/// A type of parameters that says what is meant (`length`): a type of flow and the unit of its values.
struct Quantity {
  std::string_view name;
  std::string_view type;
  std::string_view unit;
};

std::span<const Quantity> quantities();
/// Null where there is none of that name.
const Quantity* quantity_named(std::string_view name);
/// All types that a parameter may have, quantities too, for "did you mean"; a library finds more.
std::vector<std::string> type_names();

}  // namespace mlab::cdl
