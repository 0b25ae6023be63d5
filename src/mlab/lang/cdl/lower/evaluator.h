#pragma once

#include "mlab/lang/cdl/lower/value.h"

namespace mlab::cdl {

/// Makes values of expressions, and the nodes that compute them: what operators, calls and robots ask for
/// their parts.
class Evaluator {
 public:
  virtual Value value_of(const Expression& expression, Scope& scope) = 0;
  /// Of a name of the scope.
  virtual Value value_of(Scope::Named& named, Scope& scope) = 0;

 protected:
  ~Evaluator() = default;
};

}  // namespace mlab::cdl
