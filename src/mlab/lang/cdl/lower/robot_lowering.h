#pragma once

#include <optional>
#include <string>

#include "mlab/flow/network.h"
#include "mlab/lang/cdl/lower/binder.h"
#include "mlab/lang/cdl/lower/call_lowering.h"
#include "mlab/lang/cdl/lower/elaboration.h"
#include "mlab/lang/cdl/lower/equipment.h"
#include "mlab/lang/cdl/lower/evaluator.h"
#include "mlab/lang/cdl/lower/findings.h"
#include "mlab/lang/cdl/lower/lower.h"
#include "mlab/lang/cdl/lower/named_places.h"
#include "mlab/lang/cdl/lower/value.h"
#include "mlab/lang/cdl/types/body.h"

namespace mlab::cdl {

/// What a class says of its robots' bodies.
class BodyLowering {
 public:
  BodyLowering(Findings& findings, Evaluator& values) : findings_(findings), values_(values) {}

  /// `radius`: 0.35, ... in SI units, without what is wrong.
  std::map<std::string, double> body(const RobotClass& robot_class, Scope& scope);

 private:
  std::optional<double> number(const BodySetting& setting, const BodyProperty& property, const Value& value);
  std::optional<double> drive(const BodySetting& setting, const Value& value);
  std::optional<double> setting(const BodySetting& setting, Scope& scope);

  Findings& findings_;
  Evaluator& values_;
};

/// Robots: parameters that missions set, the class's devices, what drives the actuators.
class RobotLowering {
 public:
  struct Parts {
    const Elaboration& elaboration;
    Findings& findings;
    Binder& binder;
    NamedPlaces& places;
    Equipment& equipment;
    CallLowering& calls;
    Evaluator& values;
    Scopes& scopes;
    flow::Network& network;
  };
  explicit RobotLowering(const Parts& parts) : parts_(parts) {}

  /// What the robot declares, with the devices and the body of its class; `out` has the body.
  /// @return  its names, none of which has been evaluated but for parameters
  Scope& declare(const Robot& robot, LoweredRobot& out);
  /// What drives its actuators.
  void drive(const Robot& robot, Scope& scope);

 private:
  void declare_parameter(const Parameter& parameter, Scope& scope);
  Scope& declare_class(const RobotClass& robot_class, Scope& own);
  void drive(const Drive& drive, Scope& scope);

  const Parts parts_;
};

}  // namespace mlab::cdl
