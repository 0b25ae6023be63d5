#include "mlab/robot/remote/remote_runner.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "mlab/robot/program/bounded_needs.h"
#include "mlab/robot/remote/states.h"
#include "mlab/robot/wire/action_wire.h"
#include "mlab/robot/wire/percepts_wire.h"
#include "mlab/text/shown.h"

namespace mlab::robot_remote {
namespace {

constexpr double kGlanceAtLog = 0.3;    // who reads what was said keeps the run waiting for no longer [s]
constexpr std::size_t kSentence = 400;  // characters that an agent may say of a robot

// One that does not answer carries nothing any more.
void dismiss(Agent& agent, std::uint32_t number) {
  wire::ToAgent message;
  message.mutable_dismiss()->set_member(number);
  [[maybe_unused]] const auto answer = agent.ask(message, wire::FromAgent::kDone);
}

std::span<const std::byte> bytes_of(const flow::Frame& frame) {
  return {frame.data(), frame.size()};
}

}  // namespace

robot::ProgramRunner::Member RemoteRunner::add(base::RobotId robot, const robot::RobotProgram& program) {
  Robot added;
  added.values = {robot, program};
  welcome(program);
  // Now, so that nobody waits for a compiler once the run is under way; who starts it is told what is wrong.
  for (Carrier& carrier : carriers_) {
    if (carrier.agent->may_carry(program)) static_cast<void>(carrier.agent->bring(program).has_value());
  }
  return members_.add(std::move(added));
}

void RemoteRunner::remove(Member member) {
  leave(members_[member]);
  members_.remove(member);
}

void RemoteRunner::leave(Robot& robot) {
  if (robot.carrier == nullptr) return;
  --robot.carrier->robots;
  dismiss(*robot.carrier->agent, robot.number);
  robot.carrier = nullptr;
}

// Why there may be none.
std::string RemoteRunner::welcome(const robot::RobotProgram& program) {
  std::vector<std::string> lost;
  for (Carrier& carrier : carriers_) {
    if (carrier.is_given_up || carrier.agent->failure().empty()) continue;
    carrier.is_given_up = true;
    lost.push_back(carrier.agent->name());
  }
  Newcomers newcomers = recruit_(program, lost);
  for (auto& agent : newcomers.agents) carriers_.push_back({std::move(agent), 0, {}, {}, false});
  return std::move(newcomers.why_none);
}

std::expected<RemoteRunner::Carrier*, std::string> RemoteRunner::carrier_for(
    const robot::RobotProgram& program) {
  Carrier* best = nullptr;
  std::string failure = welcome(program);
  for (Carrier& carrier : carriers_) {
    if (!carrier.agent->may_carry(program)) continue;
    if (std::string what = carrier.agent->failure(); !what.empty())
      failure = std::move(what);
    else if (best == nullptr || carrier.robots < best->robots)
      best = &carrier;
  }
  if (best != nullptr) return best;
  return std::unexpected("has no agent: " + failure);
}

std::optional<std::string> RemoteRunner::start(Member member) {
  Robot& robot = members_[member];
  if (robot.carrier != nullptr && !robot.carrier->agent->failure().empty()) leave(robot);
  std::optional<std::string> problem;
  // Where the agent fails meanwhile, another one takes it.
  for (std::size_t tries = 0; tries <= carriers_.size() + 1; ++tries) {
    problem = robot.carrier == nullptr ? enlist(robot) : std::nullopt;
    if (!problem) {
      robot.values.start();
      problem = put(robot, true);
    }
    if (robot.carrier == nullptr || robot.carrier->agent->failure().empty()) break;
    leave(robot);
  }
  return problem;
}

// Where it fails together with the agent, the robot has that agent all the same.
std::optional<std::string> RemoteRunner::enlist(Robot& robot) {
  const robot::RobotProgram& program = robot.values.robot_program();
  const auto carrier = carrier_for(program);
  if (!carrier) return carrier.error();
  Agent& agent = *(*carrier)->agent;
  const auto brought = agent.bring(program);
  std::optional<std::string> problem;
  if (!brought) {
    problem = fmt::format("can't begin: {}", brought.error());
  } else {
    wire::ToAgent message;
    message.mutable_enlist()->set_member(next_number_);
    message.mutable_enlist()->set_robot(robot.values.robot().value);
    message.mutable_enlist()->set_program(*brought);
    const auto answer = agent.ask(message, wire::FromAgent::kDone);
    if (!answer) problem = fmt::format("can't begin: {}", answer.error());
  }
  if (problem && agent.failure().empty()) return problem;
  robot.carrier = *carrier;
  robot.number = next_number_++;
  ++robot.carrier->robots;
  return problem;
}

std::optional<std::string> RemoteRunner::put(Robot& robot, bool begins) const {
  wire::ToAgent message;
  wire::Put& put = *message.mutable_put();
  put.set_member(robot.number);
  put.set_begins(begins);
  const flow::Frame& frame = robot.values.saved();
  encode(frame.data(), frame.size(), robot.values.workings().interventions, *put.mutable_state());
  const auto answer = robot.carrier->agent->ask(message, wire::FromAgent::kDone);
  if (!answer) return fmt::format("can't be reached: {}", answer.error());
  if (const std::string& problem = (*answer)->done().problem(); !problem.empty()) {
    const std::string what = text::shown(problem, kSentence);
    return begins ? fmt::format("can't begin on `{}`: {}", robot.carrier->agent->name(), what) : what;
  }
  robot.needs = robot::bounded(robot_wire::needs_of((*answer)->done().needs()));
  robot.known = cycle_;
  return std::nullopt;
}

std::optional<std::string> RemoteRunner::change(Robot& robot, wire::Change::Kind kind, std::string_view path,
                                                std::string_view value) {
  wire::ToAgent message;
  wire::Change& change = *message.mutable_change();
  change.set_member(robot.number);
  change.set_kind(kind);
  change.set_path(std::string(path));
  change.set_value(std::string(value));
  robot.known = kLongAgo;
  const auto answer = robot.carrier->agent->ask(message, wire::FromAgent::kDone);
  if (!answer) return answer.error();
  if (const std::string& problem = (*answer)->done().problem(); !problem.empty())
    return text::shown(problem, kSentence);
  robot.needs = robot::bounded(robot_wire::needs_of((*answer)->done().needs()));
  return std::nullopt;
}

bool RemoteRunner::is_carried(const Robot& robot) {
  return robot.carrier != nullptr && robot.carrier->agent->failure().empty();
}

std::optional<std::string> RemoteRunner::set(Member member, std::string_view port, const std::string& value) {
  Robot& robot = members_[member];
  // It keeps for every new start what was set.
  if (auto problem = robot.values.set(port, value)) return problem;
  return is_carried(robot) ? change(robot, wire::Change::SET, port, value) : std::nullopt;
}

std::optional<std::string> RemoteRunner::force(Member member, std::string_view sequence,
                                               std::string_view state) {
  Robot& robot = members_[member];
  if (!is_carried(robot)) return robot.values.force(sequence, state);
  return change(robot, wire::Change::FORCE, sequence, state);
}

std::optional<std::string> RemoteRunner::hold(Member member, std::string_view port, std::string_view value) {
  Robot& robot = members_[member];
  if (!is_carried(robot)) return robot.values.hold(port, value);
  return change(robot, wire::Change::HOLD, port, value);
}

std::optional<std::string> RemoteRunner::release(Member member, std::string_view port) {
  Robot& robot = members_[member];
  if (!is_carried(robot)) return robot.values.release(port);
  return change(robot, wire::Change::RELEASE, port, "");
}

bool RemoteRunner::take_over(Member member, const robot::RobotProgram& after, bool /*is_running*/) {
  looked_at(member);
  Robot& robot = members_[member];
  if (!robot.values.take_over(after)) return false;
  // One that is not reached any more fails in the next cycle.
  if (robot.carrier != nullptr) static_cast<void>(put(robot, false));
  return true;
}

std::vector<flow::Restart> RemoteRunner::go_on_from(Member member, const robot::RobotValues& before) {
  Robot& robot = members_[member];
  std::vector<flow::Restart> out = robot.values.go_on_from(before);
  if (robot.carrier == nullptr) return out;
  if (auto problem = put(robot, false))
    out.push_back({robot.values.robot_program().type, std::move(*problem)});
  return out;
}

// Its values as they are now, or, where it can't be reached, as they were known last.
const RemoteRunner::Robot& RemoteRunner::looked_at(Member member) const {
  Robot& robot = members_[member];
  const bool is_known = is_known_well(robot);
  robot.asked = cycle_;
  if (robot.carrier == nullptr || is_known || is_in_cycle_) return robot;
  wire::ToAgent message;
  message.mutable_look()->set_member(robot.number);
  const auto answer = robot.carrier->agent->ask(message, wire::FromAgent::kSeen);
  if (!answer) return robot;
  if (const auto state = decode((*answer)->seen().state(), robot.values.program())) {
    robot.values.adopt(bytes_of(state->frame), state->interventions.get());
    robot.known = cycle_;
  }
  return robot;
}

robot::Workings RemoteRunner::workings(Member member) const {
  return looked_at(member).values.workings();
}

robot::RobotValues* RemoteRunner::values(Member member) {
  looked_at(member);
  return &members_[member].values;
}

flow::Frame RemoteRunner::save(Member member) const {
  return looked_at(member).values.saved();
}

bool RemoteRunner::restore(Member member, const flow::Frame& frame) {
  Robot& robot = members_[member];
  if (!robot.values.restore(frame)) return false;
  return robot.carrier == nullptr || !put(robot, false);
}

std::string RemoteRunner::machine(Member member) const {
  const Carrier* const carrier = members_[member].carrier;
  return carrier != nullptr ? carrier->agent->name() : std::string();
}

bool RemoteRunner::has_lost(Member member) const {
  return members_[member].carrier != nullptr && !is_carried(members_[member]);
}

std::expected<robot::Said, std::string> RemoteRunner::said(Member member) {
  const Robot& robot = members_[member];
  if (robot.carrier == nullptr) return robot::Said{};
  if (is_in_cycle_) return std::unexpected("its agent can't be asked while a cycle is waited for");
  if (const double silent = robot.carrier->agent->silence(); silent > 0.0)
    return std::unexpected(
        fmt::format("the agent on `{}` has been silent for {:.0f} s", robot.carrier->agent->name(), silent));
  return robot.carrier->agent->said(robot.number, kGlanceAtLog);
}

std::vector<robot::SilentMachine> RemoteRunner::silent_machines() const {
  std::vector<robot::SilentMachine> out;
  for (const Carrier& carrier : carriers_) {
    if (carrier.is_given_up || carrier.robots == 0 || !carrier.agent->failure().empty()) continue;
    const double silent = carrier.agent->silence();
    if (!(silent > 0.0)) continue;
    out.push_back(
        {carrier.agent->name(), silent, carrier.agent->patience_with_silence(), waits_for_silent(), {}});
    for (const Robot& robot : members_) {
      if (robot.carrier == &carrier) out.back().robots.push_back(robot.values.robot());
    }
  }
  return out;
}

void RemoteRunner::open() {
  for (Carrier& carrier : carriers_) {
    carrier.cycle.mutable_cycle()->clear_robots();
    carrier.joined.clear();
  }
  for (const Member member : joined_) {
    Robot& robot = members_[member];
    robot.place = robot.carrier->cycle.cycle().robots_size();
    robot.carrier->joined.push_back(member);
    wire::AgentTurn& turn = *robot.carrier->cycle.mutable_cycle()->add_robots();
    turn.set_member(robot.number);
    turn.set_wants_state(robot.asked + 1 >= cycle_ && robot.asked != kLongAgo);
  }
}

void RemoteRunner::needs(std::span<const Member> members, std::span<percept::Needs> out) const {
  for (std::size_t i = 0; i < members.size(); ++i) out[i] = members_[members[i]].needs;
}

void RemoteRunner::act(std::span<const Turn> turns) {
  for (const Turn& turn : turns) {
    Robot& robot = members_[turn.member];
    robot.turn = turn;
    wire::AgentCycle& cycle = *robot.carrier->cycle.mutable_cycle();
    robot_wire::encode(*turn.percepts, *cycle.mutable_robots(robot.place)->mutable_percepts());
  }
}

void RemoteRunner::ask() {
  is_in_cycle_ = true;
  for (Carrier& carrier : carriers_) {
    if (!carrier.joined.empty()) carrier.agent->send_cycle(carrier.cycle);
  }
}

void RemoteRunner::wait(const robot::Meanwhile& meanwhile) {
  ++cycle_;
  for (Carrier& carrier : carriers_) {
    if (carrier.joined.empty()) continue;
    const wire::AgentActed* const acted = carrier.agent->receive_cycle(meanwhile);
    if (acted != nullptr) take_answer(carrier, *acted);
    const std::string failure = carrier.agent->failure();
    if (failure.empty()) continue;
    for (const Member member : carrier.joined) {
      const Turn& turn = members_[member].turn;
      *turn.action = {};
      turn.fault->clear();
      *turn.failure = fmt::format("can't be reached: {}", failure);
    }
  }
  joined_.clear();
  is_in_cycle_ = false;
}

void RemoteRunner::take_answer(Carrier& carrier, const wire::AgentActed& acted) {
  if (acted.robots_size() != static_cast<int>(carrier.joined.size())) {
    carrier.agent->fail(fmt::format("answers for {} robots, and was asked for {}", acted.robots_size(),
                                    carrier.joined.size()));
    return;
  }
  for (int i = 0; i < acted.robots_size(); ++i) {
    Robot& robot = members_[carrier.joined[static_cast<std::size_t>(i)]];
    if (const auto problem = take_action(acted.robots(i), robot)) {
      carrier.agent->fail(
          fmt::format("answers nonsense for robot {}: {}", robot.values.robot().value, *problem));
      return;
    }
  }
}

std::optional<std::string> RemoteRunner::take_action(const wire::AgentAction& acted, Robot& robot) const {
  if (acted.member() != robot.number) return "that is another robot";
  if (!acted.failure().empty()) {
    *robot.turn.action = {};
    *robot.turn.failure = text::shown(acted.failure(), kSentence);
    return std::nullopt;
  }
  if (auto problem = robot_wire::decode(acted.action(), *robot.turn.action)) return problem;
  *robot.turn.fault = text::shown(acted.fault(), 200);
  if (robot.turn.fault->empty() && !robot::is_number(*robot.turn.action)) *robot.turn.fault = "its action";
  robot.needs = robot::bounded(robot_wire::needs_of(acted.needs()));
  if (!acted.has_state()) return std::nullopt;
  const auto state = decode(acted.state(), robot.values.program());
  if (!state) return state.error();
  robot.values.adopt(bytes_of(state->frame), state->interventions.get());
  robot.known = cycle_;
  return std::nullopt;
}

}  // namespace mlab::robot_remote
