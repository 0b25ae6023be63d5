#include "mlab/console/published/machines_encoder.h"

#include <map>
#include <utility>
#include <vector>

#include "mlab/console/published/overview.h"

namespace mlab::console {
namespace {

constexpr double kApart = 1.0;  // two looks [s]

struct Carried {
  std::vector<std::uint32_t> robots;
  std::vector<std::uint32_t> lost;  // by who had the machine's name before
};
using RobotsByMachine = std::map<std::string, Carried>;

RobotsByMachine robots_by_machine(const run::MissionRun& run) {
  RobotsByMachine out;
  for (const fleet::FleetRobot& robot : run.fleet().robots()) {
    if (robot.runner == nullptr) continue;
    if (const std::string name = robot.runner->machine(robot.member); !name.empty()) {
      Carried& there = out[name];
      (robot.runner->has_lost(robot.member) ? there.lost : there.robots).push_back(robot.id.value);
    }
    // Its body may be elsewhere than its program.
    if (robot.program != nullptr && robot.program->is_of_vehicle)
      out[robot.program->vehicle()].robots.push_back(robot.id.value);
  }
  return out;
}

// The enumerations count alike.
Machines::State state_of(WatchedMachine::State state) {
  static_assert(static_cast<int>(WatchedMachine::State::kGone) == Machines::GONE);
  return static_cast<Machines::State>(state);
}

void encode(const WatchedMachine& one, Machines::Machine& out) {
  out.set_name(clean(one.name));
  out.set_host(clean(one.host));
  out.set_state(state_of(one.state));
  out.set_heard(one.heard);
  if (one.link) {
    out.mutable_link()->set_round_trip(one.link->round_trip);
    out.mutable_link()->set_clock_offset(one.link->clock_offset);
    out.mutable_link()->set_lost(one.link->lost);
    out.mutable_link()->set_is_clock_known(one.link->is_clock_known);
  }
  out.set_carried(one.robots);
  out.set_runs(one.runs);
  out.set_load(one.load);
  out.set_processors(one.processors);
  out.set_free_memory(one.free_memory);
  out.set_uptime(one.uptime);
  out.set_version(clean(one.version));
  out.set_is_stopped(one.is_stopped);
  out.set_not_kept(clean(one.not_kept));
  out.set_offers(clean(one.offers));
  out.set_rival_host(clean(one.rival_host));
  out.set_vehicle(clean(one.vehicle));
}

}  // namespace

std::uint64_t MachineBoard::look(double wall, const run::MissionRun* run) {
  if (!watch_ || wall < looked_ + kApart) return revision_;
  looked_ = wall;
  const RobotsByMachine robots = run != nullptr ? robots_by_machine(*run) : RobotsByMachine{};
  Machines told;
  told.set_fleet(clean(watch_->fleet()));
  told.set_hint(clean(watch_->hint()));
  for (const WatchedMachine& one : watch_->look()) {
    Machines::Machine& machine = *told.add_machines();
    encode(one, machine);
    const auto at = robots.find(one.name);
    if (at == robots.end()) continue;
    for (const std::uint32_t robot : at->second.robots) machine.add_robots(robot);
    // One that is there again, or anew, has nothing of them; one that is gone had them last.
    if (one.state == WatchedMachine::State::kThere) continue;
    for (const std::uint32_t robot : at->second.lost) machine.add_robots(robot);
  }
  std::string bytes = told.SerializeAsString();
  if (bytes == told_bytes_) return revision_;
  told_bytes_ = std::move(bytes);
  told_ = std::move(told);
  return ++revision_;
}

}  // namespace mlab::console
