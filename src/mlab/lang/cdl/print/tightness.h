#pragma once

#include <string>
#include <variant>

#include "mlab/lang/cdl/syntax/tree.h"
#include "mlab/lang/cdl/types/units.h"

// Where expressions stand in parentheses.

namespace mlab::cdl {

/// What an expression may be without parentheses around it.
enum Tightness { kAnything, kInOr, kInAnd, kInComparison, kInSum, kInProduct, kNegated, kSuffixed };

/// Where it has to stand in parentheses: farther in than this.
inline Tightness outermost(const Expression& expression) {
  if (!expression.as.text.empty() || expression.active) return kSuffixed;
  if (const auto* logic = std::get_if<Logic>(&expression.what))
    return logic->connective == Connective::kNot ? kInAnd : kAnything;
  const auto* arithmetic = std::get_if<Arithmetic>(&expression.what);
  if (arithmetic == nullptr || arithmetic->operations.empty()) return kSuffixed;
  switch (arithmetic->operations.front()) {
    case Operation::kNegate:
      return kInProduct;
    case Operation::kAdd:
    case Operation::kSubtract:
      return kInComparison;
    case Operation::kMultiply:
    case Operation::kDivide:
      return kInSum;
    default:
      return kInAnd;
  }
}

/// `(2 m) / s`: without parentheses it is a speed.
inline bool is_unit_of(const Expression& number, const Expression& divisor) {
  const auto* quantity = std::get_if<Number>(&number.what);
  const auto* name = std::get_if<Name>(&divisor.what);
  return quantity != nullptr && name != nullptr && !quantity->unit.text.empty() &&
         unit_named(quantity->unit.text + "/" + name->name.text).has_value();
}

}  // namespace mlab::cdl
