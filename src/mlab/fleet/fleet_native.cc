// What a fleet does with robots whose programs run in processes of their own.

#include <cstring>
#include <utility>

#include <fmt/core.h>

#include "mlab/fleet/fleet.h"

namespace mlab::fleet {

void Fleet::run_lock_step() {
  lock_step_.exchange(meanwhile_);
  for (FleetRobot& robot : robots_) {
    if (robot.life != RobotLife::kRunning || !robot.program->has_process()) continue;
    LockStep::Outcome outcome = lock_step_.take(robot.lock_step, robot.action);
    robot.fault = std::move(outcome.fault);
    if (outcome.failure.empty()) {
      if (robot.program->hosted) std::memcpy(robot.frame.data(), outcome.frame.data(), outcome.frame.size());
      check_action(robot);
      if (robot.program->hosted && robot.life == RobotLife::kFaulted) {
        if (const flow::Port* port = robot.program->program->find_fault(robot.frame.data()))
          robot.fault = port->path;
      }
      continue;
    }
    robot.action = {};
    robot.failure = std::move(outcome.failure);
    robot.life = RobotLife::kFaulted;
    robot.action.drives = true;  // tells step() that this fault is new
  }
}

std::optional<std::string> Fleet::set_native_parameter(FleetRobot& robot, std::string_view path,
                                                       const std::string& value) {
  const robot::NativeProgram& native = *robot.program->native;
  const wire::Port* port = native.find(path);
  if (port == nullptr) return fmt::format("the program of robot {} has no `{}`", robot.id.value, path);
  if (robot.lock_step == LockStep::kNone) return fmt::format("robot {} has not started", robot.id.value);
  if (auto problem = lock_step_.set(robot.lock_step, port->path(), value)) return problem;
  int index = 0;
  while (&native.description.ports(index) != port) ++index;
  robot.set_parameters[static_cast<std::uint32_t>(index)] = value;
  return std::nullopt;
}

void Fleet::take_over_native_parameters(FleetRobot& robot, const robot::NativeProgram& after) {
  if (robot.lock_step == LockStep::kNone || robot.life != RobotLife::kRunning) return;
  for (const wire::Port& port : after.description.ports()) {
    const wire::Port* before = robot.program->native->find(port.path());
    if (port.role() == wire::Port::OUTPUT || before == nullptr ||
        before->value().text() == port.value().text())
      continue;
    // It is a value that the new version's own process took: the old process takes it as well, or is another
    // version, and keeps what it has.
    static_cast<void>(lock_step_.set(robot.lock_step, port.path(), port.value().text()));
  }
}

}  // namespace mlab::fleet
