#pragma once

#include <string>

#include "mlab/flow/network.h"
#include "mlab/lang/cdl/lower/arithmetic_lowering.h"
#include "mlab/lang/cdl/lower/binder.h"
#include "mlab/lang/cdl/lower/call_lowering.h"
#include "mlab/lang/cdl/lower/evaluator.h"
#include "mlab/lang/cdl/lower/findings.h"
#include "mlab/lang/cdl/lower/operator_lowering.h"
#include "mlab/lang/cdl/lower/value.h"
#include "mlab/lang/cdl/types/types.h"

namespace mlab::cdl {

/// Expressions: names, lists, logic, delays, active parts. What is computed, called or coordinated others
/// know.
class ExpressionLowering final : public Evaluator {
 public:
  struct Parts {
    const Types& types;
    Findings& findings;
    Binder& binder;
    CallLowering& calls;
    ArithmeticLowering& arithmetic;
    OperatorLowering& operators;
    flow::Network& network;
  };
  explicit ExpressionLowering(const Parts& parts)
      : types_(parts.types),
        findings_(parts.findings),
        binder_(parts.binder),
        calls_(parts.calls),
        arithmetic_(parts.arithmetic),
        operators_(parts.operators),
        network_(parts.network) {}

  Value value_of(const Expression& expression, Scope& scope) override;
  Value value_of(Scope::Named& named, Scope& scope) override;

 private:
  /// Without its active part.
  Value passive(const Expression& expression, Scope& scope, const std::string& inside);
  Value number(const Number& number, const text::Place& place);
  Value name(const Name& name, Scope& scope, const text::Place& place);
  Value list(const List& list, Scope& scope, const text::Place& place);
  Value call(const Expression& expression, const Call& call, Scope& scope, const std::string& path);
  Value logic(const Logic& logic, Scope& scope, const std::string& path, const text::Place& place);
  Value delay(const Delay& delay, Scope& scope, const std::string& path, const text::Place& place);
  Value active(const Expression& expression, Scope& scope, const NodeNames::Paths& paths);
  Types::Names types_in(const Scope& scope) const;

  const Types& types_;
  Findings& findings_;
  Binder& binder_;
  CallLowering& calls_;
  ArithmeticLowering& arithmetic_;
  OperatorLowering& operators_;
  flow::Network& network_;
  int depth_ = 0;
};

}  // namespace mlab::cdl
