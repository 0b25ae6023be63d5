#include "mlab/history/answer_writer.h"

#include <algorithm>
#include <utility>

#include "mlab/robot/program/native_program.h"
#include "mlab/robot/wire/action_wire.h"
#include "mlab/robot/wire/percepts_wire.h"

namespace mlab::history {
namespace {

// True where it is another one than what was said.
bool replace(std::string& said, const google::protobuf::Message& message, bool is_first) {
  std::string bytes = message.SerializeAsString();
  if (!is_first && bytes == said) return false;
  said = std::move(bytes);
  return true;
}

void put_number(const std::string& name, double value, wire::HistoryNumber& out) {
  out.set_name(name);
  out.set_value(value);
}

void put_numbers(const robot::RobotProgram& program, wire::HistoryExecutable& out) {
  const auto put = [&](const std::string& path) {
    if (const std::optional<double> number = program.number(path))
      put_number(path, *number, *out.add_numbers());
  };
  if (program.recorded) {
    for (const auto& [path, number] : program.recorded->numbers) put(path);
  } else if (program.native) {
    for (const wire::Port& port : program.native->description.ports()) {
      if (port.role() == wire::Port::PARAMETER) put(port.path());
    }
  } else {
    for (const flow::Port& port : program.program->ports()) {
      if (port.role == flow::Port::Role::kParameter) put(port.path);
    }
  }
}

}  // namespace

AnswerWriter::AnswerWriter(const run::MissionRun& run)
    : run_(run),
      are_late_(run.settings().is_in_real_time || run.settings().recorded.is_of_all),
      to_(run.cycle()),
      time_(run.time()),
      taken_(run.cycle()) {}

void AnswerWriter::take_up(const run::Crew& crew) {
  is_needed_ =
      is_needed_ || are_late_ || std::ranges::any_of(crew.programs, &robot::RobotProgram::is_in_executable);
}

wire::HistoryExecutable AnswerWriter::describe(const robot::RobotProgram& program) {
  wire::HistoryExecutable out;
  out.set_name(program.name);
  out.set_type(program.type);
  out.set_is_open(!program.is_closed());
  out.set_reports(program.tells.reports);
  for (const auto& [name, value] : program.body) put_number(name, value, *out.add_body());
  const auto [at, is_new] =
      builds_.try_emplace({program.native ? program.native->executable : "", program.program.get(),
                           program.recorded ? program.recorded->build : 0},
                          static_cast<std::uint32_t>(builds_.size() + 1));
  if (is_new) built_.push_back(program.program);
  out.set_build(at->second);
  put_numbers(program, out);
  return out;
}

bool AnswerWriter::is_answered_for(const fleet::FleetRobot& robot) const {
  if (robot.runner == nullptr) return false;
  return robot.program->is_in_executable() || (are_late_ && robot.program->can_be_elsewhere());
}

void AnswerWriter::note_start(const fleet::FleetRobot& robot) {
  if (robot.runner == nullptr || robot.failure.empty()) return;
  wire::HistoryNotStarted& out = *noted_.add_not_started();
  out.set_before(static_cast<std::uint32_t>(run_.cycle()));
  out.set_robot(robot.id.value);
  out.set_start(robot.starts);
  out.set_failure(robot.failure);
}

void AnswerWriter::note_asked(std::span<const fleet::FleetRobot> robots) {
  if (!is_needed_) return;
  asked_.resize(robots.size());
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const fleet::FleetRobot& robot = robots[i];
    if (robot.life != fleet::RobotLife::kRunning || !is_answered_for(robot)) continue;
    robot.runner->needs({&robot.member, 1}, {&asked_[i], 1});
  }
}

void AnswerWriter::note_answered(std::span<const fleet::FleetRobot> robots) {
  for (std::size_t i = 0; i < robots.size(); ++i) {
    if (is_needed_ && is_answered_for(robots[i]))
      note(robots[i], i);
    else
      note_failure(robots[i]);
  }
  to_ = run_.cycle();
  time_ = run_.time();
}

void AnswerWriter::note_failure(const fleet::FleetRobot& robot) {
  if (robot.failure.empty() || robot.life != fleet::RobotLife::kRunning) return;
  wire::HistoryFailed& out = *noted_.add_failed();
  out.set_before(static_cast<std::uint32_t>(run_.cycle()));
  out.set_robot(robot.id.value);
  out.set_failure(robot.failure);
}

void AnswerWriter::note(const fleet::FleetRobot& robot, std::size_t index) {
  const bool runs = robot.life == fleet::RobotLife::kRunning;
  const bool is_heard = are_late_ && robot.failsafes != 0;
  if (!runs && !(is_heard && robot.life == fleet::RobotLife::kFaulted)) return;
  Said& said = said_[robot.id];
  const bool is_first = !std::exchange(said.is_there, true);
  wire::HistoryAnswer out;
  bool has_news = is_first;
  if (runs && robot.fault.empty() && robot.failure.empty()) {
    robot_wire::encode(robot.action, *out.mutable_action());
    if (replace(said.action, out.action(), is_first))
      has_news = true;
    else
      out.clear_action();
  }
  if (runs) {
    robot_wire::encode(asked_[index], *out.mutable_needs());
    if (replace(said.needs, out.needs(), is_first))
      has_news = true;
    else
      out.clear_needs();
  }
  if (is_heard) {
    out.mutable_hearing()->set_silence(robot.runner->silence(robot.member));
    out.mutable_hearing()->set_percept_age(robot.runner->percept_age(robot.member));
    if (replace(said.hearing, out.hearing(), is_first))
      has_news = true;
    else
      out.clear_hearing();
  }
  if (runs && !robot.fault.empty()) out.set_fault(robot.fault);
  if (runs && !robot.failure.empty()) out.set_failure(robot.failure);
  if (!has_news && out.fault().empty() && out.failure().empty()) return;
  out.set_before(static_cast<std::uint32_t>(run_.cycle()));
  out.set_robot(robot.id.value);
  *noted_.add_answers() = std::move(out);
}

void AnswerWriter::note_cycle() {
  to_ = run_.cycle();
  time_ = run_.time();
}

std::optional<wire::HistoryEntry> AnswerWriter::take() {
  if (!has_failures() && (!is_needed_ || to_ == taken_)) return std::nullopt;
  const auto count_back = [this](auto& one) {
    one.set_before(static_cast<std::uint32_t>(to_) - one.before());
  };
  std::ranges::for_each(*noted_.mutable_answers(), count_back);
  std::ranges::for_each(*noted_.mutable_not_started(), count_back);
  std::ranges::for_each(*noted_.mutable_failed(), count_back);
  wire::HistoryEntry out;
  out.set_cycle(to_);
  out.set_time(time_);
  *out.mutable_answers() = std::exchange(noted_, {});
  taken_ = to_;
  said_.clear();
  return out;
}

}  // namespace mlab::history
