#include "mlab/cell/cell.h"

#include <fcntl.h>
#include <linux/capability.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <utility>

#include <fmt/core.h>

#include "mlab/cell/bubblewrap.h"
#include "mlab/cell/landlock.h"

namespace mlab::cell {
namespace {

std::vector<char*> pointers_to(std::vector<std::string>& words) {
  std::vector<char*> out;
  for (std::string& word : words) out.push_back(word.data());
  out.push_back(nullptr);
  return out;
}

void limit(int what, std::uint64_t value) noexcept {
  const rlimit both{value, value};
  setrlimit(static_cast<__rlimit_resource_t>(what), &both);
}

// What is open beyond is closed by exec: until then a report of what failed still gets through.
void close_at_exec(int first) noexcept {
  constexpr unsigned kCloseAtExec = 4;
  if (syscall(SYS_close_range, static_cast<unsigned>(first), ~0U, kCloseAtExec) == 0) return;
  rlimit most{};
  getrlimit(RLIMIT_NOFILE, &most);
  const int end = static_cast<int>(std::min<rlim_t>(most.rlim_cur, 1 << 20));
  for (int i = first; i < end; ++i) fcntl(i, F_SETFD, FD_CLOEXEC);
}

// Root without root's powers. One stays, so that `sudo mlab` reads what it could read before, inside of its
// walls. @return 0, or errno
int drop_powers() noexcept {
  for (int i = 0; prctl(PR_CAPBSET_READ, i, 0, 0, 0) >= 0; ++i) {
    if (i != CAP_DAC_READ_SEARCH) prctl(PR_CAPBSET_DROP, i, 0, 0, 0);  // refused to those who have none
  }
  prctl(PR_CAP_AMBIENT, PR_CAP_AMBIENT_CLEAR_ALL, 0, 0, 0);
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  __user_cap_data_struct powers[_LINUX_CAPABILITY_U32S_3] = {};
  if (syscall(SYS_capget, &header, powers) != 0) return errno;
  for (__user_cap_data_struct& word : powers) word.effective = word.inheritable = 0;
  powers[0].permitted &= 1U << CAP_DAC_READ_SEARCH;
  powers[0].effective = powers[0].permitted;
  powers[1].permitted = 0;
  return syscall(SYS_capset, &header, powers) == 0 ? 0 : errno;
}

// Descriptors that are to be there until exec lie above those that the child is given as its own.
constexpr int kFirstKept = 64;

int keep_above(int file) {
  const int kept = file < 0 ? -1 : fcntl(file, F_DUPFD_CLOEXEC, kFirstKept);
  if (file >= 0) close(file);
  return kept;
}

// The filter as a file that bubblewrap reads; -1: no memory.
int file_of(const std::vector<sock_filter>& instructions) {
  const int file = keep_above(memfd_create("filter", MFD_CLOEXEC));
  const auto size = static_cast<ssize_t>(instructions.size() * sizeof(sock_filter));
  if (file >= 0 && write(file, instructions.data(), static_cast<std::size_t>(size)) == size &&
      lseek(file, 0, SEEK_SET) == 0)
    return file;
  if (file >= 0) close(file);
  return -1;
}

}  // namespace

std::expected<Cell, std::string> Cell::prepare(const Program& program, const Policy& policy, Wall wall) {
  Cell out;
  out.wall_ = wall;
  out.policy_ = policy;
  out.descriptors_ = std::max(program.descriptors, 3);
  if (wall != Wall::kNone) {
    auto filter = CallFilter::make(policy, wall);
    if (!filter) return std::unexpected(fmt::format("no cell can be made: {}", filter.error()));
    out.filter_ = std::move(*filter);
  }
  if (wall == Wall::kLandlock) {
    const auto rules = landlock_rules(policy, landlock_version());
    if (!rules) return std::unexpected(fmt::format("no cell can be made: {}", rules.error()));
    out.rules_ = keep_above(*rules);
    if (out.rules_ < 0) return std::unexpected("no cell can be made: too many files are open");
  }
  if (wall == Wall::kBubblewrap) {
    const std::string bwrap = means().bubblewrap.empty() ? find_bubblewrap() : means().bubblewrap;
    out.filter_file_ = file_of(out.filter_.instructions());
    if (bwrap.empty() || out.filter_file_ < 0)
      return std::unexpected("no cell can be made: there is no bubblewrap that works");
    out.words_ = bubblewrap_words(bwrap, policy, out.filter_file_);
  }
  if (policy.may_start_processes) {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
      return std::unexpected("no cell can be made: too many files are open");
    out.lifeline_ = keep_above(ends[0]);
    out.held_end_ = keep_above(ends[1]);
  }
  out.words_.push_back(program.path);
  out.words_.insert(out.words_.end(), program.arguments.begin(), program.arguments.end());
  out.environment_ = program.environment;
  out.word_pointers_ = pointers_to(out.words_);
  out.environment_pointers_ = pointers_to(out.environment_);
  return out;
}

Cell::Cell(Cell&& other) noexcept {
  *this = std::move(other);
}

// The pointers go on pointing at the words, which stay where they are.
Cell& Cell::operator=(Cell&& other) noexcept {
  std::swap(wall_, other.wall_);
  std::swap(policy_, other.policy_);
  std::swap(descriptors_, other.descriptors_);
  std::swap(rules_, other.rules_);
  std::swap(filter_file_, other.filter_file_);
  std::swap(lifeline_, other.lifeline_);
  std::swap(held_end_, other.held_end_);
  std::swap(filter_, other.filter_);
  words_.swap(other.words_);
  environment_.swap(other.environment_);
  word_pointers_.swap(other.word_pointers_);
  environment_pointers_.swap(other.environment_pointers_);
  return *this;
}

Cell::~Cell() {
  for (const int file : {rules_, filter_file_, lifeline_, held_end_}) {
    if (file >= 0) close(file);
  }
}

void Cell::set_limits() const noexcept {
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, policy_.file_size);
  limit(RLIMIT_NOFILE, policy_.open_files);
  limit(RLIMIT_MEMLOCK, 0);
  limit(RLIMIT_MSGQUEUE, 0);
  if (policy_.memory > 0) limit(RLIMIT_AS, policy_.memory);
  if (policy_.processor_time) {
    // One second from the signal that can be caught to the one that can't.
    const rlimit processor{*policy_.processor_time, *policy_.processor_time + 1};
    setrlimit(RLIMIT_CPU, &processor);
  }
}

