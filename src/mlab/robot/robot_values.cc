#include "mlab/robot/robot_values.h"

#include <cstring>

#include <fmt/core.h>

namespace mlab::robot {

void RobotValues::start() {
  has_started_ = true;
  frame_ = program_->initial;
  for (const auto& [port, value] : set_) program().set(frame_.data(), program().ports()[port], value);
}

std::optional<std::string> RobotValues::set(std::string_view path, const std::string& value) {
  const flow::Port* port = program().find(path);
  if (port == nullptr) return fmt::format("the program of robot {} has no `{}`", robot_.value, path);
  if (auto problem = program().set(frame_.data(), *port, value)) return problem;
  set_[static_cast<std::uint32_t>(port - program().ports().data())] = value;
  return std::nullopt;
}

bool RobotValues::take_over(const RobotProgram& after) {
  if (after.program != program_->program) return false;
  if (!has_started_) {
    frame_ = after.initial;
  } else {
    for (const flow::Port& port : after.program->ports()) {
      if (port.role == flow::Port::Role::kOutput) continue;
      const std::byte* const old_value = program_->initial.data() + port.offset;
      const std::byte* const new_value = after.initial.data() + port.offset;
      if (std::memcmp(old_value, new_value, port.type->size) != 0)
        std::memcpy(frame_.data() + port.offset, new_value, port.type->size);
    }
  }
  program_ = &after;
  return true;
}

bool RobotValues::restore(const flow::Frame& frame) {
  if (frame.size() != frame_.size()) return false;
  frame_ = frame;
  return true;
}

std::string RobotValues::find_fault() const {
  const flow::Port* port = program().find_fault(frame_.data());
  return port != nullptr ? port->path : "its action";
}

}  // namespace mlab::robot
