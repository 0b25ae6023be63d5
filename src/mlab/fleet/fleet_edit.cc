#include <algorithm>
#include <cstring>
#include <map>
#include <utility>

#include "mlab/fleet/fleet.h"

namespace mlab::fleet {
namespace {

// What the new version of the program sets to another value than the old one holds from now on; the rest of
// the frame is the robot's own.
void take_over_parameters(const robot::RobotProgram& before, const robot::RobotProgram& after,
                          flow::Frame& frame) {
  for (const flow::Port& port : after.program->ports()) {
    if (port.role == flow::Port::Role::kOutput) continue;
    const std::byte* const old_value = before.initial.data() + port.offset;
    const std::byte* const new_value = after.initial.data() + port.offset;
    if (std::memcmp(old_value, new_value, port.type->size) != 0)
      std::memcpy(frame.data() + port.offset, new_value, port.type->size);
  }
}

}  // namespace

void Fleet::edit(const mission::Mission& mission, const std::vector<robot::RobotProgram>& programs,
                 const std::vector<sim::BodySpec>& bodies) {
  std::vector<FleetRobot> robots;
  std::map<base::RobotId, std::uint32_t> places;  // of robots that stay, before
  for (std::uint32_t i = 0; i < robots_.size(); ++i) places[robots_[i].id] = i;
  std::vector<std::uint32_t> moved_to(robots_.size(), FleetRobot::kNoGroup);
  for (const mission::Robot& declared : mission.robots) {
    const auto at = places.find(declared.id);
    FleetRobot fresh = make_robot(mission, declared, programs, bodies);
    if (at == places.end()) {
      robots.push_back(std::move(fresh));
      continue;
    }
    FleetRobot& known = robots_[at->second];
    const bool same_native = fresh.program->native && known.program->native &&
                             fresh.program->native->executable == known.program->native->executable;
    const bool same_program =
        same_native || (fresh.program->program && fresh.program->program == known.program->program);
    if (known.life == RobotLife::kNotStarted) {
      if (same_program) fresh.set_parameters = known.set_parameters;
      fresh.group = known.group;
      fresh.rank = known.rank;
      known = std::move(fresh);
    } else if (same_native) {
      take_over_native_parameters(known, *fresh.program->native);
      known.program = fresh.program;
    } else if (same_program) {
      take_over_parameters(*known.program, *fresh.program, known.frame);
      known.program = fresh.program;
    }
  }
  // A robot that is in the world stays there, whatever the plan says.
  for (std::uint32_t i = 0; i < robots_.size(); ++i) {
    const bool is_planned =
        std::ranges::binary_search(mission.robots, robots_[i].id, {}, &mission::Robot::id);
    if (is_planned || robots_[i].life != RobotLife::kNotStarted)
      robots.push_back(robots_[i]);
    else
      leave_group(i);
  }
  std::sort(robots.begin(), robots.end(),
            [](const FleetRobot& a, const FleetRobot& b) { return a.id < b.id; });
  for (std::uint32_t i = 0; i < robots.size(); ++i) {
    if (const auto at = places.find(robots[i].id); at != places.end()) moved_to[at->second] = i;
  }
  for (Group& group : groups_) {
    for (std::uint32_t& member : group.members) member = moved_to[member];
  }
  robots_ = std::move(robots);
  poses_.assign(robots_.size(), {});
  update_poses();
  form_teams(mission);
}

bool Fleet::uses(const std::vector<robot::RobotProgram>& programs) const {
  return std::any_of(robots_.begin(), robots_.end(), [&](const FleetRobot& robot) {
    return robot.program >= programs.data() && robot.program < programs.data() + programs.size();
  });
}

}  // namespace mlab::fleet
