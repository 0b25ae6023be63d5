#include "mlab/robot/program/robot_values.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include <fmt/core.h>

#include "mlab/robot/host/hosted_program.h"

namespace mlab::robot {
namespace {

// Compiled procedures are kept under a name that says what they were made of.
bool has_same_code(const RobotProgram& a, const RobotProgram& b) {
  if (!a.hosted || !b.hosted) return !a.hosted && !b.hosted;
  if (!a.hosted->load || !b.hosted->load) return false;
  return std::ranges::equal(a.hosted->load->libraries(), b.hosted->load->libraries());
}

}  // namespace

void RobotValues::start() {
  has_started_ = true;
  frame_ = program_->initial;
  for (const auto& [port, value] : set_) program().set(frame_.data(), program().ports()[port], value);
  if (interventions_) interventions_->begin_anew(frame_.data());
}

std::optional<std::string> RobotValues::force(std::string_view sequence, std::string_view state) {
  if (!interventions_) interventions_ = std::make_unique<flow::Interventions>();
  return interventions_->force(program(), frame_.data(), sequence, state);
}

std::optional<std::string> RobotValues::hold(std::string_view port, std::string_view value) {
  if (!interventions_) interventions_ = std::make_unique<flow::Interventions>();
  return interventions_->hold(program(), frame_.data(), port, value);
}

std::optional<std::string> RobotValues::release(std::string_view port) {
  if (!interventions_)
    return port.empty() ? std::nullopt : std::optional(fmt::format("`{}` is not held", port));
  return interventions_->release(program(), frame_.data(), port);
}

void RobotValues::finish() {
  interventions_->finish();
  if (interventions_->is_empty()) interventions_.reset();
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

std::vector<flow::Restart> RobotValues::go_on_from(const RobotValues& before) {
  has_started_ = before.has_started_;
  std::vector<flow::Restart> restarts;
  const bool is_same_code = has_same_code(*before.program_, *program_);
  // What a stranger's process has left may be anything, and our own code would stand on it.
  const bool is_trusted = !before.program_->hosted || program_->hosted;
  if (is_trusted) {
    flow::Frame free = before.frame_;
    if (before.interventions_) before.interventions_->let_go(free.data());
    flow::CarriedOver carried = flow::carry_over({before.program(), before.program_->initial}, free.data(),
                                                 {program(), program_->initial}, is_same_code);
    frame_ = std::move(carried.frame);
    restarts = std::move(carried.restarts);
  } else {
    frame_ = program_->initial;
    restarts.push_back({program_->type, "begins anew as a whole: a process of its own has computed it"});
  }
  set_again(before, restarts);
  if (before.interventions_) {
    interventions_ = std::make_unique<flow::Interventions>(*before.interventions_);
    const std::byte* const old_frame = is_trusted ? before.frame_.data() : nullptr;
    for (auto& [path, why] :
         interventions_->carry_over(before.program(), old_frame, program(), frame_.data(), is_same_code))
      restarts.push_back({std::move(path), std::move(why)});
    if (interventions_->is_empty()) interventions_.reset();
  }
  return restarts;
}

void RobotValues::set_again(const RobotValues& before, std::vector<flow::Restart>& restarts) {
  for (const auto& [index, value] : before.set_) {
    const flow::Port* const mine = program().find(before.program().ports()[index].path);
    if (mine == nullptr) continue;
    const auto problem = program().set(frame_.data(), *mine, value);
    if (!problem)
      set_[static_cast<std::uint32_t>(mine - program().ports().data())] = value;
    else if (std::ranges::find(restarts, flow::Restart{mine->path, flow::kOutOfRange}) == restarts.end())
      restarts.push_back({mine->path, fmt::format("is as the text says: {}", *problem)});
  }
}

bool RobotValues::restore(const flow::Frame& frame) {
  if (frame.size() != frame_.size()) return false;
  frame_ = frame;
  if (interventions_) interventions_->begin_anew(frame_.data());
  return true;
}

RobotMemory RobotValues::memory() const {
  return {program_,
          {program_->initial, frame_},
          interventions_ ? std::make_shared<const flow::Interventions>(*interventions_) : nullptr,
          set_,
          has_started_};
}

void RobotValues::remember(const RobotMemory& memory) {
  program_ = memory.program;
  memory.values.apply(program_->initial, frame_);
  interventions_ =
      memory.interventions ? std::make_unique<flow::Interventions>(*memory.interventions) : nullptr;
  set_ = memory.set;
  has_started_ = memory.has_started;
}

std::size_t RobotMemory::bytes() const {
  constexpr std::size_t kNode = 48;  // of a map, beside what it holds
  std::size_t out = sizeof *this + values.bytes() + (interventions ? sizeof *interventions : 0);
  for (const auto& [port, value] : set)
    out += kNode + sizeof(std::uint32_t) + sizeof(std::string) + value.capacity();
  return out;
}

void RobotValues::adopt(std::span<const std::byte> frame, const flow::Interventions* interventions) {
  std::memcpy(frame_.data(), frame.data(), frame_.size());
  if (interventions == nullptr)
    interventions_.reset();
  else if (interventions_)
    *interventions_ = *interventions;
  else
    interventions_ = std::make_unique<flow::Interventions>(*interventions);
}

std::string RobotValues::find_fault() const {
  const flow::Port* port = program().find_fault(frame_.data());
  return port != nullptr ? port->path : "its action";
}

}  // namespace mlab::robot
