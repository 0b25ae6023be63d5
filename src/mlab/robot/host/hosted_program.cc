#include "mlab/robot/host/hosted_program.h"

#include <utility>

namespace mlab::robot_host {

std::expected<StartedProgram, std::string> start_hosted(const HostedProgram& program,
                                                        const SharedMemory* memory) {
  auto process = RobotProgramProcess::start(program.launch, program.limits, memory);
  if (!process) return std::unexpected(process.error());
  if (program.source != 0 && process->source() != program.source)
    return std::unexpected(
        "was built anew meanwhile: it is another program than the one that was begun with");
  StartedProgram out{std::move(*process), {}};
  if (program.load) {
    wire::ToRobot message;
    *message.mutable_load() = *program.load;
    const wire::FromRobot* answer = out.process.ask(message, wire::FromRobot::kLoaded);
    if (answer == nullptr) return std::unexpected(out.process.failure());
    out.loaded = answer->loaded();
  }
  if (memory == nullptr) return out;
  wire::ToRobot message;
  message.mutable_share()->set_layout(robot_wire::shared_layout());
  const wire::FromRobot* answer = out.process.ask(message, wire::FromRobot::kShared);
  if (answer == nullptr) return std::unexpected(out.process.failure());
  if (answer->shared().frame_layout() != program.frame_layout)
    return std::unexpected("is another program than the one that was checked");
  return out;
}

}  // namespace mlab::robot_host