int Cell::enter() noexcept {
  if (const int failure = drop_powers(); failure != 0) return failure;
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return errno;
  if (const int failure = enter_landlock(rules_); failure != 0) return failure;
  return filter_.enter();
}

// The other end is ours alone: when it closes, the kernel kills the group of whoever holds this one.
int Cell::hold_lifeline() const noexcept {
  if (held_end_ < 0 || getpgrp() != getpid()) return 0;
  return fcntl(held_end_, F_SETOWN, -getpgrp()) == 0 && fcntl(held_end_, F_SETSIG, SIGKILL) == 0 &&
                 fcntl(held_end_, F_SETFL, O_ASYNC) == 0 && fcntl(held_end_, F_SETFD, 0) == 0
             ? 0
             : errno;
}

int Cell::become() noexcept {
  // The parent may ignore or block signals; a program starts with what every program starts with.
  for (int signal = 1; signal < NSIG; ++signal) std::signal(signal, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  pthread_sigmask(SIG_SETMASK, &none, nullptr);
  close_at_exec(descriptors_);
  if (wall_ == Wall::kBubblewrap && fcntl(filter_file_, F_SETFD, 0) != 0) return errno;
  if (const int failure = hold_lifeline(); failure != 0) return failure;
  set_limits();
  if (wall_ == Wall::kLandlock) {
    if (const int failure = enter(); failure != 0) return failure;
  }
  execve(word_pointers_[0], word_pointers_.data(), environment_pointers_.data());
  return errno;
}

int ending_of(int wait_status, Wall wall) {
  constexpr int kSignals = 128;  // as shells say it
  if (wall != Wall::kBubblewrap || !WIFEXITED(wait_status)) return wait_status;
  const int status = WEXITSTATUS(wait_status);
  return status > kSignals && status < kSignals + NSIG ? status - kSignals : wait_status;
}

}  // namespace mlab::cell
