#include "mlab/robot/host/robot_program_process.h"

#include <fmt/core.h>

#include "mlab/cell/sanitized.h"
#include "mlab/text/shown.h"

namespace mlab::robot_host {
namespace {

// How long a program that closed its output may take to be gone [s].
constexpr double kEndPatience = 0.5;
constexpr std::chrono::milliseconds kGlance(20);  // between two looks whether anybody still waits

}  // namespace

Launch launch_of(const std::string& executable, cell::Wall wall, const Limits& limits) {
  Launch out{executable, cell::policy_for(executable), wall};
  out.policy.memory = cell::kIsSanitized ? 0 : limits.memory;
  if (wall != cell::Wall::kNone) out.policy.file_size = 0;
  return out;
}

std::expected<RobotProgramProcess, std::string> RobotProgramProcess::start(const Launch& launch,
                                                                           const Limits& limits,
                                                                           const SharedMemory* shared) {
  std::vector<int> files;
  if (shared != nullptr) files = {shared->frames_file(), shared->percepts_file()};
  auto child = ChildProcess::start(launch.executable, launch.policy, launch.wall, files);
  if (!child) return std::unexpected(fmt::format("can't be started: {}", child.error()));
  RobotProgramProcess out(std::move(*child), limits);
  out.patience_ = limits.start;
  wire::ToRobot hello;
  hello.mutable_hello()->set_protocol(robot_wire::kProtocol);
  const wire::FromRobot* answer = out.ask(hello, wire::FromRobot::kWelcome);
  if (answer == nullptr) return std::unexpected(out.failure());
  if (answer->welcome().protocol() != robot_wire::kProtocol) {
    out.fail(fmt::format("speaks version {} of the robot protocol, and this is version {}",
                         answer->welcome().protocol(), robot_wire::kProtocol));
    return std::unexpected(out.failure());
  }
  out.layout_ = answer->welcome().layout();
  out.source_ = answer->welcome().source();
  out.patience_ = limits.answer;
  return out;
}

Clock::time_point RobotProgramProcess::deadline() const {
  return sent_ + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(patience_));
}

void RobotProgramProcess::send(const wire::ToRobot& message) {
  if (has_failed()) return;
  bytes_.clear();
  robot_wire::append_framed(message, bytes_);
  sent_ = Clock::now();
  if (const ChildProcess::Io io = child_.write(bytes_, deadline()); io != ChildProcess::Io::kDone) fail(io);
}

const wire::FromRobot* RobotProgramProcess::receive(wire::FromRobot::BodyCase wanted,
                                                    const Meanwhile& meanwhile) {
  while (!has_failed()) {
    if (const auto message = reader_.next()) {
      if (!answer_.ParseFromArray(message->data(), static_cast<int>(message->size())))
        fail("answers what is no message of the robot protocol");
      else if (answer_.has_problem())
        fail(fmt::format("refuses a message: {}", text::shown(answer_.problem().text(), 200)));
      else if (answer_.body_case() != wanted || !reader_.is_empty())
        fail("answers something else than it was asked");
      break;
    }
    if (reader_.is_nonsense()) {
      fail("writes something to its standard output that is no message of the robot protocol");
      break;
    }
    std::size_t count = 0;
    const Clock::time_point last = deadline();
    const ChildProcess::Io io = child_.read(reader_.room(), count, std::min(last, Clock::now() + kGlance));
    if (io == ChildProcess::Io::kTimedOut && Clock::now() < last) {
      if (!limits_.ends.stop_requested() && !(meanwhile && meanwhile())) continue;
      fail(kNotAwaited);
      break;
    }
    if (io != ChildProcess::Io::kDone) {
      fail(io);
      break;
    }
    reader_.advance(count);
    if (Clock::now() >= deadline()) fail(ChildProcess::Io::kTimedOut);
  }
  return has_failed() ? nullptr : &answer_;
}

void RobotProgramProcess::fail(ChildProcess::Io io) {
  if (io == ChildProcess::Io::kTimedOut) {
    fail(fmt::format("gave no answer for {} s", patience_));
    return;
  }
  std::string how = fmt::format("ended with {}", child_.end(kEndPatience));
  if (const std::string words = child_.last_words(); !words.empty())
    how += fmt::format(", saying: {}", text::shown(words, 200));
  failure_ = std::move(how);
}

void RobotProgramProcess::fail(std::string why) {
  failure_ = std::move(why);
  child_.end(0.0);
}

bool RobotProgramProcess::note_end() {
  if (child_.has_ended()) fail(ChildProcess::Io::kEnded);
  return has_failed();
}

std::expected<std::optional<Revealed>, std::string> reveal(const Launch& launch, const Limits& limits) {
  auto process = RobotProgramProcess::start(launch, limits);
  if (!process) return std::unexpected(process.error());
  if (process->layout() != robot_wire::shared_layout()) return std::nullopt;
  wire::ToRobot message;
  message.mutable_reveal();
  const wire::FromRobot* answer = process->ask(message, wire::FromRobot::kRevealed);
  if (answer == nullptr) return std::unexpected(process->failure());
  return Revealed{answer->revealed(), process->source()};
}

std::expected<wire::Description, std::string> describe(const Launch& launch, const Settings& settings,
                                                       const Limits& limits) {
  auto process = RobotProgramProcess::start(launch, limits);
  if (!process) return std::unexpected(process.error());
  wire::ToRobot message;
  wire::Describe& describe = *message.mutable_describe();
  for (const auto& [port, value] : settings) {
    wire::Setting& setting = *describe.add_settings();
    setting.set_port(port);
    setting.set_value(value);
  }
  const wire::FromRobot* answer = process->ask(message, wire::FromRobot::kDescription);
  if (answer == nullptr) return std::unexpected(process->failure());
  if (answer->description().results_size() != static_cast<int>(settings.size()))
    return std::unexpected("answers something else than it was asked");
  return answer->description();
}

}  // namespace mlab::robot_host
