#include "mlab/fleet/lock_step.h"

#include <algorithm>
#include <cmath>
#include <thread>
#include <utility>

#include <fmt/core.h>

#include "mlab/robot_wire/action_wire.h"
#include "mlab/robot_wire/percepts_wire.h"
#include "mlab/text/shown.h"

namespace mlab::fleet {
namespace {

flow::Needs needs_of(const wire::Needs& message) {
  // What a stranger's program wants is no reason to look farther than there is a world, or nowhere.
  const auto range = [](double value) { return std::isfinite(value) ? std::clamp(value, 0.0, 1e9) : 0.0; };
  return {range(message.obstacles()), range(message.robots()), range(message.objects()), message.ranges()};
}

void put(const robot_host::Settings& settings, wire::Start& out) {
  for (const auto& [port, value] : settings) {
    wire::Setting& setting = *out.add_settings();
    setting.set_port(port);
    setting.set_value(value);
  }
}

}  // namespace

// The one with the fewest robots, the first of them; a new one as long as there may be more.
std::size_t LockStep::process_for(const std::string& executable,
                                  const std::shared_ptr<const robot_host::HostedProgram>& hosted) {
  std::vector<std::size_t> load(processes_.size(), 0);
  for (const MemberState& member : members_) ++load[member.process];
  int count = 0;
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < processes_.size(); ++i) {
    if (processes_[i].executable != executable || processes_[i].hosted != hosted) continue;
    ++count;
    if (!best || load[i] < load[*best]) best = i;
  }
  if (best && count >= most_) return *best;
  Process& made = processes_.emplace_back();
  made.executable = executable;
  made.hosted = hosted;
  const bool has_own_processor = std::thread::hardware_concurrency() >= 2U * static_cast<unsigned>(most_);
  if (hosted) made.hosted_cycle = std::make_unique<robot_host::HostedCycle>(hosted, has_own_processor);
  return processes_.size() - 1;
}

LockStep::Member LockStep::host(Member member, std::uint32_t robot,
                                const std::shared_ptr<const robot_host::HostedProgram>& program) {
  const bool is_known = member != kNone && processes_[members_[member].process].hosted == program;
  if (!is_known) {
    const std::size_t process = process_for("", program);
    if (member == kNone) {
      member = static_cast<Member>(members_.size());
      members_.emplace_back();
    }
    members_[member].process = process;
    members_[member].robot = robot;
  }
  return member;
}

std::expected<LockStep::Member, std::string> LockStep::start(
    Member member, std::uint32_t robot, const std::shared_ptr<const robot::NativeProgram>& program,
    const robot_host::Settings& own) {
  if (member == kNone) {
    member = static_cast<Member>(members_.size());
    const std::size_t process = process_for(program->executable, nullptr);
    members_.emplace_back().process = process;
    members_.back().robot = robot;
  }
  Process& process = processes_[members_[member].process];
  if (!process.running || process.running->has_failed()) {
    auto started = robot_host::RobotProgramProcess::start(program->launch, program->limits);
    if (!started) return std::unexpected(started.error());
    process.running.emplace(std::move(*started));
  }
  wire::ToRobot message;
  wire::Start& start = *message.mutable_start();
  start.set_robot(robot);
  start.set_seed(seed_);
  put(program->settings, start);
  put(own, start);
  const wire::FromRobot* answer = process.running->ask(message, wire::FromRobot::kReady);
  if (answer == nullptr) return std::unexpected(process.running->failure());
  if (!answer->ready().problem().empty())
    return std::unexpected(fmt::format("refuses a setting: {}", text::shown(answer->ready().problem(), 200)));
  members_[member].needs = needs_of(answer->ready().needs());
  members_[member].action = {};
  members_[member].outcome = {};
  return member;
}

