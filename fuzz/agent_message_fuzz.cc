// Anything that a run sends to an agent, and anything that an agent answers a run, in pieces, each preceded
// by its length in two bytes, little endian. The agent answers each message once, and builds nothing that it
// could not have computed apart; the run says in a sentence what is wrong, and can look at whatever values
// came.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <google/protobuf/stubs/logging.h>

#include "mlab/robot/program/robot_values.h"
#include "mlab/robot/remote/live_robot.h"
#include "mlab/robot/remote/live_runner.h"
#include "mlab/robot/remote/remote_runner.h"
#include "mlab/robot/remote/runner_server.h"
#include "mlab/robot/wire/shared_cycle.h"

namespace {

using namespace mlab;

constexpr const char* kVersion = "fuzz";

void fail(const char* why) {
  std::fprintf(stderr, "%s\n", why);
  std::abort();
}

std::vector<std::string> pieces_of(std::string_view bytes) {
  std::vector<std::string> out;
  for (std::size_t at = 0; at + 2 <= bytes.size();) {
    const auto low = static_cast<unsigned char>(bytes[at]);
    const auto high = static_cast<unsigned char>(bytes[at + 1]);
    const std::size_t length = std::min<std::size_t>(low + 256U * high, bytes.size() - at - 2);
    out.emplace_back(bytes.substr(at + 2, length));
    at += 2 + length;
  }
  return out;
}

/// What such an agent says in real time.
class LiveScript final : public robot_remote::LiveLine {
 public:
  explicit LiveScript(std::vector<std::string> messages) : messages_(std::move(messages)) {}
  bool meet(robot_remote::Clock::time_point /*deadline*/) override { return true; }
  void send(std::string_view key, std::string_view body) override {
    wire::LivePercepts percepts;
    if (key != robot_remote::kBeatKey && !percepts.ParseFromArray(body.data(), static_cast<int>(body.size())))
      fail("the run writes no percepts");
  }
  std::vector<Message> receive(robot_remote::Clock::time_point /*deadline*/) override {
    std::vector<Message> out;
    for (const std::string& body : messages_) {
      for (const char* key : {"0", "1", "nobody"}) out.push_back({key, body, robot_remote::Clock::now()});
    }
    return out;
  }
  void wake() override {}

 private:
  std::vector<std::string> messages_;
};

/// An agent that answers with what it was made with, under the number that is awaited.
class Script final : public robot_remote::Link {
 public:
  explicit Script(std::vector<std::string> answers)
      : answers_(std::move(answers)), live_(std::make_shared<LiveScript>(answers_)) {}

  void send(std::string_view message) override {
    wire::ToAgent sent;
    if (!sent.ParseFromArray(message.data(), static_cast<int>(message.size())))
      fail("the run writes no message");
    number_ = sent.number();
    is_opening_ = sent.has_open();
  }
  std::optional<std::string_view> receive(robot_remote::Clock::time_point /*deadline*/) override {
    if (!failure_.empty()) return std::nullopt;
    wire::FromAgent answer;
    if (is_opening_) {
      answer.mutable_opened()->set_protocol(robot_remote::kAgentProtocol);
      answer.mutable_opened()->set_version(kVersion);
      answer.mutable_opened()->set_layout(robot_wire::shared_layout());
    } else if (next_ == answers_.size()) {
      failure_ = "has no more to say";
      return std::nullopt;
    } else if (!answer.ParseFromString(answers_[next_++])) {
      bytes_ = answers_[next_ - 1];
      return bytes_;
    }
    answer.set_number(number_);
    bytes_ = answer.SerializeAsString();
    return bytes_;
  }
  const std::string& failure() const override { return failure_; }
  void fail(std::string why) override { failure_ = std::move(why); }
  std::shared_ptr<robot_remote::LiveLine> live() override { return live_; }

 private:
  static void fail(const char* why) { ::fail(why); }

