#include "mlab/robot/process/robot_main.h"

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <google/protobuf/stubs/logging.h>

#include "mlab/base/hash.h"
#include "mlab/flow/network.h"
#include "mlab/robot/process/conversation.h"
#include "mlab/robot/process/member.h"
#include "mlab/robot/process/serve.h"
#include "mlab/robot/process/workings.h"
#include "mlab/robot/wire/network_wire.h"

namespace mlab::robot_process {
namespace {

constexpr int kMisused = 2;

flow::Network network_of(const RobotProgramText& text) {
  std::vector<flow::Network> groups(text.groups.size());
  for (std::size_t i = 0; i < groups.size(); ++i) {
    Wiring wiring(groups[i]);
    text.groups.begin()[i](wiring);
  }
  flow::Network network;
  network.name = text.name;
  Wiring wiring(network);
  text.parameters(wiring);
  std::vector<std::size_t> next(groups.size(), 0);
  for (const auto& [group, count] : text.order) {
    for (std::uint32_t n = 0; n < count; ++n)
      network.nodes.push_back(std::move(groups.at(group).nodes.at(next.at(group)++)));
  }
  return network;
}

flow::Library components_of(const RobotProgramText& text) {
  flow::Library library;
  library.add(text.components());
  return library;
}

/// An executable of `mlab build`: it reveals how it is made, too, unless its author wanted it closed.
class Executable : public Conversation {
 public:
  Executable(Workings& workings, const RobotProgramText& text, std::map<std::string, double> body)
      : Conversation(workings.program(), text.version, std::move(body)), workings_(workings), text_(text) {}

 private:
  bool reveals() const override { return !text_.is_closed; }
  std::uint64_t source() const override {
    std::uint64_t out = 0;
    for (const std::uint64_t one : text_.sources) out = base::combine_bits(out, one);
    return out;
  }
  void begin_sharing(robot_wire::Control& control) override { workings_.trace(control); }
  void answer_other(const wire::ToRobot& message) override {
    if (message.has_reveal() && reveals())
      reveal(*reply().mutable_revealed());
    else
      Conversation::answer_other(message);
  }
  void reveal(wire::Revealed& out) const {
    robot_wire::encode(workings_.network(), *out.mutable_network());
    for (const auto& [file, declarations] : text_.declarations) {
      wire::Declarations& procedures = *out.add_procedures();
      procedures.set_file(file);
      procedures.set_text(declarations);
    }
    workings_.describe(*out.mutable_loaded());
    for (const auto& [name, value] : body()) (*out.mutable_body())[name] = value;
  }

  Workings& workings_;
  const RobotProgramText& text_;
};

void print_help(const RobotProgramText& text, const flow::Program& program) {
  fmt::print(
      "{}: a robot program, made by mlab build {}\n\n"
      "A mission runs it: NEW-ROBOT {} \"./{}\", and mlab run --allow-native. It reads percepts from "
      "standard\n"
      "input and writes actions to standard output, as docs/robot_programs.md describes.\n\n"
      "  ./{} --fleet alpha --name f1   lets runs of the fleet alpha have such robots computed here, until\n"
      "                                 Ctrl-C; --name and what else mlab-agent takes may follow\n\n"
      "parameters\n",
      text.name, text.version, text.name, text.name, text.name);
  for (const flow::Port& port : program.ports()) {
    if (port.role != flow::Port::Role::kParameter) continue;
    const std::string value = flow::Program::print(program.initial_frame().data(), port);
    fmt::print("  {:<32} {}{} = {}  {}\n", port.path, port.type->name,
               port.edge_unit.empty() ? "" : fmt::format(" [{}]", port.edge_unit), value, port.help);
  }
}

}  // namespace

int robot_main(int argc, char** argv, const RobotProgramText& text) {
  const std::span<char* const> arguments(argv + 1, static_cast<std::size_t>(std::max(argc - 1, 0)));
  if (names_fleet(arguments)) return become_member(text, arguments);
  const std::string_view word = arguments.empty() ? "" : arguments[0];
  if (arguments.size() > 1 || (arguments.size() == 1 && word != "--help" && word != "--version")) {
    fmt::print(stderr, "{}: takes no arguments but --help, --version, and those of --fleet\n", text.name);
    return kMisused;
  }
  if (word == "--version") {
    fmt::print("{} made by mlab {}\n", text.name, text.version);
    return 0;
  }
  Workings workings(components_of(text));
  for (const BehaviorList list : text.brought) workings.add(list());
  if (const auto problem = workings.build(network_of(text))) {
    fmt::print(stderr, "{}", *problem);
    return kMisused;
  }
  robot_wire::Control unshared;  // until a run shares one
  workings.trace(unshared);
  if (word == "--help") {
    print_help(text, *workings.program());
    return 0;
  }
  if (isatty(STDIN_FILENO) != 0) {
    fmt::print(stderr, "{}: a run talks to this program, not a person; --help says more\n", text.name);
    return kMisused;
  }
  // A procedure that prints would disturb the conversation: what it says goes to standard error.
  const int out = dup(STDOUT_FILENO);
  if (out < 0 || dup2(STDERR_FILENO, STDOUT_FILENO) < 0) return 1;
  std::signal(SIGPIPE, SIG_IGN);
  google::protobuf::SetLogHandler(nullptr);  // what arrives may be anything, and is answered
  std::map<std::string, double> body;
  for (const auto& [name, value] : text.body) body[name] = value;
  Executable executable(workings, text, std::move(body));
  return serve(executable, STDIN_FILENO, out);
}

}  // namespace mlab::robot_process
