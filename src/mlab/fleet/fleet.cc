#include "mlab/fleet/fleet.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstring>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "mlab/percept/object_colors.h"

namespace mlab::fleet {
namespace {

constexpr std::size_t kRobotsPerPiece = 32;
// Reading the clock costs as much as sensing does: only every so often is a robot's time taken, and counted
// so often.
constexpr std::uint64_t kTimedEvery = 16;

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double parameter(const robot::RobotProgram& program, std::string_view name, double otherwise) {
  if (program.native) {
    const wire::Port* port = program.native->find(name);
    return port != nullptr && port->value().has_number() ? port->value().number() : otherwise;
  }
  if (!program.program) return otherwise;
  const flow::Port* port = program.program->find(name);
  if (port == nullptr) return otherwise;
  return flow::Program::number(program.initial.data(), *port).value_or(otherwise);
}

}  // namespace

std::string_view name(RobotLife life) {
  constexpr std::array<std::string_view, 5> kNames = {"not started", "running", "parked", "stopped", "fault"};
  return kNames[static_cast<std::size_t>(life)];
}

Fleet::Fleet(const mission::Mission& mission, const std::vector<robot::RobotProgram>& programs,
             const std::vector<sim::BodySpec>& bodies, sim::Simulator& simulator, std::uint64_t seed)
    : simulator_(simulator),
      seed_(seed),
      workers_(static_cast<std::size_t>(simulator.workers().count())),
      lock_step_(simulator.workers().count(), seed) {
  for (const mission::Robot& declared : mission.robots)
    robots_.push_back(make_robot(mission, declared, programs, bodies));
  std::sort(robots_.begin(), robots_.end(),
            [](const FleetRobot& a, const FleetRobot& b) { return a.id < b.id; });
  poses_.resize(robots_.size());
  form_teams(mission);
}

/// A team is the outermost unit that a robot belongs to; a robot of no unit is a team of its own.
void Fleet::form_teams(const mission::Mission& mission) {
  constexpr std::uint32_t kAlone = 0x80000000U;
  for (FleetRobot& robot : robots_) robot.team = kAlone + robot.id.value;
  std::vector<bool> is_part(mission.units.size());
  for (const mission::Unit& unit : mission.units) {
    for (const std::uint32_t part : unit.parts) is_part[part] = true;
  }
  for (std::uint32_t i = 0; i < mission.units.size(); ++i) {
    if (is_part[i]) continue;
    for (const base::RobotId id : mission.units[i].members) {
      const FleetRobot* const member = find(id);
      if (member != nullptr && member->team >= kAlone) robots_[index_of(*member)].team = i;
    }
  }
}

FleetRobot Fleet::make_robot(const mission::Mission& mission, const mission::Robot& declared,
                             const std::vector<robot::RobotProgram>& programs,
                             const std::vector<sim::BodySpec>& bodies) {
  FleetRobot robot;
  robot.id = declared.id;
  robot.type = mission.types[declared.type].name;
  robot.program = &programs[declared.type];
  robot.body_spec = bodies[declared.type];
  robot.seen_as = percept::object_class_of_color(mission.types[declared.type].color)
                      .value_or(percept::ObjectClass::kUnknown);
  if (robot.program->program) {
    robot.frame = robot.program->initial;
    if (robot.program->program->has_asynchronous() && !robot.program->hosted && !async_)
      async_ = std::make_unique<flow::AsyncRunner>(1);
  }
  return robot;
}

const FleetRobot* Fleet::find(base::RobotId id) const {
  const auto at =
      std::lower_bound(robots_.begin(), robots_.end(), id,
                       [](const FleetRobot& robot, base::RobotId wanted) { return robot.id < wanted; });
  return at != robots_.end() && at->id == id ? &*at : nullptr;
}

std::optional<sim::Placement> Fleet::start(base::RobotId id, geom::Pose pose) {
  const FleetRobot* found = find(id);
  if (found == nullptr || found->life == RobotLife::kRunning || found->life == RobotLife::kParked)
    return std::nullopt;
  const std::size_t index = index_of(*found);
  FleetRobot& robot = robots_[index];
  if (robot.life != RobotLife::kNotStarted) simulator_.remove_body(robot.body);  // started anew
  const std::optional<sim::Placement> placement =
      simulator_.add_body({robot.body_spec, pose, id, 0, robot.seen_as});
  if (!placement) return std::nullopt;
  robot.body = placement->body;
  robot.start = placement->pose;
  start_program(robot);
  poses_[index] = placement->pose;
  actions_.resize(simulator_.body_count());
  return placement;
}

void Fleet::start_program(FleetRobot& robot) {
  robot.life = robot.program->can_run() ? RobotLife::kRunning : RobotLife::kParked;
  robot.fault.clear();
  robot.failure.clear();
  robot.notifications.clear();
  if (const auto& native = robot.program->native) {
    robot_host::Settings own;
    for (const auto& [port, value] : robot.set_parameters)
      own.emplace_back(native->description.ports(static_cast<int>(port)).path(), value);
    auto member = lock_step_.start(robot.lock_step, robot.id.value, native, own);
    if (member) {
      robot.lock_step = *member;
      return;
    }
    robot.failure = member.error();
    robot.life = RobotLife::kFaulted;
    new_faults_.push_back(robot.id);
    return;
  }
  if (robot.program->is_described_only) {
    robot.failure = "brings procedures that were only checked";
    robot.life = RobotLife::kFaulted;
    new_faults_.push_back(robot.id);
    return;
  }
  if (robot.program->hosted)
    robot.lock_step = lock_step_.host(robot.lock_step, robot.id.value, robot.program->hosted);
  robot.frame = robot.program->initial;
  for (const auto& [port, value] : robot.set_parameters)
    robot.program->program->set(robot.frame.data(), robot.program->program->ports()[port], value);
}

void Fleet::leave_group(std::uint32_t index) {
  FleetRobot& robot = robots_[index];
  if (robot.group == FleetRobot::kNoGroup) return;
  Group& group = groups_[robot.group];
  std::erase(group.members, index);
  if (group.members.empty()) {
    group = {};
    free_groups_.push_back(robot.group);
  } else {
    for (std::size_t rank = 0; rank < group.members.size(); ++rank) {
      robots_[group.members[rank]].rank = static_cast<std::uint32_t>(rank);
    }
  }
  robot.group = FleetRobot::kNoGroup;
}

void Fleet::order(const mission::effect::Order& effect) {
  Group group;
  group.order = effect.order;
  group.command = effect.command;
  for (const base::RobotId id : effect.members) {
    if (const FleetRobot* robot = find(id))
      group.members.push_back(static_cast<std::uint32_t>(index_of(*robot)));
  }
  if (group.members.empty()) return;
  const FleetRobot& leader = robots_[group.members.front()];
  // A formation goes on looking where it looked, whichever order it gets next.
  if (leader.group != FleetRobot::kNoGroup) {
    const Group& before = groups_[leader.group];
    group.formation_heading = before.formation_heading;
    if (before.members == group.members) {
      group.center = before.center;
      group.has_center = before.has_center;
    }
  } else {
    group.formation_heading = leader.start.heading;
  }
  group.spacing = parameter(*leader.program, "formation_spacing", group.spacing);
  group.slop = parameter(*leader.program, "formation_slop", group.slop);
  group.heading_trigger = parameter(*leader.program, "formation_default_trigger", group.heading_trigger);

  // All members may come out of one group: dissolve it at once, not one by one.
  std::vector<std::uint32_t> touched;
  for (const std::uint32_t member : group.members) {
    FleetRobot& robot = robots_[member];
    if (robot.group != FleetRobot::kNoGroup && (touched.empty() || touched.back() != robot.group))
      touched.push_back(robot.group);
    if (robot.group != FleetRobot::kNoGroup) robot.rank = FleetRobot::kLeaving;
  }
  std::sort(touched.begin(), touched.end());
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  for (const std::uint32_t old : touched) {
    std::erase_if(groups_[old].members,
                  [&](std::uint32_t member) { return robots_[member].rank == FleetRobot::kLeaving; });
    if (groups_[old].members.empty()) {
      groups_[old] = {};
      free_groups_.push_back(old);
    }
    for (std::size_t rank = 0; rank < groups_[old].members.size(); ++rank) {
      robots_[groups_[old].members[rank]].rank = static_cast<std::uint32_t>(rank);
    }
  }
  auto slot = static_cast<std::uint32_t>(groups_.size());
  if (!free_groups_.empty()) {
    slot = free_groups_.back();
    free_groups_.pop_back();
  } else {
    groups_.emplace_back();
  }
  for (std::size_t rank = 0; rank < group.members.size(); ++rank) {
    FleetRobot& robot = robots_[group.members[rank]];
    robot.group = slot;
    robot.rank = static_cast<std::uint32_t>(rank);
    if (robot.life == RobotLife::kRunning || robot.life == RobotLife::kParked)
      simulator_.set_unit(robot.body, slot + 1);
  }
  groups_[slot] = std::move(group);
}

void Fleet::stop(base::RobotId id) {
  const FleetRobot* found = find(id);
  if (found == nullptr || found->life == RobotLife::kNotStarted) return;
  const auto index = static_cast<std::uint32_t>(index_of(*found));
  leave_group(index);
  robots_[index].life = RobotLife::kStopped;
  robots_[index].action = {};
}

void Fleet::set_joystick(base::RobotId id, const percept::Joystick& joystick) {
  if (const FleetRobot* found = find(id)) robots_[index_of(*found)].joystick = joystick;
}

const Group* Fleet::group(const FleetRobot& robot) const {
  return robot.group == FleetRobot::kNoGroup ? nullptr : &groups_[robot.group];
}

double Fleet::station_error(const FleetRobot& robot) const {
  return robot.group == FleetRobot::kNoGroup ? 0.0
                                             : fleet::station_error(groups_[robot.group], robot.rank, poses_);
}

std::optional<geom::Point> Fleet::station_place(const FleetRobot& robot) const {
  if (robot.group == FleetRobot::kNoGroup) return std::nullopt;
  return fleet::station_place(groups_[robot.group], robot.rank, poses_);
}

void Fleet::update_poses() {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    if (robots_[i].life != RobotLife::kNotStarted) poses_[i] = simulator_.pose(robots_[i].body);
  }
}

