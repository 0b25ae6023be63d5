#include "connection.h"

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <stdexcept>

#include "mlab/cell/tied_fork.h"

namespace mlab::network {
namespace {

[[noreturn]] void become_keeper(int socket) {
  if (socket == kKeeperSocket)
    ::fcntl(socket, F_SETFD, 0);
  else
    ::dup2(socket, kKeeperSocket);
  ::close_range(kKeeperSocket + 1, ~0U, 0);
  ::execl(MLAB_NETWORK_KEEPER, MLAB_NETWORK_KEEPER, nullptr);
  ::_exit(127);
}

}  // namespace

Connection::Connection(const KeeperSetup& setup) {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0)
    throw std::runtime_error("no socket for a host");
  socket_ = Descriptor(ends[0]);
  Descriptor other(ends[1]);
  keeper_ = cell::tied_fork([number = other.number()] { become_keeper(number); });
  other.close();
  send_message(socket_.number(), setup.words());
  while (!wire_.is_open() || first_.id() < 0) {
    std::optional<Message> message = receive_message(socket_.number());
    if (message && message->words[0] == "first" && message->files.size() == 1) {
      first_ = Victim("host " + setup.names.at(static_cast<std::size_t>(setup.number) - 1),
                      std::move(message->files[0]));
    } else if (message && message->words[0] == "ready" && message->files.size() == 1) {
      wire_ = std::move(message->files[0]);
    } else {
      end();
      throw std::runtime_error(message && message->words.size() > 1 ? message->words[1]
                                                                    : "the keeper of a host has ended");
    }
  }
}

Connection::~Connection() {
  end();
}

Message Connection::ask(const std::vector<std::string>& words, const std::vector<int>& files) {
  const std::scoped_lock lock(mutex_);
  Message answer;
  const std::string failure = send_message(socket_.number(), words, files);
  if (failure.empty()) {
    if (std::optional<Message> received = receive_message(socket_.number())) return std::move(*received);
  }
  answer.words = {"failed", failure.empty() || !first_.is_alive() ? "the host is off" : failure};
  return answer;
}

void Connection::end() {
  if (keeper_ <= 0) return;
  const std::scoped_lock lock(mutex_);
  first_.signal(SIGKILL);
  socket_.close();
  ::waitpid(keeper_, nullptr, 0);  // it has asked how the first ended, so all on the host have ended, too
  keeper_ = -1;
}

}  // namespace mlab::network
