#include "mlab/robot/program/hosted_runner.h"

#include <algorithm>
#include <cstring>
#include <thread>
#include <utility>

#include "mlab/robot/program/bounded_needs.h"
#include "mlab/robot/program/process_share.h"

namespace mlab::robot {

std::size_t HostedRunner::process_for(const std::shared_ptr<const robot_host::HostedProgram>& program) {
  ProcessShare share(processes_.size(), most_);
  for (const Robot& robot : members_) share.count(robot.process);
  const auto known =
      share.least_loaded([&](std::size_t process) { return processes_[process].program == program; });
  if (known && !program->is_for_one_robot) return *known;
  // Where the processes of robots that went were.
  const auto free = std::ranges::find_if(processes_, [](const Process& one) { return !one.cycle; });
  const bool has_own_processor = std::thread::hardware_concurrency() >= 2U * static_cast<unsigned>(most_);
  Process made{program, std::make_unique<robot_host::HostedCycle>(program, has_own_processor)};
  if (free != processes_.end()) {
    *free = std::move(made);
    return static_cast<std::size_t>(free - processes_.begin());
  }
  processes_.push_back(std::move(made));
  return processes_.size() - 1;
}

void HostedRunner::remove(Member member) {
  const std::size_t process = members_[member].process;
  members_.remove(member);
  leave_process(process);
}

// Nobody's process ends.
void HostedRunner::leave_process(std::size_t process) {
  if (process == kNoProcess) return;
  const bool is_used =
      std::ranges::any_of(members_, [&](const Robot& one) { return one.process == process; });
  if (!is_used) processes_[process] = {};
}

std::optional<std::string> HostedRunner::start(Member member) {
  Robot& robot = members_[member];
  give_process(robot);
  robot.values.start();
  return std::nullopt;
}

void HostedRunner::give_process(Robot& robot) {
  const auto& hosted = robot.values.robot_program().hosted;
  if (robot.process != kNoProcess && processes_[robot.process].program == hosted) return;
  leave_process(std::exchange(robot.process, kNoProcess));
  robot.process = process_for(hosted);
}

// Processes keep nothing from one cycle to the next: whose process it is does not matter.
void HostedRunner::remember(Member member, const RobotMemory& memory) {
  Robot& robot = members_[member];
  robot.values.remember(memory);
  if (memory.has_started) give_process(robot);
}

void HostedRunner::open() {
  for (const Process& process : processes_) {
    if (process.cycle) process.cycle->begin();
  }
  for (const Member member : joined_) {
    Robot& robot = members_[member];
    robot.place = processes_[robot.process].cycle->join(robot.values.robot().value, seed_);
  }
  for (const Process& process : processes_) {
    if (process.cycle) process.cycle->open();
  }
}

// Its frame may hold anything.
void HostedRunner::needs(std::span<const Member> members, std::span<percept::Needs> out) const {
  for (std::size_t i = 0; i < members.size(); ++i) {
    const Workings robot = members_[members[i]].values.workings();
    out[i] = bounded(robot.program->needs(robot.frame, robot.interventions));
  }
}

void HostedRunner::act(std::span<const Turn> turns) {
  for (const Turn& turn : turns) {
    Robot& robot = members_[turn.member];
    robot.turn = turn;
    const flow::Frame& frame = robot.values.saved();
    processes_[robot.process].cycle->set(robot.place, *turn.percepts, {frame.data(), frame.size()},
                                         robot.values.interventions());
  }
}

void HostedRunner::ask() {
  for (const Process& process : processes_) {
    if (process.cycle) process.cycle->ask();
  }
}

void HostedRunner::wait(const Meanwhile& meanwhile) {
  for (const Process& process : processes_) {
    if (process.cycle) process.cycle->wait(meanwhile);
  }
  for (const Member member : joined_) take(members_[member]);
  joined_.clear();
}

std::expected<Said, std::string> HostedRunner::said(Member member) {
  const std::size_t process = members_[member].process;
  if (process == kNoProcess || !processes_[process].cycle) return Said{};
  return Said{{}, processes_[process].cycle->said()};
}

void HostedRunner::take(Robot& robot) {
  const Turn& turn = robot.turn;
  flow::Interventions* const interventions = robot.values.interventions();
  auto [frame, failure] = processes_[robot.process].cycle->take(robot.place, *turn.action, interventions);
  if (interventions != nullptr) robot.values.finish();
  if (!failure.empty()) {
    *turn.action = {};
    *turn.failure = std::move(failure);
    return;
  }
  std::memcpy(robot.values.frame(), frame.data(), frame.size());
  if (!is_number(*turn.action)) *turn.fault = robot.values.find_fault();
}

}  // namespace mlab::robot
