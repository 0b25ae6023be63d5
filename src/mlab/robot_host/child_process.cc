#include "mlab/robot_host/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <system_error>
#include <utility>

#include <fmt/core.h>

namespace mlab::robot_host {
namespace {

constexpr std::size_t kMostErrors = 4096;  // bytes of its standard error that are kept

void close_end(int& end) {
  if (end >= 0) ::close(end);
  end = -1;
}

// In the child, between fork and exec: nothing here may allocate or lock.
[[noreturn]] void become(const char* program, char* const* words, int in, int out, int err, int report) {
  setpgid(0, 0);
  const rlimit cores{0, 0};
  setrlimit(RLIMIT_CORE, &cores);
  // The run may ignore or block signals; a robot program starts with what every program starts with.
  sigset_t none;
  sigemptyset(&none);
  pthread_sigmask(SIG_SETMASK, &none, nullptr);
  std::signal(SIGPIPE, SIG_DFL);
  dup2(in, 0);
  dup2(out, 1);
  dup2(err, 2);
  execve(program, words, environ);
  const int failure = errno;
  if (::write(report, &failure, sizeof failure) < 0) _exit(126);
  _exit(127);
}

int milliseconds_until(Clock::time_point deadline) {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
  return static_cast<int>(std::clamp<std::int64_t>(left, 0, 1'000'000));
}

std::string reason(int error) {
  return std::generic_category().message(error);
}

std::string ending(int status) {
  if (!WIFSIGNALED(status)) return fmt::format("exit status {}", WEXITSTATUS(status));
  const char* name = sigdescr_np(WTERMSIG(status));
  return fmt::format("signal {} ({})", WTERMSIG(status), name == nullptr ? "?" : name);
}

}  // namespace

std::expected<ChildProcess, std::string> ChildProcess::start(const std::string& executable) {
  ChildProcess out;
  // A socket for its input, because writing to one whose reader is gone is an error and not a signal.
  int in[2];
  int from[2];
  int err[2];
  int report[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, in) != 0) return std::unexpected(reason(errno));
  out.in_ = in[0];
  int child_in = in[1];
  const auto fail = [&](int error, std::initializer_list<int> ends) {
    for (int end : ends) close_end(end);
    return std::unexpected(reason(error));
  };
  if (pipe2(from, O_CLOEXEC) != 0) return fail(errno, {child_in});
  out.out_ = from[0];
  if (pipe2(err, O_CLOEXEC) != 0) return fail(errno, {child_in, from[1]});
  out.err_ = err[0];
  if (pipe2(report, O_CLOEXEC) != 0) return fail(errno, {child_in, from[1], err[1]});
  std::string name = executable;
  char* const words[] = {name.data(), nullptr};
  const pid_t child = fork();
  if (child == 0) become(executable.c_str(), words, child_in, from[1], err[1], report[1]);
  const int fork_error = errno;
  for (int end : {child_in, from[1], err[1], report[1]}) close_end(end);
  if (child < 0) return fail(fork_error, {report[0]});
  setpgid(child, child);  // in both processes: whoever comes first
  out.pid_ = child;
  int exec_error = 0;
  ssize_t count = 0;
  do {
    count = ::read(report[0], &exec_error, sizeof exec_error);
  } while (count < 0 && errno == EINTR);
  if (count == sizeof exec_error) return fail(exec_error, {report[0]});
  close_end(report[0]);
  for (const int end : {out.in_, out.out_, out.err_}) fcntl(end, F_SETFL, O_NONBLOCK);
  return out;
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : pid_(std::exchange(other.pid_, -1)),
      in_(std::exchange(other.in_, -1)),
      out_(std::exchange(other.out_, -1)),
      err_(std::exchange(other.err_, -1)),
      errors_(std::move(other.errors_)) {}

ChildProcess& ChildProcess::operator=(ChildProcess&& other) noexcept {
  std::swap(pid_, other.pid_);
  std::swap(in_, other.in_);
  std::swap(out_, other.out_);
  std::swap(err_, other.err_);
  std::swap(errors_, other.errors_);
  return *this;
}

ChildProcess::~ChildProcess() {
  constexpr double kPatience = 0.2;  // [s]
  if (pid_ >= 0) end(kPatience);
  close_all();
}

void ChildProcess::close_all() {
  close_end(in_);
  close_end(out_);
  close_end(err_);
}

ChildProcess::Io ChildProcess::write(std::string_view bytes, Clock::time_point deadline) {
  while (!bytes.empty()) {
    const ssize_t count = send(in_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count > 0) {
      bytes.remove_prefix(static_cast<std::size_t>(count));
      continue;
    }
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && errno != EAGAIN && errno != EWOULDBLOCK) return Io::kEnded;
    take_errors();
    // It may be that it fills its standard error and waits for us.
    pollfd waiting[] = {{in_, POLLOUT, 0}, {err_, POLLIN, 0}};
    if (::poll(waiting, err_ >= 0 ? 2 : 1, milliseconds_until(deadline)) == 0) return Io::kTimedOut;
  }
  return Io::kDone;
}

ChildProcess::Io ChildProcess::read(std::span<char> room, std::size_t& count, Clock::time_point deadline) {
  for (;;) {
    const ssize_t got = ::read(out_, room.data(), room.size());
    if (got > 0) {
      count = static_cast<std::size_t>(got);
      return Io::kDone;
    }
    if (got == 0) return Io::kEnded;
    if (errno == EINTR) continue;
    if (errno != EAGAIN && errno != EWOULDBLOCK) return Io::kEnded;
    pollfd waiting[] = {{out_, POLLIN, 0}, {err_, POLLIN, 0}};
    if (::poll(waiting, err_ >= 0 ? 2 : 1, milliseconds_until(deadline)) == 0) return Io::kTimedOut;
    if (err_ >= 0 && waiting[1].revents != 0) take_errors();
    if (Clock::now() >= deadline) return Io::kTimedOut;
  }
}

void ChildProcess::take_errors() {
  char block[1024];
  while (err_ >= 0) {
    const ssize_t count = ::read(err_, block, sizeof block);
    if (count < 0 && errno == EINTR) continue;
    if (count == 0) close_end(err_);
    if (count <= 0) break;
    errors_.append(block, static_cast<std::size_t>(count));
    if (errors_.size() > 2 * kMostErrors) errors_.erase(0, errors_.size() - kMostErrors);
  }
}

std::string ChildProcess::end(double patience) {
  if (pid_ < 0) return "it has ended";
  close_end(in_);
  const auto deadline =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(patience));
  // Seen, but not taken away yet: as long as it is there, nobody else can have its number.
  siginfo_t seen{};
  while (waitid(P_PID, static_cast<id_t>(pid_), &seen, WEXITED | WNOHANG | WNOWAIT) == 0 &&
         seen.si_pid == 0 && Clock::now() < deadline) {
    take_errors();
    ::poll(nullptr, 0, 1);
  }
  kill(-pid_, SIGKILL);  // what it started, too
  int status = 0;
  while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  take_errors();
  return ending(status);
}

std::string ChildProcess::last_words() {
  take_errors();
  std::string_view text = errors_;
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.remove_suffix(1);
  if (const std::size_t line = text.rfind('\n'); line != std::string_view::npos) text.remove_prefix(line + 1);
  return std::string(text);
}

}  // namespace mlab::robot_host
