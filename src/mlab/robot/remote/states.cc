#include "mlab/robot/remote/states.h"

#include <cstring>

namespace mlab::robot_remote {

void encode(const std::byte* frame, std::size_t size, const flow::Interventions* interventions,
            wire::RobotState& out) {
  out.set_frame(frame, size);
  if (interventions == nullptr)
    out.clear_interventions();
  else
    out.set_interventions(interventions, sizeof *interventions);
}

std::expected<State, std::string> decode(const wire::RobotState& message, const flow::Program& program) {
  if (message.frame().size() != program.frame_size())
    return std::unexpected("values of another program came");
  State out{flow::Frame(program.frame_size()), nullptr};
  std::memcpy(out.frame.data(), message.frame().data(), out.frame.size());
  if (message.interventions().empty()) return out;
  if (message.interventions().size() != sizeof *out.interventions)
    return std::unexpected("interventions of another program came");
  out.interventions = std::make_unique<flow::Interventions>();
  std::memcpy(static_cast<void*>(out.interventions.get()), message.interventions().data(),
              sizeof *out.interventions);
  if (!out.interventions->are_of(program)) return std::unexpected("interventions of another program came");
  return out;
}

}  // namespace mlab::robot_remote
