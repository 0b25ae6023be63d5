#pragma once

#include <span>
#include <string_view>

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

}  // namespace mlab::cdl
