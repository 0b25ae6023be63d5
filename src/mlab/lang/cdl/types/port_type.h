#pragma once

#include <string>

#include "mlab/flow/library.h"
#include "mlab/flow/value_types.h"

namespace mlab::cdl {

/// What flows: the type that a value, a parameter or an input has, and the unit of its numbers.
struct PortType {
  const flow::TypeInfo* type = nullptr;  ///< null: it can't be told
  std::string unit;                      ///< empty: none

  /// Empty where it can't be told.
  std::string name() const { return type == nullptr ? std::string() : std::string(type->name); }
};

/// What keeps a value of one type from standing where another is expected.
enum class Misfit {
  kNone,  ///< nothing; also where one of the two can't be told
  kType,  ///< it is of another type, and no whole number that becomes a real one
  kUnit   ///< both are numbers, in units of which neither becomes the other by itself: only angles do
};
/// What may be connected with what, for everybody who asks.
Misfit misfit(const PortType& have, const PortType& want);

/// Whether values of this type come on wires only: no person writes them.
bool is_wired(const PortType& type);

}  // namespace mlab::cdl
