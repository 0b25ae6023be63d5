#include "mlab/cell/system_calls.h"

#include <fcntl.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <initializer_list>
#include <memory>
#include <system_error>
#include <type_traits>
#include <utility>

#include <fmt/core.h>

namespace mlab::cell {
namespace {

// Stands for the number of the process, which nobody knows before it is there. No process has it.
constexpr std::uint32_t kOwnNumber = 0x7ffe1d5e;

// For every program. Files are kept by the other wall; what is here opens, reads, and looks at what is open.
constexpr int kCalls[] = {
    // its memory
    SCMP_SYS(brk), SCMP_SYS(mmap), SCMP_SYS(munmap), SCMP_SYS(mremap), SCMP_SYS(mprotect), SCMP_SYS(madvise),
    // descriptors that it has
    SCMP_SYS(read), SCMP_SYS(readv), SCMP_SYS(pread64), SCMP_SYS(write), SCMP_SYS(writev), SCMP_SYS(pwrite64),
    SCMP_SYS(close), SCMP_SYS(close_range), SCMP_SYS(lseek), SCMP_SYS(dup), SCMP_SYS(dup2), SCMP_SYS(dup3),
    SCMP_SYS(poll), SCMP_SYS(ppoll), SCMP_SYS(select), SCMP_SYS(pselect6), SCMP_SYS(fstat),
    SCMP_SYS(newfstatat), SCMP_SYS(fadvise64),
    // its libraries
    SCMP_SYS(access), SCMP_SYS(faccessat), SCMP_SYS(faccessat2), SCMP_SYS(getcwd), SCMP_SYS(execve),
    // itself
    SCMP_SYS(exit), SCMP_SYS(exit_group), SCMP_SYS(arch_prctl), SCMP_SYS(set_tid_address),
    SCMP_SYS(set_robust_list), SCMP_SYS(rseq), SCMP_SYS(futex), SCMP_SYS(futex_waitv), SCMP_SYS(membarrier),
    SCMP_SYS(rt_sigaction), SCMP_SYS(rt_sigprocmask), SCMP_SYS(rt_sigreturn), SCMP_SYS(sigaltstack),
    SCMP_SYS(restart_syscall), SCMP_SYS(getpid), SCMP_SYS(getppid), SCMP_SYS(gettid), SCMP_SYS(getuid),
    SCMP_SYS(geteuid), SCMP_SYS(getgid), SCMP_SYS(getegid), SCMP_SYS(getrlimit), SCMP_SYS(getrusage),
    SCMP_SYS(times), SCMP_SYS(sched_yield), SCMP_SYS(sched_getaffinity), SCMP_SYS(getcpu),
    // what everybody may know
    SCMP_SYS(uname), SCMP_SYS(sysinfo), SCMP_SYS(getrandom), SCMP_SYS(clock_gettime), SCMP_SYS(clock_getres),
    SCMP_SYS(gettimeofday), SCMP_SYS(time), SCMP_SYS(nanosleep), SCMP_SYS(clock_nanosleep)};

// For what starts processes and writes files, in folders that the other wall gives it: compilers. Modes,
// owners and times are not here, because that wall knows nothing of them.
constexpr int kCompilerCalls[] = {
    // its parts
    SCMP_SYS(fork), SCMP_SYS(vfork), SCMP_SYS(wait4), SCMP_SYS(waitid), SCMP_SYS(pipe), SCMP_SYS(pipe2),
    SCMP_SYS(getpgrp), SCMP_SYS(getgroups),
    // looking for files
    SCMP_SYS(stat), SCMP_SYS(lstat), SCMP_SYS(statx), SCMP_SYS(statfs), SCMP_SYS(fstatfs), SCMP_SYS(readlink),
    SCMP_SYS(readlinkat), SCMP_SYS(getdents64), SCMP_SYS(chdir),
    // writing them
    SCMP_SYS(umask), SCMP_SYS(creat), SCMP_SYS(ftruncate), SCMP_SYS(fallocate), SCMP_SYS(fsync),
    SCMP_SYS(copy_file_range), SCMP_SYS(rename), SCMP_SYS(renameat), SCMP_SYS(renameat2), SCMP_SYS(unlink),
    SCMP_SYS(unlinkat), SCMP_SYS(mkdir), SCMP_SYS(mkdirat), SCMP_SYS(rmdir)};

// What glibc tries first and knows how to do without: told that the kernel has no such call, it does.
constexpr int kUnknownCalls[] = {SCMP_SYS(clone3), SCMP_SYS(openat2)};

constexpr std::uint64_t kOwnNamespaces =
    CLONE_NEWNS | CLONE_NEWCGROUP | CLONE_NEWUTS | CLONE_NEWIPC | CLONE_NEWUSER | CLONE_NEWPID | CLONE_NEWNET;

/// A filter that is being written.
class FilterWriter {
 public:
  FilterWriter() : filter_(seccomp_init(SCMP_ACT_ERRNO(EPERM)), seccomp_release) {
    if (!filter_) failure_ = ENOMEM;
  }

  void set(scmp_filter_attr attribute, std::uint32_t value) {
    if (failure_ == 0) note(seccomp_attr_set(filter_.get(), attribute, value));
  }
  void allow(int call, std::initializer_list<scmp_arg_cmp> when = {}) { add(SCMP_ACT_ALLOW, call, when); }
  void refuse(int call, int why) { add(SCMP_ACT_ERRNO(static_cast<std::uint32_t>(why)), call, {}); }

