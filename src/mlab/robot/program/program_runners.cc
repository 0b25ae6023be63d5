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

ProgramRunners::ProgramRunners(std::uint64_t seed, int processes, std::unique_ptr<ProgramRunner> elsewhere,
                               std::unique_ptr<ProgramRunner> recorded) {
  const auto add = [this](std::unique_ptr<ProgramRunner> runner) {
    ProgramRunner* const out = runner.get();
    if (runner) all_.push_back(std::move(runner));
    return out;
  };
  in_process_ = add(std::make_unique<InProcessRunner>(seed));
  hosted_ = add(std::make_unique<HostedRunner>(seed, processes));
  executables_ = add(std::make_unique<ExecutableRunner>(seed, processes));
  elsewhere_ = add(std::move(elsewhere));
  recorded_ = add(std::move(recorded));
}

ProgramRunner* ProgramRunners::runner_of(const RobotProgram& program) const {
  if (program.recorded) return recorded_;
  if (program.native) return executables_;
  if (!program.program) return nullptr;
  if (elsewhere_ != nullptr && program.can_be_elsewhere()) return elsewhere_;
  return program.hosted ? hosted_ : in_process_;
}

}  // namespace mlab::robot
