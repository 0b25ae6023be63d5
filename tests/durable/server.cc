#include "server.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <regex>

namespace mlab::durable {
namespace {

constexpr double kStartPatience = 60.0;  // on a machine that does much else [s]

[[noreturn]] void become(const Server::Setup& setup, int output) {
  ::dup2(output, STDOUT_FILENO);
  ::dup2(output, STDERR_FILENO);
  if (setup.before && !setup.before()) ::_exit(97);
  if (::chdir(setup.folder.c_str()) != 0) ::_exit(98);
  for (const auto& [name, value] : setup.environment) {  // NOLINTBEGIN(concurrency-mt-unsafe): one thread
    if (value.empty())
      ::unsetenv(name.c_str());
    else
      ::setenv(name.c_str(), value.c_str(), 1);
  }  // NOLINTEND(concurrency-mt-unsafe)
  std::vector<std::string> words = {MLAB_COMMAND};
  words.insert(words.end(), setup.arguments.begin(), setup.arguments.end());
  words.emplace_back("--no-browser");
  if (setup.is_on_any_port) words.insert(words.end(), {"--port", "0"});
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  ::execv(pointers[0], pointers.data());
  ::_exit(99);
}

}  // namespace

Server::Server(const Setup& setup) {
  int ends[2] = {-1, -1};
  if (::pipe2(ends, O_CLOEXEC) != 0) return;
  process_ = ::fork();
  if (process_ == 0) become(setup, ends[1]);
  ::close(ends[1]);
  output_ = ends[0];
  static const std::regex kAddress(R"(http://127\.0\.0\.1:(\d+)/\S*\?token=(\w+)\s)");
  std::smatch found;
  while (!std::regex_search(printed_, found, kAddress)) {
    if (!read_more(kStartPatience)) return;
  }
  port_ = std::stoi(found[1]);
  token_ = found[2];
}

Server::~Server() {
  kill();
  if (output_ >= 0) ::close(output_);
}

bool Server::read_more(double seconds) {
  pollfd wanted{output_, POLLIN, 0};
  if (::poll(&wanted, 1, static_cast<int>(seconds * 1000.0)) <= 0) return false;
  char block[4096];
  const ssize_t n = ::read(output_, block, sizeof block);
  if (n <= 0) return false;
  printed_.append(block, static_cast<std::size_t>(n));
  return true;
}

bool Server::prints(const std::string& text) {
  while (printed_.find(text) == std::string::npos) {
    if (!read_more(kStartPatience / 2)) return false;
  }
  return true;
}

int Server::wait() {
  int status = 0;
  ::waitpid(process_, &status, 0);
  process_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

void Server::kill() {
  if (process_ <= 0) return;
  ::kill(process_, SIGKILL);
  wait();
}

int Server::end() {
  if (process_ <= 0) return -1;
  ::kill(process_, SIGINT);
  while (read_more(kStartPatience)) {
  }
  return wait();
}

}  // namespace mlab::durable
