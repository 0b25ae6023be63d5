#include "mlab/robot/program/program_runners.h"

#include <cmath>

#include "mlab/robot/program/executable_runner.h"
#include "mlab/robot/program/hosted_runner.h"
#include "mlab/robot/program/in_process_runner.h"

namespace mlab::robot {

bool is_number(const percept::Action& action) {
  const geom::Vector v = action.velocity;
  return std::isfinite(v.x + v.y + v.z + action.spin);
}

ProgramRunners::ProgramRunners(std::uint64_t seed, int processes)
    : all_{std::make_unique<InProcessRunner>(seed), std::make_unique<HostedRunner>(seed, processes),
           std::make_unique<ExecutableRunner>(seed, processes)} {}

ProgramRunner* ProgramRunners::runner_of(const RobotProgram& program) const {
  if (program.native) return all_[2].get();
  if (!program.program) return nullptr;
  return (program.hosted ? all_[1] : all_[0]).get();
}

}  // namespace mlab::robot
