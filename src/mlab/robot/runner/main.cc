// mlab-robots: robots whose mission or configuration brings procedures of its own, in a process of their own.
// `mlab` starts it in a cell and talks to it; src/mlab/robot/runner/README.md says more.

#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <string_view>

#include <fmt/core.h>
#include <google/protobuf/stubs/logging.h>

#include "mlab/library/library.h"
#include "mlab/robot/process/serve.h"
#include "mlab/robot/runner/host.h"

namespace {

constexpr int kMisused = 2;

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
  google::protobuf::SetLogHandler(nullptr);  // what arrives may be anything, and is answered
  mlab::flow::Library components;
  components.add(mlab_library_behaviors());
  mlab::robot_runner::Host host(std::move(components), MLAB_VERSION);
  return mlab::robot_process::serve(host, STDIN_FILENO, out);
}
