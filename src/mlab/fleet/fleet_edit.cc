#include <algorithm>
#include <functional>
#include <map>
#include <utility>

#include "mlab/fleet/fleet.h"
#include "mlab/robot/program/robot_values.h"

namespace mlab::fleet {

void Fleet::edit(const mission::Mission& mission, const std::vector<robot::RobotProgram>& programs,
                 const std::vector<binding::BodySpec>& bodies) {
  edit(mission, programs, bodies, [](FleetRobot&, const robot::RobotProgram&) {});
}

std::vector<base::RobotId> Fleet::take_over(const mission::Mission& mission,
                                            const std::vector<robot::RobotProgram>& programs,
                                            const std::vector<binding::BodySpec>& bodies,
                                            std::vector<std::pair<base::RobotId, flow::Restart>>& restarts) {
  std::vector<base::RobotId> out;
  edit(mission, programs, bodies, [&](FleetRobot& robot, const robot::RobotProgram& after) {
    out.push_back(robot.id);
    for (flow::Restart& restart : exchange_program(robot, after))
      restarts.emplace_back(robot.id, std::move(restart));
  });
  std::ranges::sort(out);
  return out;
}

// The robot's body knows nothing of it.
std::vector<flow::Restart> Fleet::exchange_program(FleetRobot& robot, const robot::RobotProgram& after) {
  robot::ProgramRunner* const runner = runners_.runner_of(after);
  const robot::ProgramRunner::Member member = runner->add(robot.id, after);
  // Where it needs a process it is given one; what it begins with is put in place of then.
  std::vector<flow::Restart> restarts;
  if (const auto problem = runner->start(member)) restarts.push_back({after.type, *problem});
  // Of a program that is only known by what it answered there is nothing to go on from.
  if (const robot::RobotValues* const before = robot.runner->values(robot.member)) {
    std::vector<flow::Restart> anew = runner->go_on_from(member, *before);
    restarts.insert(restarts.end(), anew.begin(), anew.end());
  }
  dismiss(robot);
  robot.runner = runner;
  robot.member = member;
  robot.program = &after;
  return restarts;
}

void Fleet::edit(const mission::Mission& mission, const std::vector<robot::RobotProgram>& programs,
                 const std::vector<binding::BodySpec>& bodies,
                 const std::function<void(FleetRobot&, const robot::RobotProgram&)>& exchange) {
  std::vector<FleetRobot> robots;
  std::map<base::RobotId, std::uint32_t> places;  // of robots that stay, before
  for (std::uint32_t i = 0; i < now_.robots.size(); ++i) places[now_.robots[i].id] = i;
  std::vector<std::uint32_t> moved_to(now_.robots.size(), FleetRobot::kNoGroup);
  for (const mission::Robot& declared : mission.robots) {
    const auto at = places.find(declared.id);
    FleetRobot fresh = make_robot(mission, declared, programs, bodies);
    if (at == places.end()) {
      enrol(fresh);
      robots.push_back(std::move(fresh));
      continue;
    }
    FleetRobot& known = now_.robots[at->second];
    const bool is_running = known.life == RobotLife::kRunning;
    const bool keeps_program =
        known.runner != nullptr && known.runner->take_over(known.member, *fresh.program, is_running);
    if (known.life == RobotLife::kNotStarted) {
      if (keeps_program) {
        fresh.runner = known.runner;
        fresh.member = known.member;
      } else {
        dismiss(known);
        enrol(fresh);
      }
      fresh.group = known.group;
      fresh.rank = known.rank;
      known = std::move(fresh);
    } else if (keeps_program) {
      known.program = fresh.program;
    } else {
      exchange(known, *fresh.program);
    }
  }
  // A robot that is in the world stays there, whatever the plan says.
  for (std::uint32_t i = 0; i < now_.robots.size(); ++i) {
    const bool is_planned =
        std::ranges::binary_search(mission.robots, now_.robots[i].id, {}, &mission::Robot::id);
    if (is_planned || now_.robots[i].life != RobotLife::kNotStarted) {
      robots.push_back(now_.robots[i]);
    } else {
      leave_groups({&i, 1});
      dismiss(now_.robots[i]);
    }
  }
  std::sort(robots.begin(), robots.end(),
            [](const FleetRobot& a, const FleetRobot& b) { return a.id < b.id; });
  for (std::uint32_t i = 0; i < robots.size(); ++i) {
    if (const auto at = places.find(robots[i].id); at != places.end()) moved_to[at->second] = i;
  }
  for (Group& group : now_.groups) {
    for (std::uint32_t& member : group.members) member = moved_to[member];
  }
  now_.robots = std::move(robots);
  bodies_.clear();
  for (const FleetRobot& robot : now_.robots) bodies_.push_back(robot.body);
  now_.poses.assign(now_.robots.size(), {});
  update_poses();
  adopt(mission);
}

void Fleet::adopt(const mission::Mission& mission) {
  form_teams(mission);
  exchange_failsafes(mission);
  exchange_ground(mission);
  now_.assigns_stations = mission.options.assigns_stations;
}

// On another map nobody knows what was sensed on the one before.
void Fleet::exchange_ground(const mission::Mission& mission) {
  auto map = std::make_shared<const TeamGround>(mission.overlay);
  if (now_.map && now_.map->view().revision == map->view().revision) return;
  now_.map = std::move(map);
  now_.grounds.clear();
}

// Where the table is another one nothing has happened yet.
void Fleet::exchange_failsafes(const mission::Mission& mission) {
  const auto is_same = [](const mission::Failsafe& a, const mission::Failsafe& b) { return a.is_same(b); };
  const bool has_changed = !std::ranges::equal(now_.failsafes->rows(), mission.failsafes, is_same);
  if (has_changed) now_.failsafes = std::make_shared<const Failsafes>(mission.failsafes);
  now_.seen.clear();
  if (!now_.failsafes->empty()) now_.seen.resize(now_.robots.size());
  now_.area = mission.overlay.mission_area();
  for (FleetRobot& robot : now_.robots) {
    robot.failsafes = now_.failsafes->rows_of(robot.type);
    if (has_changed) robot.failsafe = {};
  }
}

bool Fleet::uses(const std::vector<robot::RobotProgram>& programs) const {
  return std::any_of(now_.robots.begin(), now_.robots.end(), [&](const FleetRobot& robot) {
    return robot.program >= programs.data() && robot.program < programs.data() + programs.size();
  });
}

}  // namespace mlab::fleet
