#include "mlab/fleet/fleet.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <iterator>
#include <memory>
#include <new>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "mlab/fleet/assignment.h"
#include "mlab/percept/object_colors.h"

namespace mlab::fleet {
namespace {

// Robots of a team see each other as mates, whatever each is ordered to do.
std::uint32_t unit_of_team(const FleetRobot& robot) {
  return robot.team + 1;
}

// What a robot of this program measures its station from under the order.
percept::FormationReference reference_of(const percept::Order& order, const robot::RobotProgram& program) {
  using percept::FormationReference;
  if (order.reference != FormationReference::kUnitCenter) return order.reference;
  const double preset = program.number("formation_reference").value_or(0.0);
  if (preset == static_cast<double>(FormationReference::kLeader)) return FormationReference::kLeader;
  if (preset == static_cast<double>(FormationReference::kNeighbor)) return FormationReference::kNeighbor;
  return FormationReference::kUnitCenter;
}

}  // namespace

std::string_view name(RobotLife life) {
  constexpr std::array<std::string_view, 5> kNames = {"not started", "running", "parked", "stopped", "fault"};
  return kNames[static_cast<std::size_t>(life)];
}

Fault fault_of(const FleetRobot& robot) {
  if (!robot.ailment.empty()) return Fault::kBody;
  if (!robot.fault.empty()) return Fault::kNoNumber;
  return robot.failure.empty() ? Fault::kNone : Fault::kProgram;
}

std::string_view name(Fault fault) {
  constexpr std::array<std::string_view, 4> kNames = {
      "", "its body failed", "its program put out something that is no number", "its program failed"};
  const auto index = static_cast<std::size_t>(fault);
  return index < kNames.size() ? kNames[index] : "";
}

std::string failure_of(const FleetRobot& robot) {
  if (!robot.ailment.empty()) return fmt::format("its body {}", robot.ailment);
  if (!robot.fault.empty())
    return fmt::format("its program put out something that is no number, first at `{}`", robot.fault);
  if (robot.failure.empty()) return "";
  return fmt::format("its program `{}` {}", robot.program->name, robot.failure);
}

Fleet::Fleet(const mission::Mission& mission, const std::vector<robot::RobotProgram>& programs,
             const std::vector<binding::BodySpec>& bodies, binding::Binding& binding, std::uint64_t seed,
             std::unique_ptr<robot::ProgramRunner> elsewhere, std::unique_ptr<robot::ProgramRunner> recorded)
    : binding_(binding),
      workers_(static_cast<std::size_t>(binding.workers().count())),
      runners_(seed, binding.workers().count(), std::move(elsewhere), std::move(recorded)) {
  for (const mission::Robot& declared : mission.robots) {
    now_.robots.push_back(make_robot(mission, declared, programs, bodies));
    enrol(now_.robots.back());
  }
  std::sort(now_.robots.begin(), now_.robots.end(),
            [](const FleetRobot& a, const FleetRobot& b) { return a.id < b.id; });
  now_.poses.resize(now_.robots.size());
  bodies_.resize(now_.robots.size(), binding::kNoBody);
  adopt(mission);
}

/// A team is the outermost unit that a robot belongs to; a robot of no unit is a team of its own.
void Fleet::form_teams(const mission::Mission& mission) {
  constexpr std::uint32_t kAlone = 0x80000000U;
  for (FleetRobot& robot : now_.robots) robot.team = kAlone + robot.id.value;
  std::vector<bool> is_part(mission.units.size());
  for (const mission::Unit& unit : mission.units) {
    for (const std::uint32_t part : unit.parts) is_part[part] = true;
  }
  for (std::uint32_t i = 0; i < mission.units.size(); ++i) {
    if (is_part[i]) continue;
    for (const base::RobotId id : mission.units[i].members) {
      FleetRobot* const member = find_own(id);
      if (member != nullptr && member->team >= kAlone) member->team = i;
    }
  }
  for (const FleetRobot& robot : now_.robots) {
    if (robot.life != RobotLife::kNotStarted) binding_.set_unit(robot.body, unit_of_team(robot));
  }
}

FleetRobot Fleet::make_robot(const mission::Mission& mission, const mission::Robot& declared,
                             const std::vector<robot::RobotProgram>& programs,
                             const std::vector<binding::BodySpec>& bodies) {
  FleetRobot robot;
  robot.id = declared.id;
  robot.type = mission.types[declared.type].name;
  robot.program = &programs[declared.type];
  robot.body_spec = bodies[declared.type];
  robot.capabilities = binding::capabilities_of(robot.body_spec);
  robot.kinematics = robot.body_spec.kinematics;
  robot.seen_as = percept::object_class_of_color(mission.types[declared.type].color)
                      .value_or(percept::ObjectClass::kUnknown);
  return robot;
}

void Fleet::enrol(FleetRobot& robot) {
  robot.runner = runners_.runner_of(*robot.program);
  if (robot.runner != nullptr) robot.member = robot.runner->add(robot.id, *robot.program);
}

void Fleet::dismiss(const FleetRobot& robot) {
  if (robot.runner != nullptr) robot.runner->remove(robot.member);
}

const FleetRobot* Fleet::find(base::RobotId id) const {
  const auto at =
      std::lower_bound(now_.robots.begin(), now_.robots.end(), id,
                       [](const FleetRobot& robot, base::RobotId wanted) { return robot.id < wanted; });
  return at != now_.robots.end() && at->id == id ? &*at : nullptr;
}

FleetRobot* Fleet::find_own(base::RobotId id) {
  const FleetRobot* const found = find(id);
  return found == nullptr ? nullptr : &now_.robots[index_of(*found)];
}

std::expected<binding::Placement, std::string> Fleet::start(base::RobotId id, geom::Pose pose) {
  FleetRobot* const found = find_own(id);
  if (found == nullptr) return std::unexpected("can't start: there is no such robot");
  if (found->life == RobotLife::kRunning || found->life == RobotLife::kParked)
    return std::unexpected("is started already");
  FleetRobot& robot = *found;
  const auto placement = embody(robot, pose);
  if (!placement) return placement;
  robot.start = placement->pose;
  if (!start_program(robot)) now_.new_faults.push_back(id);
  return placement;
}

std::expected<binding::Placement, std::string> Fleet::embody(FleetRobot& robot, geom::Pose pose) {
  if (robot.life != RobotLife::kNotStarted) {  // started anew
    binding_.release(robot.body);
    actions_[robot.body.value] = {};
  }
  const auto placement = binding_.embody(
      {robot.body_spec, pose, robot.id, unit_of_team(robot), robot.seen_as, robot.program->vehicle()});
  if (!placement) return std::unexpected(fmt::format("can't start: {}", placement.error()));
  const std::size_t index = index_of(robot);
  robot.body = bodies_[index] = placement->body;
  robot.capabilities = binding_.capabilities(robot.body);
  robot.kinematics = robot.capabilities.kinematics.value_or(robot.body_spec.kinematics);
  now_.poses[index] = placement->pose;
  actions_.resize(std::max<std::size_t>(actions_.size(), robot.body.value + std::size_t{1}));
  return placement;
}

std::optional<std::string> Fleet::replace(base::RobotId id) {
  FleetRobot* const found = find_own(id);
  if (found == nullptr) return fmt::format("there is no robot {}", id.value);
  if (found->life != RobotLife::kFaulted)
    return fmt::format("robot {} has no fault that another one would be needed for: {}", id.value,
                       name(found->life));
  FleetRobot& robot = *found;
  if (!robot.ailment.empty()) {
    if (const auto placement = embody(robot, pose(robot)); !placement)
      return fmt::format("robot {} {}", id.value, placement.error());
  }
  if (start_program(robot)) return std::nullopt;
  return fmt::format("robot {} can't be replaced: {}", id.value, failure_of(robot));
}

bool Fleet::start_program(FleetRobot& robot) {
  robot.failsafe = {};
  robot.life = robot.runner != nullptr ? RobotLife::kRunning : RobotLife::kParked;
  robot.fault.clear();
  robot.failure.clear();
  robot.ailment.clear();
  robot.notifications.clear();
  std::optional<std::string> problem;
  if (robot.runner != nullptr) {
    ++robot.starts;
    const std::string* const known =
        known_failures_ ? known_failures_->at_start(robot.id, robot.starts) : nullptr;
    problem = known != nullptr ? std::optional(*known) : robot.runner->start(robot.member);
  }
  if (problem) {
    robot.failure = *problem;
    robot.life = RobotLife::kFaulted;
  }
  if (witness_ != nullptr) witness_->note_start(robot);
  return !problem;
}

// All members may come out of one group: it is told once, not by each.
void Fleet::leave_groups(std::span<const std::uint32_t> members) {
  std::vector<std::uint32_t> touched;
  for (const std::uint32_t member : members) {
    const std::uint32_t group = std::exchange(now_.robots[member].group, FleetRobot::kNoGroup);
    if (group != FleetRobot::kNoGroup) touched.push_back(group);
  }
  std::sort(touched.begin(), touched.end());
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  for (const std::uint32_t left : touched) {
    Group& group = now_.groups[left];
    std::erase_if(group.members, [&](std::uint32_t member) { return now_.robots[member].group != left; });
    if (group.members.empty()) {
      group = {};
      now_.free_groups.push_back(left);
    } else {
      assign_ranks(group, now_.poses);
    }
    for (std::size_t rank = 0; rank < group.members.size(); ++rank)
      now_.robots[group.members[rank]].rank = static_cast<std::uint32_t>(rank);
  }
}

namespace {

// In whatever order. A unit may have very many.
bool are_same_members(std::vector<std::uint32_t> some, std::vector<std::uint32_t> others) {
  std::ranges::sort(some);
  std::ranges::sort(others);
  return some == others;
}

}  // namespace

void Fleet::order(const mission::effect::Order& effect) {
  Group group;
  group.order = effect.order;
  group.command = effect.command;
  for (const base::RobotId id : effect.members) {
    if (const FleetRobot* robot = find(id))
      group.members.push_back(static_cast<std::uint32_t>(index_of(*robot)));
  }
  if (group.members.empty()) return;
  const FleetRobot& leader = now_.robots[group.members.front()];
  std::vector<std::uint32_t> kept;
  // A formation goes on looking where it looked, whichever order it gets next.
  if (leader.group != FleetRobot::kNoGroup) {
    const Group& before = now_.groups[leader.group];
    group.formation_heading = before.formation_heading;
    if (are_same_members(before.members, group.members)) {
      group.center = before.center;
      group.has_center = before.has_center;
      // What only goes on or halts keeps its stations.
      if (before.order.sequence == group.order.sequence) kept = before.members;
    }
  } else {
    group.formation_heading = leader.start.heading;
  }
  group.spacing = leader.program->number("formation_spacing").value_or(group.spacing);
  group.reference = reference_of(group.order, *leader.program);
  group.slop = leader.program->number("formation_slop").value_or(group.slop);
  group.heading_trigger = leader.program->number("formation_default_trigger").value_or(group.heading_trigger);
  group.assigns_stations =
      now_.assigns_stations.value_or(leader.program->number("plans_ways").value_or(1.0) != 0.0);

  leave_groups(group.members);
  if (!kept.empty())
    group.members = std::move(kept);
  else if (group.order.task != percept::Task::kStart)
    assign_ranks(group, now_.poses);
  auto slot = static_cast<std::uint32_t>(now_.groups.size());
  if (!now_.free_groups.empty()) {
    slot = now_.free_groups.back();
    now_.free_groups.pop_back();
  } else {
    now_.groups.emplace_back();
  }
  for (std::size_t rank = 0; rank < group.members.size(); ++rank) {
    FleetRobot& robot = now_.robots[group.members[rank]];
    robot.group = slot;
    robot.rank = static_cast<std::uint32_t>(rank);
  }
  now_.groups[slot] = std::move(group);
}

void Fleet::stop(base::RobotId id) {
  FleetRobot* const robot = find_own(id);
  if (robot == nullptr || robot->life == RobotLife::kNotStarted) return;
  const auto index = static_cast<std::uint32_t>(index_of(*robot));
  leave_groups({&index, 1});
  robot->life = RobotLife::kStopped;
  robot->action = {};
}

void Fleet::set_joystick(base::RobotId id, const percept::Joystick& joystick) {
  FleetRobot* const robot = find_own(id);
  if (robot == nullptr) return;
  robot->joystick = joystick;
  robot->is_stick_held = true;
}

void Fleet::let_go_of_stick(base::RobotId id) {
  set_joystick(id, {});
  if (FleetRobot* const robot = find_own(id)) robot->is_stick_held = false;
}

void Fleet::set_teleoperated(std::span<const base::RobotId> robots) {
  for (FleetRobot& robot : now_.robots) robot.is_teleoperated = std::ranges::binary_search(robots, robot.id);
}

const Group* Fleet::group(const FleetRobot& robot) const {
  return robot.group == FleetRobot::kNoGroup ? nullptr : &now_.groups[robot.group];
}

double Fleet::station_error(const FleetRobot& robot) const {
  return robot.group == FleetRobot::kNoGroup
             ? 0.0
             : fleet::station_error(now_.groups[robot.group], robot.rank, now_.poses);
}

std::optional<geom::Point> Fleet::station_place(const FleetRobot& robot) const {
  if (robot.group == FleetRobot::kNoGroup) return std::nullopt;
  return fleet::station_place(now_.groups[robot.group], robot.rank, now_.poses);
}

void Fleet::update_poses() {
  binding_.poses(bodies_, now_.poses);
}

void Fleet::step(double dt) {
  update_poses();
  for (Group& group : now_.groups) update_group(group, now_.poses);
  look_after_bodies();
  run_programs(dt);
  for (FleetRobot& robot : now_.robots) {
    if (robot.life == RobotLife::kRunning) {
      collect(robot, dt);
      continue;
    }
    if (robot.body != binding::kNoBody) actions_[robot.body.value].clear();
    if (robot.life == RobotLife::kFaulted && now_.failsafes->drives(robot.failsafe))
      go_on_by_failsafe(robot, dt);
  }
  now_.messages.resolve(now_.robots, binding_.time(), [this] { return binding_.radio(); });
  binding_.carry_out(actions_, dt);
  update_poses();
}

// A robot whose body is gone stands; the others go on.
void Fleet::look_after_bodies() {
  ailments_.clear();
  binding_.health(ailments_);
  if (ailments_.empty()) return;
  std::ranges::sort(ailments_, {}, &binding::Ailment::body);
  for (FleetRobot& robot : now_.robots) {
    if (robot.life != RobotLife::kRunning) continue;
    const auto ailment = std::ranges::lower_bound(ailments_, robot.body, {}, &binding::Ailment::body);
    if (ailment == ailments_.end() || ailment->body != robot.body) continue;
    robot.life = RobotLife::kFaulted;
    robot.action = {};
    robot.ailment = std::move(ailment->what);
    now_.new_faults.push_back(robot.id);
  }
}

void Fleet::run_programs(double dt) {
  for (const FleetRobot& robot : now_.robots) {
    if (robot.life == RobotLife::kRunning) robot.runner->join(robot.member);
  }
  for (const auto& runner : runners_) runner->open();
  if (witness_ != nullptr) witness_->note_asked(now_.robots);
  binding_.workers().run(now_.robots.size(), kRobotsAtOnce,
                         [&](std::size_t begin, std::size_t end, int worker) {
                           for (std::size_t i = begin; i < end; i += kRobotsAtOnce) {
                             run_piece(i, std::min(end, i + kRobotsAtOnce), dt, worker);
                           }
                         });
  for (const auto& runner : runners_) runner->ask();
  for (const auto& runner : runners_) runner->wait(meanwhile_);
  fail_as_known();
  add_found();
  if (witness_ != nullptr) witness_->note_answered(now_.robots);
}

// What they have computed here nobody heard of then.
void Fleet::fail_as_known() {
  if (!known_failures_ || !known_failures_->are_any()) return;
  for (FleetRobot& robot : now_.robots) {
    if (robot.life != RobotLife::kRunning) continue;
    const std::string* const failure = known_failures_->in_cycle(robot.id);
    if (failure == nullptr) continue;
    robot.action = {};
    robot.fault.clear();
    robot.failure = *failure;
  }
}

// Takes up what the robot's program answered.
void Fleet::collect(FleetRobot& robot, double dt) {
  percept::Action& carried_out = actions_[robot.body.value];
  if (!robot.failure.empty() || !robot::is_number(robot.action)) {
    robot.life = RobotLife::kFaulted;
    carried_out = robot.action = {};
    now_.new_faults.push_back(robot.id);
    return;
  }
  if (robot.failsafes == 0 || guard(robot, dt)) {
    carried_out.become(robot.action);
    note_calls(robot);
  } else {
    carried_out.clear();
  }
}

void Fleet::brake(double dt) {
  for (percept::Action& action : actions_) action = {};
  for (FleetRobot& robot : now_.robots) {
    const percept::OrderStatus status = robot.action.status;
    robot.action = {};
    robot.action.status = status;
  }
  binding_.carry_out(actions_, dt);
  update_poses();
}

Fleet::Bodies Fleet::bodies() const {
  Bodies out;
  for (const FleetRobot& robot : now_.robots) {
    if (robot.life == RobotLife::kNotStarted) continue;
    ++out.all;
    if (geom::length(binding_.view().body(robot.body).velocity) > 0.0) ++out.moving;
  }
  return out;
}

std::optional<std::string> Fleet::set_parameter(base::RobotId id, std::string_view path,
                                                const std::string& value) {
  FleetRobot* const robot = find_own(id);
  if (robot == nullptr) return fmt::format("there is no robot {}", id.value);
  if (robot->runner == nullptr) return fmt::format("robot {} has no program", id.value);
  return robot->runner->set(robot->member, path, value);
}

std::expected<FleetRobot*, std::string> Fleet::running(base::RobotId id) {
  FleetRobot* const robot = find_own(id);
  if (robot == nullptr) return std::unexpected(fmt::format("there is no robot {}", id.value));
  if (robot->life != RobotLife::kRunning)
    return std::unexpected(fmt::format("robot {} does not run: {}", id.value, name(robot->life)));
  return robot;
}

std::vector<robot::SilentMachine> Fleet::silent_machines() const {
  std::vector<robot::SilentMachine> out;
  for (const auto& runner : runners_) std::ranges::move(runner->silent_machines(), std::back_inserter(out));
  return out;
}

const robot::Punctuality* Fleet::punctuality() const {
  for (const auto& runner : runners_) {
    if (const robot::Punctuality* const out = runner->punctuality()) return out;
  }
  return nullptr;
}

std::optional<std::string> Fleet::force(base::RobotId id, std::string_view sequence, std::string_view state) {
  const auto robot = running(id);
  if (!robot) return robot.error();
  return (*robot)->runner->force((*robot)->member, sequence, state);
}

std::optional<std::string> Fleet::hold(base::RobotId id, std::string_view port, std::string_view value) {
  const auto robot = running(id);
  if (!robot) return robot.error();
  return (*robot)->runner->hold((*robot)->member, port, value);
}

std::optional<std::string> Fleet::release(base::RobotId id, std::string_view port) {
  FleetRobot* const robot = find_own(id);
  if (robot == nullptr || robot->runner == nullptr)
    return fmt::format("there is no robot {} that holds", id.value);
  return robot->runner->release(robot->member, port);
}

percept::Percepts Fleet::perceive_at(const FleetRobot& robot, const geom::Pose& pose,
                                     const percept::Needs& needs, double dt) const {
  percept::Percepts out = binding_.view().sense_at(robot.body, pose, needs);
  add_told(robot, needs, dt, out);
  return out;
}

void Fleet::add_told(const FleetRobot& robot, const percept::Needs& needs, double dt,
                     percept::Percepts& out) const {
  out.cycle_duration = dt;
  if (robot.group != FleetRobot::kNoGroup) {
    out.order = now_.groups[robot.group].order;
    out.unit = unit_percept(now_.groups[robot.group], robot.rank, now_.poses);
  } else {
    out.unit.center = out.pose.position;
    out.unit.leader = out.unit.neighbor = out.pose;
  }
  out.joystick = robot.joystick;
  out.id = robot.id;
  out.notifications = robot.notifications;
  now_.messages.add_told(robot, out);
  if (needs.has(percept::Sensor::kGround)) out.ground = ground_of(robot).view();
}

// In pieces that stay in the cache: senses first, then programs; neighbours that are run at the same place
// together.
void Fleet::run_piece(std::size_t begin, std::size_t end, double dt, int index) {
  Worker& worker = workers_[static_cast<std::size_t>(index)];
  std::size_t count = 0;
  for (std::size_t i = begin; i < end; ++i) {
    if (now_.robots[i].life == RobotLife::kRunning) worker.robots[count++] = static_cast<std::uint32_t>(i);
  }
  for (std::size_t first = 0, last = 0; first < count; first = last) {
    robot::ProgramRunner& runner = *now_.robots[worker.robots[first]].runner;
    for (last = first; last < count && now_.robots[worker.robots[last]].runner == &runner; ++last)
      worker.members[last] = now_.robots[worker.robots[last]].member;
    runner.needs({&worker.members[first], last - first}, {&worker.needs[first], last - first});
  }
  for (std::size_t i = 0; i < count; ++i) {
    const FleetRobot& robot = now_.robots[worker.robots[i]];
    if (robot.failsafes != 0) worker.needs[i].add(now_.failsafes->needs(robot.failsafes, robot.failsafe));
    // An assignment would copy what it makes, std::construct_at write zeros before it.
    ::new (static_cast<void*>(&worker.percepts[i])) percept::Percepts;
    worker.senses[i] = {robot.body, &worker.needs[i], &worker.percepts[i]};
  }
  binding_.percepts({worker.senses.data(), count}, index);
  for (std::size_t i = 0; i < count; ++i) {
    FleetRobot& robot = now_.robots[worker.robots[i]];
    if (robot.failsafes != 0) note_seen(worker.robots[i], worker.percepts[i]);
    add_told(robot, worker.needs[i], dt, worker.percepts[i]);
    if (worker.needs[i].has(percept::Sensor::kGround))
      note_found(worker.robots[i], worker.percepts[i],
                 robot.capabilities.overlooks || robot.body_spec.has_ring_obstacles
                     ? 0.0
                     : worker.needs[i][percept::Sensor::kObstacles],
                 worker);
    worker.turns[i] = {robot.member, &worker.percepts[i], &robot.action, &robot.fault, &robot.failure};
  }
  for (std::size_t first = 0, last = 0; first < count; first = last) {
    robot::ProgramRunner& runner = *now_.robots[worker.robots[first]].runner;
    while (last < count && now_.robots[worker.robots[last]].runner == &runner) ++last;
    runner.act({&worker.turns[first], last - first});
  }
}

void Fleet::report(std::vector<mission::RobotReport>& out) const {
  out.clear();
  for (std::size_t i = 0; i < now_.robots.size(); ++i) {
    const FleetRobot& robot = now_.robots[i];
    if (robot.life == RobotLife::kNotStarted) continue;
    mission::RobotReport report;
    report.id = robot.id;
    report.pose = now_.poses[i];
    report.radius = robot.capabilities.radius;
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
    now_.calls.push_back({robot.id, RobotCall::Kind::kAlert, std::string(text)});
  }
  for (std::uint8_t i = 0; i < action.request_count; ++i) {
    using Kind = percept::Request::Kind;
    const Kind kind = action.requests[i].kind;
    if (kind == Kind::kProceed) now_.calls.push_back({robot.id, RobotCall::Kind::kProceed, {}});
    if (kind == Kind::kHalt) now_.calls.push_back({robot.id, RobotCall::Kind::kHalt, {}});
    if (kind == Kind::kEndMission) now_.calls.push_back({robot.id, RobotCall::Kind::kEndMission, {}});
  }
}

void Fleet::notify(base::RobotId id, std::string_view notification) {
  if (FleetRobot* const robot = find_own(id))
    put_notification(robot->notifications, base::hash_text(notification));
}

std::vector<RobotCall> Fleet::take_calls() {
  return std::exchange(now_.calls, {});
}

std::vector<base::RobotId> Fleet::take_new_faults() {
  return std::exchange(now_.new_faults, {});
}

}  // namespace mlab::fleet
