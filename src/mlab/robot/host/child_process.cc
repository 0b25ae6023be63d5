#include "mlab/robot/host/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "mlab/cell/cell.h"
#include "mlab/cell/sanitized.h"
#include "mlab/cell/tied_fork.h"

namespace mlab::robot_host {
namespace {

constexpr std::size_t kMostErrors = 4096;  // bytes of its standard error that are kept

void close_end(int& end) {
  if (end >= 0) ::close(end);
  end = -1;
}

constexpr std::size_t kMostFiles = 2;
constexpr int kFree = 64;  // descriptors from here on are moved to first, so that none takes another's number

// What a child gets, by the numbers that it has here.
struct Ends {
  int in;
  int out;
  int err;
  int report;
  std::array<int, kMostFiles> files;
  std::size_t file_count;
};

// In the child, between fork and exec: nothing here may allocate or lock.
void become(cell::Cell& room, const Ends& ends) {
  setpgid(0, 0);
  const int report = fcntl(ends.report, F_DUPFD_CLOEXEC, kFree);
  std::array<int, 3 + kMostFiles> from = {ends.in, ends.out, ends.err, ends.files[0], ends.files[1]};
  for (std::size_t i = 0; i < 3 + ends.file_count; ++i) from[i] = fcntl(from[i], F_DUPFD_CLOEXEC, kFree);
  for (std::size_t i = 0; i < 3 + ends.file_count; ++i) dup2(from[i], static_cast<int>(i));
  const int failure = room.become();
  if (::write(report, &failure, sizeof failure) < 0) _exit(126);
}

// Nothing of this process's own environment: it may hold what strangers' code has no business to know.
std::vector<std::string> environment_of_program() {
  std::vector<std::string> out = {"LC_ALL=C"};
  // Looking for leaks takes a process that traces, which there is none in a cell; and how a program ends is
  // what is to be told.
  if (cell::kIsSanitized)
    out.emplace_back("ASAN_OPTIONS=detect_leaks=0:handle_segv=0:handle_sigfpe=0:handle_abort=0");
  return out;
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

std::expected<ChildProcess, std::string> ChildProcess::start(const std::string& executable,
                                                             const cell::Policy& policy, cell::Wall wall,
                                                             std::span<const int> files) {
  ChildProcess out;
  out.wall_ = wall;
  const int descriptors = 3 + static_cast<int>(files.size());
  auto room = cell::Cell::prepare({executable, {}, environment_of_program(), descriptors}, policy, wall);
  if (!room) return std::unexpected(room.error());
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
  Ends ends{child_in, from[1], err[1], report[1], {}, files.size()};
  std::ranges::copy(files, ends.files.begin());
  const pid_t child = cell::tied_fork([&] { become(*room, ends); });
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
    : wall_(other.wall_),
      pid_(std::exchange(other.pid_, -1)),
      in_(std::exchange(other.in_, -1)),
      out_(std::exchange(other.out_, -1)),
      err_(std::exchange(other.err_, -1)),
      errors_(std::move(other.errors_)),
      was_killed_(other.was_killed_) {}

ChildProcess& ChildProcess::operator=(ChildProcess&& other) noexcept {
  std::swap(wall_, other.wall_);
  std::swap(pid_, other.pid_);
  std::swap(in_, other.in_);
  std::swap(out_, other.out_);
  std::swap(err_, other.err_);
  std::swap(errors_, other.errors_);
  std::swap(was_killed_, other.was_killed_);
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
  // As much as a pipe holds: whoever writes without end would keep us here.
  for (int i = 0; i < 64 && err_ >= 0; ++i) {
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
  const int how = cell::ending_of(status, wall_);
  was_killed_ = WIFSIGNALED(how) && WTERMSIG(how) == SIGKILL;
  return ending(how);
}

double ChildProcess::processor_time() const {
  clockid_t clock{};
  timespec time{};
  if (pid_ < 0 || clock_getcpuclockid(pid_, &clock) != 0 || clock_gettime(clock, &time) != 0) return 0.0;
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

bool ChildProcess::has_ended() {
  take_errors();
  siginfo_t seen{};
  return pid_ < 0 || (waitid(P_PID, static_cast<id_t>(pid_), &seen, WEXITED | WNOHANG | WNOWAIT) == 0 &&
                      seen.si_pid != 0);
}

std::string ChildProcess::last_words() {
  take_errors();
  std::string_view text = errors_;
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.remove_suffix(1);
  if (const std::size_t line = text.rfind('\n'); line != std::string_view::npos) text.remove_prefix(line + 1);
  return std::string(text);
}

}  // namespace mlab::robot_host
