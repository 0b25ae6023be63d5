// mlab-robots: robots whose mission or configuration brings procedures of its own, in a process of their own.
// `mlab` starts it in a cell and talks to it; src/mlab/robot_runner/README.md says more.

#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <string_view>

#include <fmt/core.h>
#include <google/protobuf/stubs/logging.h>

#include "mlab/library/library.h"
#include "mlab/robot_process/serve.h"
#include "mlab/robot_runner/host.h"

namespace {

constexpr int kMisused = 2;

mlab::robot_wire::Control* control_of_process = nullptr;

// Told before the process ends, because what ends it is a signal like any other.
void tell_out_of_memory() {
  std::set_new_handler(nullptr);
  if (control_of_process != nullptr) control_of_process->out_of_memory.store(1);
  std::fputs("out of memory\n", stderr);
  std::abort();
}

/// Lets the handler above find what is shared.
class RunnerHost : public mlab::robot_runner::Host {
 public:
  using Host::Host;
  mlab::robot_process::SharedFiles* shared() override {
    mlab::robot_process::SharedFiles* files = Host::shared();
    if (files != nullptr) control_of_process = &files->control();
    return files;
  }
};

}  // namespace

int main(int argc, char** argv) {
  const std::string_view word = argc > 1 ? argv[1] : "";
  if (word == "--help") {
    fmt::print(
        "mlab-robots: runs robots whose mission or configuration brings procedures of its own\n\n"
        "mlab starts this program by itself, in a cell without network, files or processes, and talks to it\n"
        "over standard input and output. There is nothing to do with it by hand.\n");
    return 0;
  }
  if (argc > 1 || isatty(STDIN_FILENO) != 0) {
    fmt::print(stderr, "mlab-robots: mlab talks to this program, not a person; --help says more\n");
    return kMisused;
  }
  // A procedure that prints would disturb the conversation: what it says goes to standard error.
  const int out = dup(STDOUT_FILENO);
  if (out < 0 || dup2(STDERR_FILENO, STDOUT_FILENO) < 0) return 1;
  std::signal(SIGPIPE, SIG_IGN);
  std::set_new_handler(tell_out_of_memory);
  google::protobuf::SetLogHandler(nullptr);  // what arrives may be anything, and is answered
  mlab::flow::Library components;
  components.add(mlab_library_behaviors());
  RunnerHost host(std::move(components), MLAB_VERSION);
  return mlab::robot_process::serve(host, STDIN_FILENO, out);
}
