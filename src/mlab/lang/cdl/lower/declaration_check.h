#pragma once

#include <vector>

#include "mlab/lang/cdl/configuration.h"
#include "mlab/lang/cdl/lower/binder.h"
#include "mlab/lang/cdl/lower/call_lowering.h"
#include "mlab/lang/cdl/lower/elaboration.h"
#include "mlab/lang/cdl/lower/equipment.h"
#include "mlab/lang/cdl/lower/evaluator.h"
#include "mlab/lang/cdl/lower/findings.h"
#include "mlab/lang/cdl/lower/value.h"
#include "mlab/lang/cdl/types/types.h"

namespace mlab::cdl {

/// Checks declarations by themselves, whoever uses them: parameters have values of their type, or their
/// defaults.
class DeclarationCheck {
 public:
  struct Parts {
    const Configuration& configuration;
    const Elaboration& elaboration;
    const Types& types;
    Findings& findings;
    Binder& binder;
    Equipment& equipment;
    CallLowering& calls;
    Evaluator& values;
    Scopes& scopes;
  };
  explicit DeclarationCheck(const Parts& parts) : parts_(parts) {}

  void check(const Assemblage& assemblage);
  /// Devices and body.
  void check(const RobotClass& robot_class);
  void check(const SocietyOperator& op);

 private:
  void declare(const std::vector<Parameter>& parameters, Scope& scope);
  void check(const Device& device);
  void check_sensor(const Device& device, const Binding& binding);

  const Parts parts_;
};

}  // namespace mlab::cdl
