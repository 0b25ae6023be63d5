#include "mlab/lang/cnl/compiler_process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <system_error>

#include "mlab/cell/cell.h"
#include "mlab/cell/tied_fork.h"

namespace mlab::cnl {
namespace {

using Clock = std::chrono::steady_clock;

// Nothing of what this process knows: no search paths for headers, no caches, no secrets.
std::vector<std::string> plain_environment(const std::string& own) {
  const char* path = std::getenv("PATH");  // NOLINT(concurrency-mt-unsafe): nobody sets it here
  return {"LC_ALL=C", std::string("PATH=") + (path ? path : "/usr/bin:/bin"), "TMPDIR=" + own,
          // Where PATH has ccache's names of compilers, it hands on to the compilers themselves.
          "CCACHE_DISABLE=1"};
}

// In the child, between fork and exec: nothing here may allocate or lock.
void become(cell::Cell& cell, int out, int report) {
  setpgid(0, 0);
  const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
  if (nothing >= 0) dup2(nothing, 0);
  dup2(out, 1);
  dup2(out, 2);
  const int failure = cell.become();
  if (write(report, &failure, sizeof failure) < 0) _exit(126);
}

struct Pipe {
  int read_end = -1;
  int write_end = -1;

  bool open() {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) return false;
    read_end = ends[0];
    write_end = ends[1];
    return true;
  }
  static void close_end(int& end) {
    if (end >= 0) ::close(end);
    end = -1;
  }
  ~Pipe() {
    close_end(read_end);
    close_end(write_end);
  }
};

enum class Reading { kDone, kTimedOut, kStopped };

// Reads until the writers are gone.
Reading read_all(int from, Clock::time_point deadline, const std::stop_token& ends, std::size_t most,
                 std::string& output) {
  constexpr std::chrono::milliseconds::rep kLook = 50;  // [ms] until an end is noticed
  char block[1 << 14];
  for (;;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) return Reading::kTimedOut;
    if (ends.stop_requested()) return Reading::kStopped;
    pollfd waiting{from, POLLIN, 0};
    const auto pause = ends.stop_possible() ? std::min(left, kLook) : left;
    const int ready = poll(&waiting, 1, static_cast<int>(std::min<long>(pause, 1'000'000)));
    if (ready == 0 || (ready < 0 && errno == EINTR)) continue;
    if (ready < 0) return Reading::kTimedOut;
    const ssize_t count = read(from, block, sizeof block);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return Reading::kDone;
    const std::size_t room = most > output.size() ? most - output.size() : 0;
    output.append(block, std::min(room, static_cast<std::size_t>(count)));
  }
}

// Asks the group to end; whoever has not done so a second later is killed.
void end_group(pid_t group, int its_output) {
  constexpr std::chrono::seconds kPatience(1);
  kill(-group, SIGTERM);
  std::string unwanted;
  read_all(its_output, Clock::now() + kPatience, {}, 0, unwanted);
  kill(-group, SIGKILL);
}

ProcessResult failed(int error) {
  return {error == ENOENT ? ProcessResult::End::kNotFound : ProcessResult::End::kFailed, error,
          std::generic_category().message(error)};
}

}  // namespace

std::string find_program(const std::string& name) {
  if (name.find('/') != std::string::npos) return access(name.c_str(), X_OK) == 0 ? name : "";
  const char* path = std::getenv("PATH");  // NOLINT(concurrency-mt-unsafe): nobody sets it here
  std::string_view rest = path ? path : "/usr/bin:/bin";
  while (!rest.empty()) {
    const std::size_t colon = std::min(rest.find(':'), rest.size());
    const std::string candidate = std::string(rest.substr(0, colon)) + "/" + name;
    if (colon > 0 && access(candidate.c_str(), X_OK) == 0) return candidate;
    rest.remove_prefix(std::min(colon + 1, rest.size()));
  }
  return "";
}

ProcessResult run_process(const std::vector<std::string>& words, const CompilerRoom& room,
                          const ProcessLimits& limits) {
  const std::string program = find_program(words.at(0));
  if (program.empty()) return failed(ENOENT);
  cell::Policy policy = compiler_policy(program, room.files, room.own);
  policy.memory = limits.memory;
  policy.processor_time = limits.processor_time;
  auto cell = cell::Cell::prepare({program, {words.begin() + 1, words.end()}, plain_environment(room.own)},
                                  policy, room.wall);
  if (!cell) return {ProcessResult::End::kFailed, 0, cell.error()};
  Pipe output;
  Pipe report;  // tells why exec failed; closed by exec itself
  if (!output.open() || !report.open()) return failed(errno);
  const pid_t child = cell::tied_fork([&] { become(*cell, output.write_end, report.write_end); });
  if (child < 0) return failed(errno);
  setpgid(child, child);  // in both processes: whoever comes first
  Pipe::close_end(output.write_end);
  Pipe::close_end(report.write_end);
  int exec_error = 0;
  const bool did_not_start = read(report.read_end, &exec_error, sizeof exec_error) == sizeof exec_error;
  ProcessResult result;
  const auto deadline =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(limits.time));
  const Reading reading = read_all(output.read_end, deadline, limits.ends, limits.output, result.output);
  if (reading != Reading::kDone) end_group(child, output.read_end);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (did_not_start) return failed(exec_error);
  status = cell::ending_of(status, room.wall);
  result.end = reading == Reading::kTimedOut  ? ProcessResult::End::kTimedOut
               : reading == Reading::kStopped ? ProcessResult::End::kStopped
               : WIFSIGNALED(status)          ? ProcessResult::End::kSignalled
                                              : ProcessResult::End::kExited;
  result.status = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
  return result;
}

}  // namespace mlab::cnl