  std::vector<std::string> answers_;
  std::size_t next_ = 0;
  std::uint64_t number_ = 0;
  bool is_opening_ = false;
  std::string bytes_;
  std::string failure_;
  std::shared_ptr<LiveScript> live_;
};

const robot::RobotProgram& standard_robot() {
  static const robot::RobotProgram kRobot = [] {
    text::Diagnostics sink;
    auto out = robot::load_program("robot", {}, {}, {}, {}, sink);
    if (!out) fail("there is no standard robot");
    return std::move(*out);
  }();
  return kRobot;
}

void look_at(const robot::Workings& workings) {
  for (const flow::Port& port : workings.program->ports()) flow::Program::print(workings.frame, port);
  workings.program->active_states(workings.frame);
  workings.program->contributions(workings.frame);
  workings.program->find_fault(workings.frame);
}

template <typename Runner, typename... Arguments>
void try_run(const std::vector<std::string>& answers, double period, Arguments... arguments) {
  auto agent = std::make_unique<robot_remote::Agent>("fuzz", std::make_unique<Script>(answers));
  if (agent->open(1, kVersion, period)) fail("the script does not open");
  std::vector<std::unique_ptr<robot_remote::Agent>> agents;
  agents.push_back(std::move(agent));
  Runner runner(
      [&](const robot::RobotProgram& /*program*/, const std::vector<std::string>& /*lost*/)
          -> robot_remote::RemoteRunner::Newcomers { return {std::exchange(agents, {}), "it has gone"}; },
      arguments...);
  const auto member = runner.add({1}, standard_robot());
  if (const auto problem = runner.start(member)) {
    if (problem->empty()) fail("it does not start, and nobody knows why");
    return;
  }
  for (int cycle = 0; cycle < 3; ++cycle) {
    percept::Percepts percepts;
    percept::Action action;
    percept::Needs needs;
    std::string fault;
    std::string failure;
    runner.needs({&member, 1}, {&needs, 1});
    runner.join(member);
    runner.open();
    const robot::ProgramRunner::Turn turn{member, &percepts, &action, &fault, &failure};
    runner.act({&turn, 1});
    runner.ask();
    runner.wait({});
    if (fault.empty() && failure.empty() && !robot::is_number(action))
      fail("it drives with what is no number");
    look_at(runner.workings(member));
    static_cast<void>(runner.hold(member, "speed", "1"));
  }
}

// A robot in real time, at its agent.
void try_live_robot(const std::vector<std::string>& pieces) {
  robot_remote::LiveRobot robot;
  const auto now = robot_remote::Clock::now();
  for (const std::string& piece : pieces) {
    wire::LivePercepts percepts;
    if (!percepts.ParseFromString(piece) || !robot.hear(percepts, now)) continue;
    if (!(robot.age(now) >= 0.0)) fail("percepts are of the future");
    static_cast<void>(robot.percepts(now));
    wire::LiveAction action;
    robot.answer(now, action);
    if (robot.is_fresh()) fail("it acts on the same percepts again");
    static_cast<void>(action.mutable_action()->ParseFromString(piece));
    robot.keep_requests(action);
  }
}

}  // namespace

// libFuzzer's name, not ours.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {  // NOLINT(readability-identifier-naming)
  static const auto kLog = google::protobuf::SetLogHandler(nullptr);
  static_cast<void>(kLog);
  const std::vector<std::string> pieces = pieces_of({reinterpret_cast<const char*>(data), size});
  robot::ProgramSources sources;
  sources.version = kVersion;
  robot_remote::RunnerServer server({.sources = sources});
  for (const std::string& piece : pieces) {
    wire::FromAgent answer;
    server.hear({"1", piece, robot_remote::Clock::now()});
    const std::string_view bytes = server.answer(piece);
    if (!answer.ParseFromArray(bytes.data(), static_cast<int>(bytes.size())) ||
        answer.body_case() == wire::FromAgent::BODY_NOT_SET)
      fail("a message is not answered");
  }
  if (server.robot_count() != 0) fail("an agent that may run nothing carries robots");
  try_run<robot_remote::RemoteRunner>(pieces, 0.0);
  try_run<robot_remote::LiveRunner>(pieces, 0.001, 0.001);
  try_live_robot(pieces);
  return 0;
}