  /// @errors  errno
  std::expected<std::vector<sock_filter>, int> write() {
    const int file = failure_ == 0 ? memfd_create("filter", MFD_CLOEXEC) : -1;
    if (failure_ == 0 && file < 0) failure_ = errno;
    if (failure_ == 0) note(seccomp_export_bpf(filter_.get(), file));
    const off_t size = failure_ == 0 && file >= 0 ? lseek(file, 0, SEEK_END) : 0;
    std::vector<sock_filter> out(static_cast<std::size_t>(size) / sizeof(sock_filter));
    if (failure_ == 0 && pread(file, out.data(), static_cast<std::size_t>(size), 0) != size) failure_ = EIO;
    if (file >= 0) close(file);
    if (failure_ != 0) return std::unexpected(failure_);
    return out;
  }

 private:
  void add(std::uint32_t action, int call, std::initializer_list<scmp_arg_cmp> when) {
    // A call with a negative number is none of this machine's.
    if (failure_ == 0 && call >= 0)
      note(seccomp_rule_add_array(filter_.get(), action, call, static_cast<unsigned>(when.size()),
                                  when.begin()));
  }
  void note(int result) {
    if (failure_ == 0 && result < 0) failure_ = -result;
  }

  std::unique_ptr<std::remove_pointer_t<scmp_filter_ctx>, decltype(&seccomp_release)> filter_;
  int failure_ = 0;
};

scmp_arg_cmp is(unsigned argument, std::uint64_t value) {
  return {argument, SCMP_CMP_EQ, value, 0};
}
scmp_arg_cmp has(unsigned argument, std::uint64_t mask, std::uint64_t value) {
  return {argument, SCMP_CMP_MASKED_EQ, mask, value};
}

// Landlock knows of emptying a file from its third version on; before, it lets who may read one open it to be
// emptied. Who may write it asks for that, too. (Emptying by a path is among nobody's calls.)
void allow_opening(FilterWriter& filter) {
  for (const auto& [call, flags] : {std::pair(SCMP_SYS(open), 1U), std::pair(SCMP_SYS(openat), 2U)}) {
    filter.allow(call, {has(flags, O_TRUNC, 0)});
    for (const std::uint64_t access : {O_WRONLY, O_RDWR})
      filter.allow(call, {has(flags, O_TRUNC | O_ACCMODE, O_TRUNC | access)});
  }
}

// Calls that may do one thing and must not do another.
void allow_parts(FilterWriter& filter, const Policy& policy, Wall wall) {
  allow_opening(filter);
  for (const int request : {TCGETS, FIONREAD}) {
    filter.allow(SCMP_SYS(ioctl), {has(1, 0xffffffff, static_cast<std::uint64_t>(request))});
  }
  for (const int command : {F_GETFD, F_SETFD, F_GETFL, F_DUPFD, F_DUPFD_CLOEXEC}) {
    filter.allow(SCMP_SYS(fcntl), {has(1, 0xffffffff, static_cast<std::uint64_t>(command))});
  }
  // With O_ASYNC whoever owns the other end's descriptor would get signals.
  filter.allow(SCMP_SYS(fcntl), {has(1, 0xffffffff, F_SETFL), has(2, O_ASYNC, 0)});
  for (const int option : {PR_SET_NAME, PR_GET_NAME}) {
    filter.allow(SCMP_SYS(prctl), {has(0, 0xffffffff, static_cast<std::uint64_t>(option))});
  }
  // Its own limits may be read.
  filter.allow(SCMP_SYS(prlimit64), {is(0, 0), is(2, 0)});
  // Signals to itself: `abort`. In bubblewrap's room there is nobody else but the process of its own that
  // waits for the program, under the same filter.
  if (wall == Wall::kBubblewrap) {
    for (const int call : {SCMP_SYS(tgkill), SCMP_SYS(wait4), SCMP_SYS(waitid)}) filter.allow(call);
  } else {
    filter.allow(SCMP_SYS(tgkill), {is(0, kOwnNumber)});
  }
  if (policy.may_start_processes) {
    filter.allow(SCMP_SYS(clone), {has(0, kOwnNamespaces, 0)});
  } else if (policy.may_start_threads) {
    constexpr std::uint64_t kThread = CLONE_VM | CLONE_THREAD | CLONE_SIGHAND;
    filter.allow(SCMP_SYS(clone), {has(0, kOwnNamespaces | kThread, kThread)});
  }
}

}  // namespace

std::expected<CallFilter, std::string> CallFilter::make(const Policy& policy, Wall wall) {
  FilterWriter filter;
  // Calls by another architecture's numbers (32 bits, x32) are nothing that happens by mistake.
  filter.set(SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS);
  filter.set(SCMP_FLTATR_CTL_OPTIMIZE, 2);
  for (const int call : kCalls) filter.allow(call);
  for (const int call : kUnknownCalls) filter.refuse(call, ENOSYS);
  if (policy.may_start_processes) {
    for (const int call : kCompilerCalls) filter.allow(call);
    // mold gives up where it can't make its output executable. It is told that it did, and who started it
    // does.
    filter.refuse(SCMP_SYS(fchmod), 0);
  }
  allow_parts(filter, policy, wall);
  auto written = filter.write();
  if (!written)
    return std::unexpected(
        fmt::format("no filter of system calls: {}", std::generic_category().message(written.error())));
  CallFilter out;
  out.instructions_ = std::move(*written);
  return out;
}

int CallFilter::enter() noexcept {
  const auto self = static_cast<std::uint32_t>(getpid());
  for (sock_filter& instruction : instructions_) {
    if (BPF_CLASS(instruction.code) == BPF_JMP && instruction.k == kOwnNumber) instruction.k = self;
  }
  const sock_fprog program{static_cast<unsigned short>(instructions_.size()), instructions_.data()};
  return syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, 0, &program) == 0 ? 0 : errno;
}

}  // namespace mlab::cell
