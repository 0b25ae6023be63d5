#include "mlab/robot/program/program_runners.h"

#include <cmath>

#include "mlab/robot/program/executable_runner.h"
#include "mlab/robot/program/hosted_runner.h"
#include "mlab/robot/program/in_process_runner.h"
#include "mlab/robot/program/robot_values.h"

namespace mlab::robot {

bool is_number(const percept::Action& action) {
  const geom::Vector v = action.velocity;
  return std::isfinite(v.x + v.y + v.z + action.spin);
}

std::vector<flow::Restart> ProgramRunner::go_on_from(Member member, const RobotValues& before) {
  return values(member)->go_on_from(before);
}

ProgramRunners::ProgramRunners(std::uint64_t seed, int processes, std::unique_ptr<ProgramRunner> elsewhere) {
  all_.push_back(std::make_unique<InProcessRunner>(seed));
  all_.push_back(std::make_unique<HostedRunner>(seed, processes));
  all_.push_back(std::make_unique<ExecutableRunner>(seed, processes));
  if (elsewhere) all_.push_back(std::move(elsewhere));
}

ProgramRunner* ProgramRunners::runner_of(const RobotProgram& program) const {
  if (program.native) return all_[2].get();
  if (!program.program) return nullptr;
  if (all_.size() > 3 && (program.origin || program.executable)) return all_[3].get();
  return (program.hosted ? all_[1] : all_[0]).get();
}

}  // namespace mlab::robot
