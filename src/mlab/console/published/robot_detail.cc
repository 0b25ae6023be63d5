#include "mlab/console/published/robot_detail.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <string_view>

#include <fmt/core.h>

#include "mlab/console/published/overview.h"
#include "mlab/console/published/wire.h"
#include "mlab/flow/port_types.h"
#include "mlab/mission/wording.h"

namespace mlab::console {
namespace {

using fleet::FleetRobot;
using fleet::RobotLife;

struct Beam {
  float angle, distance, hit;
};
struct SensedObstacle {
  float x, y, radius;
};

void encode_command(const run::MissionRun& run, const Estimates& estimates, const FleetRobot& robot,
                    RobotDetail& out) {
  out.set_remaining(-1.0);
  out.set_arrival(-1.0);
  const mission::State& state = run.state();
  const mission::RobotState* known = mission::find_robot(run.state(), robot.id);
  const fleet::Group* group = run.fleet().group(robot);
  if (group != nullptr && group->command) {
    const mission::Mission& mission = *state.mission;
    out.set_command(clean(mission::command_text(mission, *group->command)));
    out.set_task(std::string(mission::task_name(group->command->task)));
    out.set_unit(clean(mission::addressee(mission, *group->command)));
    const bool follows = group->order.task == percept::Task::kFollow && !group->order.route.empty();
    const geom::Point goal = follows ? group->order.route.back() : group->order.goal;
    if (!mission::info(group->command->task).is_shared) {  // else its goal is its own part, not this
      out.mutable_goal()->set_x(goal.x);
      out.mutable_goal()->set_y(goal.y);
    }
    if (robot.action.status.sequence == group->order.sequence &&
        std::isfinite(robot.action.status.remaining) && robot.action.status.remaining >= 0.0)
      out.set_remaining(robot.action.status.remaining);
  }
  if (known == nullptr || known->run >= state.runs.size()) return;
  const mission::Run& command = state.runs[known->run];
  out.set_command(clean(state.commands[command.record].text));
  out.set_unit(clean(state.commands[command.record].unit));
  if (command.phase == mission::Run::Phase::kRobots) out.set_arrival(estimates.arrival_of(command.record));
}

struct Arrow {
  std::uint32_t port;
  float x, y;
};

// What the last cycle computed. A constant belongs to the node whose input it is; parameters belong to all.
bool is_active(const flow::Program& program, const flow::Port& port, std::span<const std::uint32_t> ran) {
  const flow::Port* what = &port;
  if (port.role == flow::Port::Role::kConstant)
    what = program.find(std::string_view(port.path).substr(0, port.path.rfind('.')));
  const bool is_output = what != nullptr && what->role == flow::Port::Role::kOutput;
  return !is_output || std::ranges::binary_search(ran, what->offset);
}

void encode_ports(const FleetRobot& robot, const DetailWishes& wishes, RobotDetail& out) {
  const flow::Program& program = *robot.workings().program;
  const std::byte* const frame = robot.workings().frame;
  const std::vector<std::uint32_t> ran = program.ran(frame, wishes.before, robot.workings().interventions);
  if (wishes.some_ports) {
    out.set_has_some_ports(true);
    out.mutable_port_indices()->Assign(wishes.some_ports->begin(), wishes.some_ports->end());
    encode_port_values(program, frame, ran, *wishes.some_ports, *wishes.some_ports, out);
    return;
  }
  std::vector<std::uint32_t> all(program.ports().size());
  std::iota(all.begin(), all.end(), 0);
  encode_port_values(program, frame, ran, all, all, out);
}

void encode_readings(const run::MissionRun& run, const FleetRobot& robot, RobotDetail& out) {
  const percept::Needs needs = robot.workings().program->needs(robot.workings().frame);
  percept::Needs shown{{percept::Sensor::kObstacles, needs[percept::Sensor::kObstacles]}};
  if (robot.capabilities.range_sensors > 0) shown.want(percept::Sensor::kRanges);
  const percept::Percepts percepts = run.world().sense(robot.body, shown);
  for (const percept::RangeReading& beam : percepts.ranges)
    append(*out.mutable_ranges(), Beam{beam.angle, beam.distance, beam.hit ? 1.0F : 0.0F});
  for (const percept::Obstacle& obstacle : percepts.obstacles) {
    const geom::Point at = percepts.pose.point_at(obstacle.center);
    append(*out.mutable_obstacles(), SensedObstacle{static_cast<float>(at.x), static_cast<float>(at.y),
                                                    static_cast<float>(obstacle.radius)});
  }
}

// What was planned last: a way that nobody follows now is still the one that was.
void encode_ways(const flow::Program& program, const std::byte* frame, RobotDetail& out) {
  struct Corner {
    float x, y;
  };
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  for (const flow::Port& port : program.ports()) {
    if (port.role != flow::Port::Role::kOutput || port.type != &flow::type_info(flow::ValueType::kWay))
      continue;
    ways::PlannedWay way;
    std::memcpy(&way, frame + port.offset, sizeof way);
    if (way.count == 0) continue;
    if (!out.ways().empty()) append(*out.mutable_ways(), Corner{kNone, kNone});
    for (const geom::Point corner : way.points())
      append(*out.mutable_ways(), Corner{static_cast<float>(corner.x), static_cast<float>(corner.y)});
  }
}

void encode_program(const run::MissionRun& run, const FleetRobot& robot, const DetailWishes& wishes,
                    RobotDetail& out) {
  const flow::Program& program = *robot.workings().program;
  for (const std::string& state : program.active_states(robot.workings().frame)) out.add_states(clean(state));
  for (const flow::Contribution& part : program.contributions(robot.workings().frame)) {
    RobotDetail::Contribution& told = *out.add_contributions();
    told.set_sum(clean(part.sum));
    told.set_member(clean(part.member));
    told.set_x(part.weighted.x);
    told.set_y(part.weighted.y);
  }
  encode_ways(program, robot.workings().frame, out);
  if (wishes.ports) encode_ports(robot, wishes, out);
  if (wishes.readings && robot.life == RobotLife::kRunning) encode_readings(run, robot, out);
}

}  // namespace

void encode_port_values(const flow::Program& program, const std::byte* frame,
                        std::span<const std::uint32_t> ran, std::span<const std::uint32_t> which,
                        std::span<const std::uint32_t> told_as, RobotDetail& out) {
  for (std::size_t i = 0; i < which.size(); ++i) {
    const flow::Port& port = program.ports()[which[i]];
    out.add_ports(clean(flow::Program::print(frame, port)));
    append(*out.mutable_numbers(),
           flow::Program::number(frame, port).value_or(std::numeric_limits<double>::quiet_NaN()));
    if (const auto vector = flow::Program::vector(frame, port))
      append(*out.mutable_vectors(),
             Arrow{told_as[i], static_cast<float>(vector->x), static_cast<float>(vector->y)});
    out.mutable_active()->push_back(is_active(program, port, ran) ? '\1' : '\0');
  }
}

std::vector<std::uint32_t> port_indices(const flow::Program& program, std::span<const std::string> paths) {
  std::vector<std::uint32_t> out;
  for (const std::string& path : paths) {
    const flow::Port* port = program.find(path);
    if (port != nullptr) out.push_back(static_cast<std::uint32_t>(port - program.ports().data()));
  }
  std::ranges::sort(out);
  const auto [end, last] = std::ranges::unique(out);
  out.erase(end, last);
  return out;
}

std::vector<std::string> waits_for(const run::MissionRun& run, const FleetRobot& robot) {
  std::vector<std::string> out;
  if (robot.life == RobotLife::kNotStarted) return {"the robot has not been started"};
  const mission::State& state = run.state();
  if (run.is_stopped()) out.emplace_back("an emergency stop holds all robots until it is released");
  if (state.paused) out.emplace_back("the run is paused");
  const mission::RobotState* known = mission::find_robot(run.state(), robot.id);
  if (known != nullptr && known->run < state.runs.size()) {
    const mission::Run& command = state.runs[known->run];
    out.push_back(fmt::format("`{}` waits for {}", state.commands[command.record].text,
                              mission::waiting_text(state, command)));
    const fleet::Group* group = run.fleet().group(robot);
    if (known->done)
      out.emplace_back("this robot is done with it");
    else if (group != nullptr && group->order.halted)
      out.emplace_back("this robot holds while another part of the unit moves, or at a phase line");
    else if (std::isfinite(known->remaining))
      out.push_back(fmt::format("this robot has {:.1f} m to go", known->remaining));
  } else if (robot.life == RobotLife::kRunning) {
    out.emplace_back("no command waits for this robot");
  }
  if (robot.workings().program && robot.life == RobotLife::kRunning) {
    for (const auto& way : robot.workings().program->ways_out(robot.workings().frame)) {
      out.push_back(fmt::format("{} leaves {} for {} when `{}` is {}; now it is {}", way.sequence, way.state,
                                way.target, way.trigger, !way.is_negated, way.trigger_value));
    }
  }
  for (std::string& line : run.explain(robot)) out.push_back(std::move(line));
  for (std::string& line : out) line = clean(line);
  return out;
}

void encode_detail(const run::MissionRun& run, const Estimates& estimates, const FleetRobot& robot,
                   const DetailWishes& wishes, RobotDetail& out) {
  out.set_id(robot.id.value);
  out.set_life(std::string(name(robot.life)));
  out.set_fault(clean(failure_of(robot)));
  out.set_failsafe(clean(run.fleet().failsafe(robot)));
  if (robot.runner != nullptr) out.set_machine(clean(robot.runner->machine(robot.member)));
  if (robot.workings().program) encode_program(run, robot, wishes, out);
  if (robot.life == RobotLife::kNotStarted) {
    out.set_remaining(-1.0);
    out.set_arrival(-1.0);
    return;
  }
  const geom::Pose pose = run.fleet().pose(robot);
  out.set_x(pose.position.x);
  out.set_y(pose.position.y);
  out.set_heading(pose.heading);
  const binding::BodyState body = run.world().body(robot.body);
  out.set_speed(geom::length(body.velocity));
  out.set_distance_driven(body.distance_driven);
  out.set_contacts(body.contacts);
  out.set_carried(body.carried.value);
  encode_command(run, estimates, robot, out);
  if (const auto station = run.fleet().station_place(robot)) {
    out.mutable_station()->set_x(station->x);
    out.mutable_station()->set_y(station->y);
    out.set_station_error(run.fleet().station_error(robot));
  }
}

}  // namespace mlab::console
