#include "terminal.h"

#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>

namespace mlab {
namespace {

constexpr double kPatience = 30.0;  // [s]

}  // namespace

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Terminal::Terminal(const std::string& folder, const std::string& words) {
  winsize size{};
  size.ws_row = 40;
  size.ws_col = 160;
  const std::string line = "cd '" + folder + "' && " + words;
  process_ = ::forkpty(&screen_, nullptr, nullptr, &size);
  if (process_ == 0) {
    ::execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
    ::_exit(127);
  }
}

Terminal::~Terminal() {
  if (process_ > 0) {
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
  }
  if (screen_ >= 0) ::close(screen_);
}

bool Terminal::read_some(double seconds) {
  pollfd wanted{screen_, POLLIN, 0};
  if (has_ended_ || ::poll(&wanted, 1, static_cast<int>(seconds * 1000.0) + 1) <= 0) return false;
  char block[4096];
  const ssize_t n = ::read(screen_, block, sizeof block);
  if (n <= 0) {  // the kernel's word for the end of the other side is an error
    has_ended_ = true;
    return false;
  }
  output_.append(block, static_cast<std::size_t>(n));
  return true;
}

std::string Terminal::last_line() const {
  std::string line = output_.substr(output_.rfind('\n') + 1);
  if (const std::size_t wiped = line.rfind("\r\x1b[K"); wiped != std::string::npos) line.erase(0, wiped + 4);
  return line;
}

bool Terminal::await(const std::string& text) {
  const double until = now() + kPatience;
  while (output_.find(text) == std::string::npos) {
    if (has_ended_ || now() > until) return false;
    read_some(0.1);
  }
  return true;
}

void Terminal::watch(double seconds) {
  const double until = now() + seconds;
  while (!has_ended_ && now() < until) read_some(until - now());
}

void Terminal::type(const std::string& text) const {
  [[maybe_unused]] const ssize_t written = ::write(screen_, text.data(), text.size());
}

int Terminal::finish() {
  const double until = now() + kPatience;
  while (!has_ended_ && now() < until) read_some(0.1);
  if (!has_ended_) return -1;
  int status = 0;
  ::waitpid(process_, &status, 0);
  process_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace mlab
