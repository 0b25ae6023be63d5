#include "mlab/console/run/held_values.h"

#include <algorithm>
#include <cstring>

#include "mlab/console/published/overview.h"

namespace mlab::console {
namespace {

using Held = flow::Interventions::Held;

// The value as it is written, not as it stands in the frame: its node may not have fired since.
std::string printed(const flow::Port& port, const Held& held) {
  flow::Port at_begin = port;
  at_begin.offset = 0;
  alignas(flow::Frame::kAlignment) flow::Program::ValueBytes bytes{};
  std::memcpy(bytes.data(), held.value.data(), held.size);
  return clean(flow::Program::print(bytes.data(), at_begin));
}

void encode(std::uint32_t robot, const flow::Program& program, const Held& held, HeldValues& out) {
  HeldValues::Held& told = *out.add_values();
  const flow::Port& port = program.ports()[held.port];
  told.set_robot(robot);
  told.set_port(clean(port.path));
  told.set_value(printed(port, held));
  for (const flow::Port& other : program.ports()) {
    const bool is_same = other.role == flow::Port::Role::kOutput && other.offset == held.offset;
    if (is_same && &other != &port) told.add_also(clean(other.path));
  }
}

}  // namespace

void encode_held(const run::MissionRun& run, HeldValues& out) {
  for (const fleet::FleetRobot& robot : run.fleet().robots()) {
    const robot::Workings with = robot.workings();
    if (with.interventions == nullptr) continue;
    for (const Held& held : with.interventions->held()) encode(robot.id.value, *with.program, held, out);
  }
}

std::vector<std::uint32_t> robots_that_hold(const run::MissionRun& run, const std::string& port) {
  std::vector<std::uint32_t> out;
  for (const fleet::FleetRobot& robot : run.fleet().robots()) {
    const robot::Workings with = robot.workings();
    if (with.interventions == nullptr || with.interventions->held().empty()) continue;
    const flow::Port* known = port.empty() ? nullptr : with.program->find(port);
    const auto is_it = [&](const Held& held) { return known != nullptr && held.offset == known->offset; };
    if (port.empty() || std::ranges::any_of(with.interventions->held(), is_it)) out.push_back(robot.id.value);
  }
  return out;
}

}  // namespace mlab::console
