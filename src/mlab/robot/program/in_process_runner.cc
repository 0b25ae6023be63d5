#include "mlab/robot/program/in_process_runner.h"

namespace mlab::robot {

ProgramRunner::Member InProcessRunner::add(base::RobotId robot, const RobotProgram& program) {
  if (program.program->has_asynchronous() && !async_) async_ = std::make_unique<flow::AsyncRunner>(1);
  return members_.add({robot, program});
}

std::optional<std::string> InProcessRunner::start(Member member) {
  if (members_[member].robot_program().is_described_only) return "brings procedures that were only checked";
  members_[member].start();
  return std::nullopt;
}

// What was computed ahead of the cycle that it goes back to is computed again.
void InProcessRunner::remember(Member member, const RobotMemory& memory) {
  if (async_ && async_->size() > 0) async_ = std::make_unique<flow::AsyncRunner>(1);
  members_[member].remember(memory);
}

void InProcessRunner::needs(std::span<const Member> members, std::span<percept::Needs> out) const {
  for (std::size_t i = 0; i < members.size(); ++i) {
    const Workings robot = members_[members[i]].workings();
    out[i] = robot.program->needs(robot.frame, robot.interventions);
  }
}

void InProcessRunner::act(std::span<const Turn> turns) {
  constexpr std::size_t kMany = 16;  // their frames do not stay in the cache from one cycle to the next
  constexpr std::size_t kAhead = 2;  // by then what a frame says of its large values has come
  const std::size_t fetched = turns.size() < kMany ? 0 : turns.size();
  const auto fetch = [&](std::size_t i, void (flow::Program::*part)(const std::byte*) const) {
    if (i >= fetched) return;
    const Workings robot = members_[turns[i].member].workings();
    (robot.program->*part)(robot.frame);
  };
  for (std::size_t i = 0; i < kAhead; ++i) fetch(i, &flow::Program::fetch);
  fetch(0, &flow::Program::fetch_large);
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const Turn& turn = turns[i];
    RobotValues& robot = members_[turn.member];
    fetch(i + 1, &flow::Program::fetch_large);
    fetch(i + kAhead, &flow::Program::fetch);
    turn.action->clear();
    robot.program().step(robot.frame(), *turn.percepts, *turn.action, seed_, robot.robot().value,
                         async_.get(), robot.interventions());
    if (robot.interventions() != nullptr) robot.finish();
    if (!is_number(*turn.action)) *turn.fault = robot.find_fault();
  }
}

}  // namespace mlab::robot
