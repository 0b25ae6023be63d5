#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "mlab/fleet/fleet.h"

namespace mlab::fleet {

std::expected<FleetCheckpoint, std::string> Fleet::save() const {
  FleetCheckpoint out;
  out.state = now_;
  out.memories.reserve(now_.robots.size());
  for (FleetRobot& robot : out.state.robots) {
    robot::ProgramRunner* const runner = std::exchange(robot.runner, nullptr);
    if (runner == nullptr) {
      out.memories.emplace_back();
      continue;
    }
    std::expected<robot::RobotMemory, std::string> memory = runner->memory(std::exchange(robot.member, 0));
    if (!memory) return std::unexpected(fmt::format("robot {}: {}", robot.id.value, memory.error()));
    out.memories.push_back(std::move(*memory));
  }
  return out;
}

void Fleet::restore(const FleetCheckpoint& checkpoint) {
  FleetState next = checkpoint.state;
  for (std::size_t i = 0; i < next.robots.size(); ++i) enrol_again(next.robots[i], checkpoint.memories[i]);
  for (const FleetRobot& robot : now_.robots) {
    const auto at = std::ranges::lower_bound(next.robots, robot.id, {}, &FleetRobot::id);
    const bool is_kept = at != next.robots.end() && at->id == robot.id && at->runner == robot.runner &&
                         at->member == robot.member;
    if (!is_kept) dismiss(robot);
  }
  now_ = std::move(next);
  bodies_.clear();
  std::size_t bodies = 0;
  for (const FleetRobot& robot : now_.robots) {
    bodies_.push_back(robot.body);
    if (robot.body != binding::kNoBody) bodies = std::max<std::size_t>(bodies, robot.body.value + 1U);
  }
  actions_.assign(bodies, {});
}

// Who is here already keeps its place, and so its process.
void Fleet::enrol_again(FleetRobot& robot, const robot::RobotMemory& memory) {
  robot.runner = runners_.runner_of(*robot.program);
  if (robot.runner == nullptr) return;
  const FleetRobot* const known = find(robot.id);
  robot.member = known != nullptr && known->runner == robot.runner
                     ? known->member
                     : robot.runner->add(robot.id, *robot.program);
  robot.runner->remember(robot.member, memory);
}

}  // namespace mlab::fleet
