#include "mlab/lang/cdl/lower/flattening.h"

#include <utility>

namespace mlab::cdl {

Flattening::Flattening(const Configuration& configuration, const flow::Library& library,
                       text::Diagnostics& sink, EarlierFindings& said, Purpose purpose)
    : configuration_(configuration),
      elaboration_(configuration, library),
      findings_(sink, said),
      binder_(configuration, library, elaboration_.types(), findings_),
      arguments_(findings_),
      places_(elaboration_.types(), findings_, arguments_, network_),
      equipment_(configuration, elaboration_, findings_, scopes_),
      calls_({configuration, library, elaboration_, findings_, binder_, arguments_, equipment_, values_,
              scopes_, network_, said.results},
             purpose),
      arithmetic_({library, findings_, binder_, arguments_, places_, values_, network_}),
      operators_({library, elaboration_.types(), findings_, binder_, calls_, values_, network_}),
      values_({elaboration_.types(), findings_, binder_, calls_, arithmetic_, operators_, network_}) {}

RobotLowering Flattening::robots() {
  return RobotLowering(
      {elaboration_, findings_, binder_, places_, equipment_, calls_, values_, scopes_, network_});
}

DeclarationCheck Flattening::declarations() {
  return DeclarationCheck({configuration_, elaboration_, elaboration_.types(), findings_, binder_, equipment_,
                           calls_, values_, scopes_});
}

LoweredRobot Flattening::robot(const Robot& robot) {
  LoweredRobot out;
  RobotLowering lowering = robots();
  lowering.drive(robot, lowering.declare(robot, out));
  out.network = std::move(network_);
  return out;
}

LoweredTest Flattening::test(const Test& test, const Robot& robot) {
  LoweredRobot body;
  Scope& scope = robots().declare(robot, body);
  TestLowering lowering({elaboration_.types(), findings_, binder_, arguments_, values_, scopes_, network_});
  LoweredTest out = lowering.test(test, scope);
  out.network = std::move(network_);
  return out;
}

}  // namespace mlab::cdl
