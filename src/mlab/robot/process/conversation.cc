#include "mlab/robot/process/conversation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "mlab/robot/wire/action_wire.h"
#include "mlab/robot/wire/percepts_wire.h"

namespace mlab::robot_process {
namespace {

using flow::Port;
using flow::Program;

void put(const std::byte* frame, const Port& port, wire::PortValue& out) {
  out.set_text(Program::print(frame, port));
  if (const auto number = Program::number(frame, port)) out.set_number(*number);
}

const Port* settable(const Program& program, std::string_view path) {
  const Port* port = program.find(path);
  return port == nullptr || port->role == Port::Role::kOutput ? nullptr : port;
}

// Nothing where the setting was taken.
std::optional<std::string> take(const Program& program, const wire::Setting& setting, flow::Frame& frame) {
  const Port* port = settable(program, setting.port());
  if (port == nullptr) return fmt::format("the program has no parameter `{}`", setting.port());
  return program.set(frame.data(), *port, setting.value());
}

}  // namespace

Conversation::Conversation(const std::shared_ptr<const Program>& program, std::string version,
                           std::map<std::string, double> body)
    : Speaker(program->name(), std::move(version)), program_(program), body_(std::move(body)) {}

void Conversation::answer_other(const wire::ToRobot& message) {
  switch (message.body_case()) {
    case wire::ToRobot::kDescribe:
      describe(message.describe());
      break;
    case wire::ToRobot::kStart:
      start(message.start());
      break;
    case wire::ToRobot::kCycle:
      act(message.cycle());
      break;
    case wire::ToRobot::kSet:
      set(message.set());
      break;
    case wire::ToRobot::kReadPorts:
      read_ports(message.read_ports());
      break;
    case wire::ToRobot::kLoad:
      refuse("this program has its procedures already");
      break;
    default:
      refuse("a message of a kind that this program does not know");
      break;
  }
}

Conversation::Robot* Conversation::find(std::uint32_t id) {
  const auto at = robots_.find(id);
  return at == robots_.end() ? nullptr : &at->second;
}

void Conversation::describe(const wire::Describe& message) {
  wire::Description& out = *reply().mutable_description();
  flow::Frame frame = program_->make_frame();
  for (const wire::Setting& setting : message.settings()) {
    wire::SettingResult& result = *out.add_results();
    result.set_is_unknown(settable(*program_, setting.port()) == nullptr);
    if (!result.is_unknown()) {
      if (auto problem = take(*program_, setting, frame)) result.set_problem(std::move(*problem));
    }
  }
  for (const auto& [name, value] : body_) (*out.mutable_body())[name] = value;
  for (const Port& port : program_->ports()) {
    wire::Port& described = *out.add_ports();
    described.set_path(port.path);
    described.set_role(static_cast<wire::Port::Role>(port.role));
    described.set_type(std::string(port.type->name));
    described.set_unit(port.edge_unit);
    described.set_help(port.help);
    described.set_min(port.min);
    described.set_max(port.max);
    put(frame.data(), port, *described.mutable_value());
  }
}

void Conversation::start(const wire::Start& message) {
  Robot robot{program_->make_frame(), message.seed()};
  wire::Ready& ready = *reply().mutable_ready();
  for (const wire::Setting& setting : message.settings()) {
    if (auto problem = take(*program_, setting, robot.frame)) {
      ready.set_problem(std::move(*problem));
      return;
    }
  }
  robot_wire::encode(program_->needs(robot.frame.data()), *ready.mutable_needs());
  robots_.insert_or_assign(message.robot(), std::move(robot));
}

// All of it, before any robot acts.
std::optional<std::string> Conversation::check(const wire::Cycle& cycle) {
  std::vector<std::uint32_t> ids;
  for (const wire::RobotCycle& message : cycle.robots()) {
    if (find(message.robot()) == nullptr)
      return fmt::format("robot {} was never started here", message.robot());
    if (decoded_.size() == ids.size()) decoded_.push_back(std::make_unique<robot_wire::DecodedPercepts>());
    if (const auto problem = decoded_[ids.size()]->decode(message.percepts()))
      return fmt::format("the percepts of robot {}: {}", message.robot(), *problem);
    ids.push_back(message.robot());
  }
  std::ranges::sort(ids);
  if (const auto twice = std::ranges::adjacent_find(ids); twice != ids.end())
    return fmt::format("robot {} stands in one cycle twice", *twice);
  return std::nullopt;
}

void Conversation::act(const wire::Cycle& cycle) {
  if (auto problem = check(cycle)) {
    refuse(std::move(*problem));
    return;
  }
  wire::Actions& out = *reply().mutable_actions();
  for (int i = 0; i < cycle.robots_size(); ++i)
    act(cycle.robots(i).robot(), decoded_[static_cast<std::size_t>(i)]->percepts(), *out.add_robots());
}

void Conversation::act(std::uint32_t id, const percept::Percepts& percepts, wire::RobotActed& out) {
  Robot& robot = robots_.at(id);
  percept::Action action;
  program_->step(robot.frame.data(), percepts, action, robot.seed, id);
  out.set_robot(id);
  robot_wire::encode(action, *out.mutable_action());
  robot_wire::encode(program_->needs(robot.frame.data()), *out.mutable_needs());
  const geom::Vector v = action.velocity;
  if (!std::isfinite(v.x + v.y + v.z + action.spin)) {
    const Port* port = program_->find_fault(robot.frame.data());
    out.set_fault(port == nullptr ? "its action" : port->path);
  }
}

void Conversation::set(const wire::Set& message) {
  Robot* robot = find(message.robot());
  if (robot == nullptr) {
    refuse(fmt::format("robot {} was never started here", message.robot()));
    return;
  }
  wire::Ready& ready = *reply().mutable_ready();
  if (auto problem = take(*program_, message.setting(), robot->frame)) ready.set_problem(std::move(*problem));
  robot_wire::encode(program_->needs(robot->frame.data()), *ready.mutable_needs());
}

void Conversation::read_ports(const wire::ReadPorts& read) {
  const Robot* robot = find(read.robot());
  if (robot == nullptr) {
    refuse(fmt::format("robot {} was never started here", read.robot()));
    return;
  }
  const std::vector<Port>& ports = program_->ports();
  for (const std::uint32_t index : read.ports()) {
    if (index >= ports.size()) {
      refuse(fmt::format("there is no port {}: the program has {}", index, ports.size()));
      return;
    }
  }
  wire::PortValues& out = *reply().mutable_port_values();
  const std::byte* const frame = robot->frame.data();
  for (const std::uint32_t index : read.ports()) put(frame, ports[index], *out.add_values());
  if (read.ports().empty()) {
    for (const Port& port : ports) put(frame, port, *out.add_values());
  }
  for (std::string& state : program_->active_states(frame)) out.add_active_states(std::move(state));
}

}  // namespace mlab::robot_process
