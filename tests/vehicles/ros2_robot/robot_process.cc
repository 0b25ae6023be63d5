#include "robot_process.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <stdexcept>

namespace mlab::ros2_robot {
namespace {

bool is_free(int port) {
  const int one = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  sockaddr_in at{};
  at.sin_family = AF_INET;
  at.sin_addr.s_addr = htonl(INADDR_ANY);
  at.sin_port = htons(static_cast<std::uint16_t>(port));
  const bool out = ::bind(one, reinterpret_cast<const sockaddr*>(&at), sizeof at) == 0;
  ::close(one);
  return out;
}

}  // namespace

RobotProcess::RobotProcess(const std::vector<std::string>& more) {
  std::vector<std::string> words{MLAB_ROS2_ROBOT};
  words.insert(words.end(), more.begin(), more.end());
  std::vector<char*> arguments;
  for (std::string& one : words) arguments.push_back(one.data());
  arguments.push_back(nullptr);
  int out[2];
  if (::pipe2(out, O_CLOEXEC | O_NONBLOCK) != 0) throw std::runtime_error("no pipe");
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, out[1], STDOUT_FILENO);
  if (::posix_spawn(&id_, arguments[0], &actions, nullptr, arguments.data(), environ) != 0) id_ = -1;
  ::posix_spawn_file_actions_destroy(&actions);
  ::close(out[1]);
  output_ = out[0];
  if (id_ < 0) throw std::runtime_error("the robot does not begin");
}

RobotProcess::~RobotProcess() {
  end(SIGKILL);
  ::close(output_);
}

int RobotProcess::end(int signal) {
  if (id_ <= 0) return -1;
  if (signal != 0) ::kill(id_, signal);
  int status = 0;
  ::waitpid(id_, &status, 0);
  id_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

const std::string& RobotProcess::said() {
  char buffer[4096];
  for (ssize_t size = 0; (size = ::read(output_, buffer, sizeof buffer)) > 0;)
    said_.append(buffer, static_cast<std::size_t>(size));
  return said_;
}

std::optional<double> RobotProcess::last(const std::string& text) {
  const auto at = said().rfind(text);
  if (at == std::string::npos || said_.find('\n', at) == std::string::npos) return std::nullopt;
  return std::strtod(said_.c_str() + at + text.size(), nullptr);
}

int free_domain() {
  constexpr int kDomains = 100;  // their ports are below those that systems give away
  for (int i = 0; i < kDomains; ++i) {
    const int domain = 1 + (::getpid() + i) % kDomains;
    const int first = 7400 + 250 * domain;
    if (is_free(first + 10) && is_free(first + 11)) return domain;
  }
  throw std::runtime_error("no domain is free");
}

}  // namespace mlab::ros2_robot
