#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/lang/cdl/syntax/tree.h"
#include "mlab/lang/cdl/types/port_type.h"

namespace mlab::cdl {

/// What is called like an assemblage and computes: `distance(a, b)`. An own declaration of the name hides it.
struct Function {
  std::string_view name;
  std::vector<std::string_view> inputs;
  std::string_view
      behavior;  ///< of the library: its inputs are explained there; empty: of `place`, it is none
  std::string_view help;
};

std::span<const Function> functions();
/// Null where there is none of the name.
const Function* function_named(std::string_view name);
/// The function that is the position of a named place.
inline constexpr std::string_view kPlaceFunction = "place";

/// What computes an operation or a function of operands of these types, or why nothing does.
struct Computation {
  std::string_view behavior;  ///< of the library; empty where operands do not fit, or a type can't be told
  PortType type;              ///< of what comes out, in SI units; without a type it can't be told
  /// Which operand each input takes.
  std::vector<std::size_t> order;
  std::string refusal = {};                 ///< a sentence; empty: it is all right
  std::optional<std::size_t> refused = {};  ///< the operand that it is about; nothing: all
  bool is_about_units = false;
  std::string hint = {};
};

Computation computation(Operation operation, std::span<const PortType> operands);
Computation computation(const Function& function, std::span<const PortType> operands);

/// What a behavior of the library that computations name makes of constants. A truth value is 1 or 0. Nothing
/// where it takes other things than numbers.
std::optional<double> folded(std::string_view behavior, std::span<const double> numbers);

/// Whether signs and functions say all that this behavior of the library does.
bool is_said_by_signs(std::string_view behavior);

/// `m`; `a plain number` of no unit.
std::string unit_in_words(const std::string& unit);

}  // namespace mlab::cdl
