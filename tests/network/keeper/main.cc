// Makes a host for tests, keeps it, and ends it with all that is on it when the test closes its socket, kills
// it, or is no more. It is told all by messages (keeper/setup.h, message.h); people have no use for it.

#include <poll.h>
#include <sys/prctl.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>

#include "keeper/children.h"
#include "keeper/failure.h"
#include "keeper/interfaces.h"
#include "keeper/namespaces.h"
#include "message.h"
#include "pidfd.h"

namespace mlab::network {
namespace {

Message answer_to(Message request, Children& children) {
  Message answer;
  answer.words = {"failed", "no such request"};
  if (request.words.empty()) return answer;
  const std::string what = request.words[0];
  request.words.erase(request.words.begin());
  if (what == "start") return children.start(std::move(request));
  if (what == "end" && request.words.size() == 1) {
    children.kill_group(std::atoi(request.words[0].c_str()));
    answer.words = {"done"};
  } else if (what == "disk" && request.words.size() == 2) {
    try {
      mount_disk(request.words[0], request.words[1]);
      answer.words = {"done"};
    } catch (const Failure& failure) {
      answer.words = {"failed", failure.what()};
    }
  }
  return answer;
}

void answer_with(const Message& answer) {
  std::vector<int> files;
  for (const Descriptor& file : answer.files) files.push_back(file.number());
  send_message(kKeeperSocket, answer.words, files);
}

/// The first process of the host. Its end is that of all others.
[[noreturn]] void keep(const KeeperSetup& setup) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  set_broken_pipe(SIG_IGN);
  sigset_t ended;
  sigemptyset(&ended);
  sigaddset(&ended, SIGCHLD);
  ::pthread_sigmask(SIG_BLOCK, &ended, nullptr);
  const Descriptor signals(::signalfd(-1, &ended, SFD_CLOEXEC | SFD_NONBLOCK));
  try {
    make_file_systems(setup);
    const Descriptor wire = make_interfaces(setup);
    send_message(kKeeperSocket, {"ready"}, {wire.number()});
  } catch (const std::exception& failure) {
    send_message(kKeeperSocket, {"failed", failure.what()});
    ::_exit(1);
  }
  Children children;
  std::array<pollfd, 2> wanted = {pollfd{kKeeperSocket, POLLIN, 0}, pollfd{signals.number(), POLLIN, 0}};
  for (;;) {
    ::poll(wanted.data(), wanted.size(), -1);
    signalfd_siginfo one{};
    while (::read(signals.number(), &one, sizeof one) > 0) children.reap();
    if (wanted[0].revents == 0) continue;
    std::optional<Message> request = receive_message(kKeeperSocket);
    if (!request) ::_exit(0);
    answer_with(answer_to(std::move(*request), children));
  }
}

int make_host() {
  const std::optional<Message> told = receive_message(kKeeperSocket);
  const std::optional<KeeperSetup> setup = told ? KeeperSetup::read(told->words) : std::nullopt;
  if (!setup) return 2;
  try {
    leave_machine(*setup);
  } catch (const std::exception& failure) {
    send_message(kKeeperSocket, {"failed", failure.what()});
    return 1;
  }
  const pid_t first = ::fork();
  if (first == 0) keep(*setup);
  if (first < 0) {
    send_message(kKeeperSocket, {"failed", "forking: " + std::generic_category().message(errno)});
    return 1;
  }
  const Descriptor handle = open_pidfd(first);
  send_message(kKeeperSocket, {"first"}, {handle.number()});
  ::close(kKeeperSocket);
  ::waitpid(first, nullptr, 0);
  return 0;
}

}  // namespace
}  // namespace mlab::network

// Not by return: what sanitizers want to do then they can't without a first process.
int main() {
  ::_exit(mlab::network::make_host());
}
