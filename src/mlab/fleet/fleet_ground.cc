// What teams know of the ground: what their robots find and miss on it.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "mlab/fleet/fleet.h"

namespace mlab::fleet {

const TeamGround& Fleet::ground_of(const FleetRobot& robot) const {
  const auto own = now_.grounds.find(robot.team);
  return own == now_.grounds.end() ? *now_.map : *own->second;
}

// What doesn't run, and isn't driven by a failsafe, moves no more until somebody starts it again. Small
// bodies are passed by those who see them, and nothing is planned for them.
bool Fleet::is_wreck(const FleetRobot& robot) const {
  return robot.life != RobotLife::kRunning && robot.life != RobotLife::kNotStarted &&
         robot.capabilities.radius >= TeamGround::kSmallest &&
         !(robot.life == RobotLife::kFaulted && now_.failsafes->drives(robot.failsafe));
}

bool Fleet::is_of_wreck(geom::Point place) const {
  return std::ranges::any_of(now_.robots, [&](const FleetRobot& robot) {
    return is_wreck(robot) && distance(pose(robot).position, place) <= TeamGround::kSame;
  });
}

void Fleet::note_found(std::uint32_t robot, const percept::Percepts& percepts, double reach,
                       Worker& worker) const {
  const TeamGround& ground = ground_of(now_.robots[robot]);
  for (const percept::Obstacle& one : percepts.obstacles) {
    if (one.is_moving()) continue;  // it will be elsewhere
    const geom::Point place = percepts.pose.point_at(one.center);
    if (!ground.knows(place)) worker.found.push_back({robot, {place, one.radius}});
  }
  for (const percept::RobotReading& one : percepts.robots) {
    if (one.radius < TeamGround::kSmallest || !(reach > 0.0)) continue;  // whom it can miss, too
    const FleetRobot* const other = find(one.id);
    if (other == nullptr || !is_wreck(*other)) continue;
    const geom::Point place = percepts.pose.point_at(one.center);
    if (!ground.knows(place)) worker.found.push_back({robot, {place, one.radius}});
  }
  // Once a second or so, not all robots at once.
  const auto every = static_cast<std::int64_t>(std::max(1.0, std::round(1.0 / percepts.cycle_duration)));
  const auto cycle = static_cast<std::int64_t>(percepts.time / percepts.cycle_duration);
  if ((cycle + robot) % every != 0) return;
  for (const geom::Point place : ground.missed(percepts.pose, reach, percepts.obstacles)) {
    if (!is_of_wreck(place)) worker.missed.emplace_back(robot, place);
  }
}

void Fleet::add_found() {
  // Those of a robot are together and in order, whichever thread found them.
  const auto by_team = [&]<class Thing>(std::vector<std::pair<std::uint32_t, Thing>> Worker::* list) {
    std::vector<std::pair<std::uint32_t, Thing>> all;
    for (Worker& worker : workers_) {
      all.insert(all.end(), (worker.*list).begin(), (worker.*list).end());
      (worker.*list).clear();
    }
    std::ranges::stable_sort(all, {}, [](const auto& found) { return found.first; });
    std::map<std::uint32_t, std::vector<Thing>> out;
    for (const auto& [robot, thing] : all) out[now_.robots[robot].team].push_back(thing);
    return out;
  };
  const auto change = [&](std::uint32_t team, const auto& changed) {
    const auto own = now_.grounds.find(team);
    if (auto after = changed(own == now_.grounds.end() ? *now_.map : *own->second))
      now_.grounds[team] = std::move(after);
  };
  for (const auto& [team, places] : by_team(&Worker::missed))
    change(team, [&](const TeamGround& before) { return before.without(places); });
  for (const auto& [team, things] : by_team(&Worker::found))
    change(team, [&](const TeamGround& before) { return before.with(things); });
}

}  // namespace mlab::fleet
