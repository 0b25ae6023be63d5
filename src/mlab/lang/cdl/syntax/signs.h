#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "mlab/lang/cdl/syntax/tree.h"

namespace mlab::cdl {

/// How an operation is written, and what its node is called that nobody gave a name.
struct Sign {
  Operation operation;
  std::string_view text;
  std::string_view name;
};

/// In the order of `Operation`.
inline constexpr std::array kSigns = {Sign{Operation::kNegate, "-", "Negate"},
                                      Sign{Operation::kAdd, "+", "Add"},
                                      Sign{Operation::kSubtract, "-", "Subtract"},
                                      Sign{Operation::kMultiply, "*", "Multiply"},
                                      Sign{Operation::kDivide, "/", "Divide"},
                                      Sign{Operation::kLess, "<", "Less"},
                                      Sign{Operation::kLessOrEqual, "<=", "LessOrEqual"},
                                      Sign{Operation::kGreater, ">", "Greater"},
                                      Sign{Operation::kGreaterOrEqual, ">=", "GreaterOrEqual"},
                                      Sign{Operation::kEqual, "==", "Equal"},
                                      Sign{Operation::kUnequal, "!=", "Unequal"}};

constexpr const Sign& sign(Operation operation) {
  return kSigns[static_cast<std::size_t>(operation)];
}
constexpr std::string_view sign_of(Operation operation) {
  return sign(operation).text;
}
/// Whether it asks something of two numbers.
constexpr bool is_comparison(Operation operation) {
  return operation >= Operation::kLess;
}

}  // namespace mlab::cdl
