#include "mlab/robot/program/executable_runner.h"

#include <utility>

#include <fmt/core.h>

#include "mlab/robot/program/bounded_needs.h"
#include "mlab/robot/program/native_program.h"
#include "mlab/robot/program/process_share.h"
#include "mlab/robot/wire/action_wire.h"
#include "mlab/robot/wire/percepts_wire.h"
#include "mlab/text/shown.h"

namespace mlab::robot {
namespace {

void put(const std::string& port, const std::string& value, wire::Setting& out) {
  out.set_port(port);
  out.set_value(value);
}

int index_of(const NativeProgram& native, const wire::Port& port) {
  int index = 0;
  while (&native.description.ports(index) != &port) ++index;
  return index;
}

}  // namespace

ProgramRunner::Member ExecutableRunner::add(base::RobotId robot, const RobotProgram& program) {
  Robot added;
  added.robot = robot;
  added.program = &program;
  return members_.add(std::move(added));
}

std::size_t ExecutableRunner::process_for(const NativeProgram& native) {
  ProcessShare share(processes_.size(), most_);
  for (const Robot& robot : members_) share.count(robot.process);
  const auto known = share.least_loaded(
      [&](std::size_t process) { return processes_[process].executable == native.executable; });
  if (known && !native.is_for_one_robot) return *known;
  processes_.emplace_back().executable = native.executable;
  return processes_.size() - 1;
}

// A process that has failed is started again.
std::optional<std::string> ExecutableRunner::start(Member member) {
  Robot& robot = members_[member];
  const NativeProgram& native = *robot.program->native;
  if (robot.process == kNoProcess) robot.process = process_for(native);
  Process& process = processes_[robot.process];
  if (!process.running || process.running->has_failed()) {
    auto started = robot_host::RobotProgramProcess::start(native.launch, native.limits);
    if (!started) return started.error();
    process.running.emplace(std::move(*started));
  }
  wire::ToRobot message;
  wire::Start& start = *message.mutable_start();
  start.set_robot(robot.robot.value);
  start.set_seed(seed_);
  for (const auto& [port, value] : native.settings) put(port, value, *start.add_settings());
  for (const auto& [port, value] : robot.set)
    put(native.description.ports(port).path(), value, *start.add_settings());
  const wire::FromRobot* answer = process.running->ask(message, wire::FromRobot::kReady);
  if (answer == nullptr) return process.running->failure();
  if (!answer->ready().problem().empty())
    return fmt::format("refuses a setting: {}", text::shown(answer->ready().problem(), 200));
  robot.needs = bounded(robot_wire::needs_of(answer->ready().needs()));
  return std::nullopt;
}

std::optional<std::string> ExecutableRunner::set(Member member, std::string_view path,
                                                 const std::string& value) {
  Robot& robot = members_[member];
  const NativeProgram& native = *robot.program->native;
  const wire::Port* port = native.find(path);
  if (port == nullptr) return fmt::format("the program of robot {} has no `{}`", robot.robot.value, path);
  if (robot.process == kNoProcess) return fmt::format("robot {} has not started", robot.robot.value);
  if (auto problem = tell(robot, port->path(), value)) return problem;
  robot.set[index_of(native, *port)] = value;
  return std::nullopt;
}

std::optional<std::string> ExecutableRunner::tell(Robot& robot, const std::string& port,
                                                  const std::string& value) {
  Process& process = processes_[robot.process];
  if (!process.running || process.running->has_failed()) return "its program does not run";
  wire::ToRobot message;
  message.mutable_set()->set_robot(robot.robot.value);
  put(port, value, *message.mutable_set()->mutable_setting());
  const wire::FromRobot* answer = process.running->ask(message, wire::FromRobot::kReady);
  if (answer == nullptr) return fmt::format("its program {}", process.running->failure());
  if (!answer->ready().problem().empty()) return text::shown(answer->ready().problem(), 200);
  robot.needs = bounded(robot_wire::needs_of(answer->ready().needs()));
  return std::nullopt;
}

bool ExecutableRunner::take_over(Member member, const RobotProgram& after, bool is_running) {
  Robot& robot = members_[member];
  const NativeProgram& before = *robot.program->native;
  if (!after.native || after.native->executable != before.executable) return false;
  robot.program = &after;
  if (robot.process == kNoProcess || !is_running) return true;
  for (const wire::Port& port : after.native->description.ports()) {
    const wire::Port* known = before.find(port.path());
    if (port.role() == wire::Port::OUTPUT || known == nullptr || known->value().text() == port.value().text())
      continue;
    // It is a value that the new version's own process took: the old process takes it as well, or is another
    // version, and keeps what it has.
    static_cast<void>(tell(robot, port.path(), port.value().text()));
  }
  return true;
}

std::expected<Said, std::string> ExecutableRunner::said(Member member) {
  const std::size_t process = members_[member].process;
  if (process == kNoProcess || !processes_[process].running) return Said{};
  return Said{{}, processes_[process].running->said()};
}

void ExecutableRunner::open() {
  for (Process& process : processes_) {
    process.cycle.mutable_cycle()->clear_robots();
    process.joined.clear();
  }
  for (const Member member : joined_) {
    Robot& robot = members_[member];
    Process& process = processes_[robot.process];
    process.joined.push_back(member);
    robot.place = process.cycle.cycle().robots_size();
    process.cycle.mutable_cycle()->add_robots()->set_robot(robot.robot.value);
  }
}

void ExecutableRunner::needs(std::span<const Member> members, std::span<percept::Needs> out) const {
  for (std::size_t i = 0; i < members.size(); ++i) out[i] = members_[members[i]].needs;
}

void ExecutableRunner::act(std::span<const Turn> turns) {
  for (const Turn& turn : turns) {
    Robot& robot = members_[turn.member];
    robot.turn = turn;
    wire::Cycle& cycle = *processes_[robot.process].cycle.mutable_cycle();
    robot_wire::encode(*turn.percepts, *cycle.mutable_robots(robot.place)->mutable_percepts());
  }
}

void ExecutableRunner::ask() {
  for (Process& process : processes_) {
    process.is_asked = !process.joined.empty() && process.running.has_value();
    if (process.is_asked) process.running->send(process.cycle);
  }
}

void ExecutableRunner::wait(const Meanwhile& meanwhile) {
  for (Process& process : processes_) {
    if (!process.is_asked) continue;
    const wire::FromRobot* answer = process.running->receive(wire::FromRobot::kActions, meanwhile);
    if (answer != nullptr) take_answer(process, answer->actions());
    if (!process.running->has_failed()) continue;
    for (const Member member : process.joined) {
      const Turn& turn = members_[member].turn;
      *turn.action = {};
      turn.fault->clear();
      *turn.failure = process.running->failure();
    }
  }
  joined_.clear();
}

void ExecutableRunner::take_answer(Process& process, const wire::Actions& actions) {
  if (actions.robots_size() != static_cast<int>(process.joined.size())) {
    process.running->fail(fmt::format("answers for {} robots, and was asked for {}", actions.robots_size(),
                                      process.joined.size()));
    return;
  }
  for (int i = 0; i < actions.robots_size(); ++i) {
    const wire::RobotActed& acted = actions.robots(i);
    Robot& robot = members_[process.joined[static_cast<std::size_t>(i)]];
    if (acted.robot() != robot.robot.value) {
      process.running->fail(
          fmt::format("answers for robot {} where robot {} stands", acted.robot(), robot.robot.value));
      return;
    }
    if (const auto problem = robot_wire::decode(acted.action(), *robot.turn.action)) {
      process.running->fail(fmt::format("answers nonsense: {}", *problem));
      return;
    }
    *robot.turn.fault = text::shown(acted.fault(), 200);
    if (robot.turn.fault->empty() && !is_number(*robot.turn.action)) *robot.turn.fault = "its action";
    robot.needs = bounded(robot_wire::needs_of(acted.needs()));
  }
}

}  // namespace mlab::robot
