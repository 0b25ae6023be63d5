#include "mlab/console/session/robot_parameters.h"

#include <utility>

#include <fmt/core.h>

#include "mlab/console/published/overview.h"

namespace mlab::console {

Answered RobotParameters::read(const Robots& robots, const std::string& port,
                               std::vector<std::string>& values) const {
  for (const std::uint32_t id : robots) {
    const fleet::FleetRobot* robot = run_.live()->run().fleet().find({id});
    if (robot == nullptr) return fmt::format("there is no robot {}", id);
    const flow::Port* found = robot->workings().program ? robot->workings().program->find(port) : nullptr;
    if (found == nullptr) return fmt::format("the program of robot {} has no `{}`", id, clean(port));
    values.push_back(flow::Program::print(robot->workings().frame, *found));
  }
  return std::nullopt;
}

Answered RobotParameters::set(const Sender& sender, const SetParameter& set) {
  if (run_.live() == nullptr) return "there is no mission that could run";
  const Robots robots(set.robots().begin(), set.robots().end());
  if (robots.empty()) return "no robot is named";
  const std::string& port = set.port();
  std::vector<std::string> before;
  if (auto error = read(robots, port, before)) return error;
  const std::vector<std::string> after(robots.size(), set.value());
  if (auto error = apply(robots, port, after)) {
    apply(robots, port, before);
    return error;
  }
  const std::string whose =
      robots.size() == 1 ? fmt::format("robot {}", robots[0]) : fmt::format("{} robots", robots.size());
  documents::EditLog::Edit edit;
  edit.name = fmt::format("{} of {}", clean(port), whose);
  edit.undo = [this, robots, port, before] { apply(robots, port, before); };
  edit.redo = [this, robots, port, after] { apply(robots, port, after); };
  documents_.add_edit(std::move(edit), wall_time());
  log_.add(run_.sim_time(),
           {Log::EDIT,
            fmt::format("{}: {} = {} for {}", sender.client.name, clean(port), clean(set.value()), whose),
            robots.size() == 1 ? robots[0] : 0,
            "",
            {},
            false});
  return std::nullopt;
}

Answered RobotParameters::apply(const Robots& robots, const std::string& port,
                                const std::vector<std::string>& values) {
  run_.world_changed();
  for (std::size_t i = 0; i < robots.size(); ++i) {
    if (run_.live() != nullptr) {
      if (auto error = run_.live()->run().set_parameter({robots[i]}, port, values[i])) return error;
    }
    values_[robots[i]][port] = values[i];
  }
  return std::nullopt;
}

void RobotParameters::recall(const std::vector<history::InputEntry>& inputs) {
  values_.clear();
  for (const history::InputEntry& one : inputs) {
    const wire::HistoryParameter& set = one.input.parameter();
    if (one.input.has_parameter()) values_[set.robot()][set.port()] = set.value();
  }
}

void RobotParameters::apply_all() {
  if (run_.live() == nullptr) return;
  for (const auto& [robot, ports] : values_) {
    for (const auto& [port, value] : ports) run_.live()->run().set_parameter({robot}, port, value);
  }
}

}  // namespace mlab::console
