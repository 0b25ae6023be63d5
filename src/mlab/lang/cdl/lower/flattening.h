#pragma once

#include "mlab/flow/library.h"
#include "mlab/flow/network.h"
#include "mlab/lang/cdl/configuration.h"
#include "mlab/lang/cdl/lower/arguments.h"
#include "mlab/lang/cdl/lower/arithmetic_lowering.h"
#include "mlab/lang/cdl/lower/binder.h"
#include "mlab/lang/cdl/lower/call_lowering.h"
#include "mlab/lang/cdl/lower/declaration_check.h"
#include "mlab/lang/cdl/lower/elaboration.h"
#include "mlab/lang/cdl/lower/equipment.h"
#include "mlab/lang/cdl/lower/expression_lowering.h"
#include "mlab/lang/cdl/lower/findings.h"
#include "mlab/lang/cdl/lower/lower.h"
#include "mlab/lang/cdl/lower/named_places.h"
#include "mlab/lang/cdl/lower/operator_lowering.h"
#include "mlab/lang/cdl/lower/robot_lowering.h"
#include "mlab/lang/cdl/lower/test_lowering.h"
#include "mlab/lang/cdl/lower/value.h"

namespace mlab::cdl {

/// One flattening of a configuration to the network of a robot: puts together those who do it. A member knows
/// those above it, and all know the evaluator. For one call.
class Flattening {
 public:
  Flattening(const Configuration& configuration, const flow::Library& library, text::Diagnostics& sink,
             EarlierFindings& said, Purpose purpose);
  Flattening(const Flattening&) = delete;
  Flattening& operator=(const Flattening&) = delete;

  LoweredRobot robot(const Robot& robot);
  /// @param robot  `robot_of` the test
  LoweredTest test(const Test& test, const Robot& robot);
  DeclarationCheck declarations();

 private:
  RobotLowering robots();

  const Configuration& configuration_;
  const Elaboration elaboration_;
  flow::Network network_;
  Scopes scopes_;
  Findings findings_;
  Binder binder_;
  Arguments arguments_;
  NamedPlaces places_;
  Equipment equipment_;
  CallLowering calls_;
  ArithmeticLowering arithmetic_;
  OperatorLowering operators_;
  ExpressionLowering values_;
};

}  // namespace mlab::cdl