void Fleet::step(double dt) {
  update_poses();
  for (Group& group : groups_) update_group(group, poses_);
  lock_step_.begin();
  for (const FleetRobot& robot : robots_) {
    if (robot.life == RobotLife::kRunning && robot.program->has_process()) lock_step_.join(robot.lock_step);
  }
  lock_step_.open();
  simulator_.workers().run(robots_.size(), kRobotsPerPiece,
                           [&](std::size_t begin, std::size_t end, int worker) {
                             for (std::size_t i = begin; i < end; ++i) {
                               if (robots_[i].life == RobotLife::kRunning)
                                 run_program(robots_[i], dt, workers_[static_cast<std::size_t>(worker)]);
                             }
                           });
  run_lock_step();
  for (percept::Action& action : actions_) action = {};
  for (FleetRobot& robot : robots_) {
    if (robot.life == RobotLife::kFaulted && robot.action.drives) {
      robot.action = {};
      new_faults_.push_back(robot.id);
    }
    if (robot.life != RobotLife::kRunning) continue;
    actions_[robot.body.value] = robot.action;
    note_calls(robot);
  }
  messages_.resolve(robots_, simulator_.time());
  simulator_.step(actions_, dt);
  update_poses();
  times_ = {};
  for (const Worker& worker : workers_) {
    times_.sense += worker.sense;
    times_.behave += worker.behave;
  }
}