std::optional<std::string> LockStep::set(Member member, const std::string& port, const std::string& value) {
  MemberState& state = members_[member];
  Process& process = processes_[state.process];
  if (!process.running || process.running->has_failed()) return "its program does not run";
  wire::ToRobot message;
  message.mutable_set()->set_robot(state.robot);
  message.mutable_set()->mutable_setting()->set_port(port);
  message.mutable_set()->mutable_setting()->set_value(value);
  const wire::FromRobot* answer = process.running->ask(message, wire::FromRobot::kReady);
  if (answer == nullptr) return fmt::format("its program {}", process.running->failure());
  if (!answer->ready().problem().empty()) return text::shown(answer->ready().problem(), 200);
  state.needs = needs_of(answer->ready().needs());
  return std::nullopt;
}

void LockStep::begin() {
  for (Process& process : processes_) {
    process.cycle.mutable_cycle()->clear_robots();
    process.joined.clear();
    if (process.hosted_cycle) process.hosted_cycle->begin();
  }
}

void LockStep::join(Member member) {
  MemberState& state = members_[member];
  Process& process = processes_[state.process];
  process.joined.push_back(member);
  if (process.hosted_cycle) {
    state.place = process.hosted_cycle->join(state.robot, seed_);
    return;
  }
  state.place = static_cast<std::size_t>(process.cycle.cycle().robots_size());
  process.cycle.mutable_cycle()->add_robots()->set_robot(state.robot);
}

void LockStep::open() {
  for (Process& process : processes_) {
    if (process.hosted_cycle) process.hosted_cycle->open();
  }
}

void LockStep::percepts(Member member, const percept::Percepts& percepts, const flow::Frame& frame) {
  const MemberState& state = members_[member];
  Process& process = processes_[state.process];
  if (process.hosted_cycle) {
    process.hosted_cycle->set(state.place, percepts, {frame.data(), frame.size()});
    return;
  }
  wire::Cycle& cycle = *process.cycle.mutable_cycle();
  robot_wire::encode(percepts, *cycle.mutable_robots(static_cast<int>(state.place))->mutable_percepts());
}

void LockStep::exchange(const robot_host::Meanwhile& meanwhile) {
  for (Process& process : processes_) {
    if (process.hosted_cycle) process.hosted_cycle->ask();
  }
  exchange_messages(meanwhile);
  for (Process& process : processes_) {
    if (process.hosted_cycle) process.hosted_cycle->wait(meanwhile);
  }
}

LockStep::Outcome LockStep::take(Member member, percept::Action& action) {
  const MemberState& state = members_[member];
  if (robot_host::HostedCycle* hosted = processes_[state.process].hosted_cycle.get()) {
    auto [frame, failure] = hosted->take(state.place, action);
    return {"", std::move(failure), frame};
  }
  action = state.action;
  return state.outcome;
}

void LockStep::exchange_messages(const robot_host::Meanwhile& meanwhile) {
  for (Process& process : processes_) {
    process.is_asked = !process.hosted_cycle && !process.joined.empty() && process.running.has_value();
    if (process.is_asked) process.running->send(process.cycle);
  }
  for (Process& process : processes_) {
    if (!process.is_asked) continue;
    const wire::FromRobot* answer = process.running->receive(wire::FromRobot::kActions, meanwhile);
    if (answer != nullptr) take_answer(process, answer->actions());
    if (!process.running->has_failed()) continue;
    for (const Member member : process.joined)
      members_[member].outcome = {"", process.running->failure(), {}};
  }
}

void LockStep::take_answer(Process& process, const wire::Actions& actions) {
  if (actions.robots_size() != static_cast<int>(process.joined.size())) {
    process.running->fail(fmt::format("answers for {} robots, and was asked for {}", actions.robots_size(),
                                      process.joined.size()));
    return;
  }
  for (int i = 0; i < actions.robots_size(); ++i) {
    const wire::RobotActed& acted = actions.robots(i);
    MemberState& member = members_[process.joined[static_cast<std::size_t>(i)]];
    if (acted.robot() != member.robot) {
      process.running->fail(
          fmt::format("answers for robot {} where robot {} stands", acted.robot(), member.robot));
      return;
    }
    if (const auto problem = robot_wire::decode(acted.action(), member.action)) {
      process.running->fail(fmt::format("answers nonsense: {}", *problem));
      return;
    }
    member.outcome.fault = text::shown(acted.fault(), 200);
    member.needs = needs_of(acted.needs());
  }
}

}  // namespace mlab::fleet
