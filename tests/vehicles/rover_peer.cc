#include "rover_peer.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>

#include "mlab/base/testing/source_folder.h"

namespace mlab::vehicles {
namespace {

constexpr int kPatienceMs = 20000;

sockaddr_in loopback(std::uint16_t port) {
  sockaddr_in out{};
  out.sin_family = AF_INET;
  out.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  out.sin_port = htons(port);
  return out;
}

int bound_socket(std::uint16_t& port) {
  const int out = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  sockaddr_in at = loopback(0);
  socklen_t length = sizeof at;
  if (out < 0 || ::bind(out, reinterpret_cast<sockaddr*>(&at), length) != 0 ||
      ::getsockname(out, reinterpret_cast<sockaddr*>(&at), &length) != 0)
    throw std::runtime_error("no socket");
  port = ntohs(at.sin_port);
  return out;
}

}  // namespace

std::uint16_t free_port() {
  std::uint16_t out = 0;
  ::close(bound_socket(out));
  return out;
}

RoverPeer::RoverPeer(std::uint16_t port, const std::vector<std::string>& settings) {
  const std::string script =
      (std::filesystem::path(base::source_folder()) / "tests/vehicles/rover.mjs").string();
  std::vector<std::string> words{"node", script, MLAB_VEHICLES_FOLDER, std::to_string(port),
                                 std::to_string(kSpeed)};
  words.insert(words.end(), settings.begin(), settings.end());
  std::vector<char*> arguments;
  for (std::string& one : words) arguments.push_back(one.data());
  arguments.push_back(nullptr);
  int in[2];
  int out[2];
  if (::pipe2(in, O_CLOEXEC) != 0 || ::pipe2(out, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, in[0], 0);
  ::posix_spawn_file_actions_adddup2(&actions, out[1], 1);
  if (::posix_spawnp(&id_, "node", &actions, nullptr, arguments.data(), environ) != 0) id_ = -1;
  ::posix_spawn_file_actions_destroy(&actions);
  ::close(in[0]);
  ::close(out[1]);
  input_ = in[1];
  output_ = out[0];
  if (id_ < 0 || read_line() != "ready") throw std::runtime_error("the rover does not begin");
}

RoverPeer::~RoverPeer() {
  kill();
  ::close(input_);
  ::close(output_);
}

void RoverPeer::kill() {
  if (id_ <= 0) return;
  ::kill(id_, SIGKILL);
  ::waitpid(id_, nullptr, 0);
  id_ = -1;
}

std::string RoverPeer::read_line() {
  for (;;) {
    if (const auto end = pending_.find('\n'); end != std::string::npos) {
      std::string out = pending_.substr(0, end);
      pending_.erase(0, end + 1);
      return out;
    }
    pollfd one{output_, POLLIN, 0};
    char buffer[1024];
    if (::poll(&one, 1, kPatienceMs) <= 0) throw std::runtime_error("the rover says nothing");
    const ssize_t size = ::read(output_, buffer, sizeof buffer);
    if (size <= 0) throw std::runtime_error("the rover has ended");
    pending_.append(buffer, static_cast<std::size_t>(size));
  }
}

nlohmann::json RoverPeer::ask(const std::string& line) {
  const std::string text = line + "\n";
  if (::write(input_, text.data(), text.size()) != static_cast<ssize_t>(text.size()))
    throw std::runtime_error("the rover does not listen");
  return nlohmann::json::parse(read_line());
}

Relay::Relay(std::uint16_t device_port, std::uint64_t seed) : device_port_(device_port), random_(seed) {
  std::uint16_t own = 0;
  rover_side_ = bound_socket(port_);
  device_side_ = bound_socket(own);
}

Relay::~Relay() {
  ::close(rover_side_);
  ::close(device_side_);
}

void Relay::receive(int from, bool to_device) {
  char buffer[4096];
  for (;;) {
    sockaddr_in at{};
    socklen_t length = sizeof at;
    const ssize_t size =
        ::recvfrom(from, buffer, sizeof buffer, 0, reinterpret_cast<sockaddr*>(&at), &length);
    if (size <= 0) return;
    if (to_device) rover_port_ = ntohs(at.sin_port);
    if (is_cut || random_.uniform() < loss) continue;
    waiting_.push_back({Clock::now() + delay, to_device, {buffer, static_cast<std::size_t>(size)}});
  }
}

void Relay::work() {
  receive(rover_side_, true);
  receive(device_side_, false);
  const auto now = Clock::now();
  std::erase_if(waiting_, [&](const Datagram& one) {
    if (one.at > now) return false;
    const sockaddr_in to = loopback(one.to_device ? device_port_ : rover_port_);
    ::sendto(one.to_device ? device_side_ : rover_side_, one.bytes.data(), one.bytes.size(), 0,
             reinterpret_cast<const sockaddr*>(&to), sizeof to);
    return true;
  });
}

}  // namespace mlab::vehicles