void Fleet::brake(double dt) {
  for (percept::Action& action : actions_) action = {};
  for (FleetRobot& robot : robots_) {
    const percept::OrderStatus status = robot.action.status;
    robot.action = {};
    robot.action.status = status;
  }
  simulator_.step(actions_, dt);
  update_poses();
}

Fleet::Bodies Fleet::bodies() const {
  Bodies out;
  for (const FleetRobot& robot : robots_) {
    if (robot.life == RobotLife::kNotStarted) continue;
    ++out.all;
    if (geom::length(simulator_.velocity(robot.body)) > 0.0) ++out.moving;
  }
  return out;
}

std::optional<std::string> Fleet::set_parameter(base::RobotId id, std::string_view path,
                                                const std::string& value) {
  const FleetRobot* found = find(id);
  if (found == nullptr) return fmt::format("there is no robot {}", id.value);
  FleetRobot& robot = robots_[index_of(*found)];
  if (robot.program->native) return set_native_parameter(robot, path, value);
  if (!robot.program->program) return fmt::format("robot {} has no program", id.value);
  const flow::Program& program = *robot.program->program;
  const flow::Port* port = program.find(path);
  if (port == nullptr) return fmt::format("the program of robot {} has no `{}`", id.value, path);
  if (auto problem = program.set(robot.frame.data(), *port, value)) return problem;
  robot.set_parameters[static_cast<std::uint32_t>(port - program.ports().data())] = value;
  return std::nullopt;
}

void Fleet::perceive(const FleetRobot& robot, const flow::Needs& needs, double dt, Worker& worker,
                     percept::Percepts& out) {
  simulator_.sense(robot.body, {needs.obstacles, needs.robots, needs.objects, 0, needs.ranges}, worker.buffer,
                   out);
  add_told(robot, dt, out);
}

void Fleet::perceive_at(const FleetRobot& robot, const geom::Pose& pose, const flow::Needs& needs, double dt,
                        sim::SenseBuffer& buffer, percept::Percepts& out) const {
  simulator_.sense_at(robot.body, pose, {needs.obstacles, needs.robots, needs.objects, 0, needs.ranges},
                      buffer, out);
  add_told(robot, dt, out);
}

void Fleet::add_told(const FleetRobot& robot, double dt, percept::Percepts& out) const {
  out.cycle_duration = dt;
  if (robot.group != FleetRobot::kNoGroup) {
    out.order = groups_[robot.group].order;
    out.unit = unit_percept(groups_[robot.group], robot.rank, poses_);
  } else {
    out.unit.center = out.pose.position;
    out.unit.leader = out.unit.neighbor = out.pose;
  }
  out.joystick = robot.joystick;
  out.id = robot.id;
  out.notifications = robot.notifications;
  out.shared_places = messages_.places();
  out.claims = messages_.claims(robot.team);
}

// Its frame may hold anything, and what a stranger's program wants is no reason to look farther than there is
// a world, or nowhere.
flow::Needs Fleet::needs_of_hosted(const FleetRobot& robot) {
  flow::Needs out = robot.program->program->needs(robot.frame.data());
  for (double* range : {&out.obstacles, &out.robots, &out.objects})
    *range = std::isfinite(*range) ? std::clamp(*range, 0.0, 1e9) : 0.0;
  return out;
}

// An action that is no number stops the robot.
void Fleet::check_action(FleetRobot& robot) {
  const geom::Vector v = robot.action.velocity;
  if (std::isfinite(v.x + v.y + v.z + robot.action.spin)) return;
  if (robot.fault.empty()) robot.fault = "its action";
  robot.life = RobotLife::kFaulted;
  robot.action.drives = true;  // tells step() that this fault is new
}

void Fleet::run_program(FleetRobot& robot, double dt, Worker& worker) {
  const bool is_timed = worker.steps++ % kTimedEvery == 0;
  const double t0 = is_timed ? seconds() : 0.0;
  percept::Percepts percepts;
  if (robot.program->has_process()) {
    const flow::Needs needs =
        robot.program->hosted ? needs_of_hosted(robot) : lock_step_.needs(robot.lock_step);
    perceive(robot, needs, dt, worker, percepts);
    lock_step_.percepts(robot.lock_step, percepts, robot.frame);
    if (is_timed) worker.sense += (seconds() - t0) * kTimedEvery;
    return;
  }
  const flow::Program& program = *robot.program->program;
  perceive(robot, program.needs(robot.frame.data()), dt, worker, percepts);
  const double t1 = is_timed ? seconds() : 0.0;
  robot.action = {};
  program.step(robot.frame.data(), percepts, robot.action, seed_, robot.id.value, async_.get());
  check_action(robot);
  if (robot.life == RobotLife::kFaulted) {
    if (const flow::Port* port = program.find_fault(robot.frame.data())) robot.fault = port->path;
  }
  if (is_timed) {
    worker.sense += (t1 - t0) * kTimedEvery;
    worker.behave += (seconds() - t1) * kTimedEvery;
  }
}

void Fleet::report(std::vector<mission::RobotReport>& out) const {
  out.clear();
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const FleetRobot& robot = robots_[i];
    if (robot.life == RobotLife::kNotStarted) continue;
    mission::RobotReport report;
    report.id = robot.id;
    report.pose = poses_[i];
    report.radius = robot.body_spec.radius;
    report.is_running = robot.life == RobotLife::kRunning || robot.life == RobotLife::kParked;
    report.sequence = robot.action.status.sequence;
    report.done = robot.action.status.done;
    report.remaining = robot.action.status.remaining;
    out.push_back(report);
  }
}

void Fleet::note_calls(const FleetRobot& robot) {
  const percept::Action& action = robot.action;
  if (action.alert.front() != 0) {
    const std::string_view text(action.alert.data(), ::strnlen(action.alert.data(), action.alert.size()));
    calls_.push_back({robot.id, RobotCall::Kind::kAlert, std::string(text)});
  }
  for (std::uint8_t i = 0; i < action.request_count; ++i) {
    using Kind = percept::Request::Kind;
    const Kind kind = action.requests[i].kind;
    if (kind == Kind::kProceed) calls_.push_back({robot.id, RobotCall::Kind::kProceed, {}});
    if (kind == Kind::kHalt) calls_.push_back({robot.id, RobotCall::Kind::kHalt, {}});
    if (kind == Kind::kEndMission) calls_.push_back({robot.id, RobotCall::Kind::kEndMission, {}});
  }
}

void Fleet::notify(base::RobotId id, std::string_view notification) {
  const auto robot = std::ranges::find(robots_, id, &FleetRobot::id);
  if (robot == robots_.end()) return;
  std::vector<std::uint64_t>& inbox = robot->notifications;
  const std::uint64_t hash = base::hash_text(notification);
  const auto at = std::ranges::lower_bound(inbox, hash);
  if (at == inbox.end() || *at != hash) inbox.insert(at, hash);
}

std::vector<RobotCall> Fleet::take_calls() {
  return std::exchange(calls_, {});
}

std::vector<base::RobotId> Fleet::take_new_faults() {
  return std::exchange(new_faults_, {});
}

}  // namespace mlab::fleet
