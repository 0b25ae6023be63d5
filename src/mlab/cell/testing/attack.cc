// What the tests put into cells: tries one thing and says whether it got through.
//
//     cell_attack NAME FOLDER VICTIM
//
// FOLDER belongs to others and holds a file `secret`; VICTIM is the number of a process that is none of ours.
// Exit status 0: it reached what it should not; 10: it was refused. `harmless` does what every program may
// do.

#include <dirent.h>
#include <fcntl.h>
#include <linux/futex.h>
#include <mqueue.h>
#include <netinet/in.h>
#include <sched.h>
#include <sys/file.h>
#include <sys/inotify.h>
#include <sys/ioctl.h>
#include <sys/ipc.h>
#include <sys/mman.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/shm.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <sys/uio.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

// An attack does what no program should, and there is one thread.
// NOLINTBEGIN(concurrency-mt-unsafe,clang-analyzer-unix.Malloc,clang-analyzer-core.NullDereference)
namespace {

std::string folder;
pid_t victim = -1;

std::string in_folder(const char* name) {
  return folder + "/" + name;
}

bool reads(const std::string& path) {
  const int file = open(path.c_str(), O_RDONLY);
  char byte = 0;
  return file >= 0 && read(file, &byte, 1) == 1;
}

bool writes(const std::string& path, int how) {
  const int file = open(path.c_str(), O_WRONLY | how, 0644);
  return file >= 0 && write(file, "x", 1) == 1;
}

bool lists(const std::string& path, const std::string& name) {
  DIR* open_folder = opendir(path.c_str());
  if (open_folder == nullptr) return false;
  while (const dirent* entry = readdir(open_folder)) {
    if (name == entry->d_name) return true;
  }
  return false;
}

// A process of its own that ends at once.
bool has_child(pid_t child) {
  if (child == 0) _exit(0);
  return child > 0 && waitpid(child, nullptr, 0) == child;
}

bool becomes(const char* program) {
  execl(program, program, "-c", "exit 0", nullptr);
  return false;
}

bool calls(long number) {
  return syscall(number, nullptr, 0, 0, 0, 0, 0) >= 0 || (errno != EPERM && errno != ENOSYS);
}

bool connects_unix() {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, in_folder("socket").c_str(), sizeof address.sun_path - 1);
  const int end = socket(AF_UNIX, SOCK_STREAM, 0);
  return end >= 0 && connect(end, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
}

bool peeks() {
  char byte = 0;
  const iovec own{&byte, 1};
  const iovec theirs{&folder, 1};  // an address that may mean nothing there: EFAULT comes after permission
  return process_vm_readv(victim, &own, 1, &theirs, 1, 0) == 1 || errno == EFAULT;
}

bool traces() {
  return ptrace(PTRACE_SEIZE, victim, nullptr, nullptr) == 0;
}

bool takes_memory() {
  constexpr std::size_t kMuch = std::size_t{100} << 30;
  return mmap(nullptr, kMuch, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0) !=
         MAP_FAILED;
}

bool fills_memory() {
  constexpr std::size_t kStep = std::size_t{64} << 20;
  for (std::size_t taken = 0; taken < (std::size_t{1} << 30); taken += kStep) {
    if (void* block = std::malloc(kStep); block == nullptr) return false;
  }
  return true;
}

bool has_thread() {
  try {
    std::thread([] {}).join();
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

bool limits_victim() {
  rlimit old{};
  if (prlimit(victim, RLIMIT_NOFILE, nullptr, &old) != 0) return false;
  return prlimit(victim, RLIMIT_NOFILE, &old, nullptr) == 0;
}

bool frees_itself() {
  rlimit mine{};
  getrlimit(RLIMIT_CORE, &mine);
  return setrlimit(RLIMIT_CORE, &mine) == 0;
}

bool asks_for_signals() {
  int ends[2] = {1, 1};
  return fcntl(ends[0], F_SETOWN, victim) == 0;
}

bool pushes_letters() {
  // Without a terminal it fails with ENOTTY, after it was let through.
  return ioctl(0, TIOCSTI, "x") == 0 || errno == ENOTTY || errno == EIO;
}

#ifdef __x86_64__
// As a program for 32 bits would: a filter that knows one architecture alone does not see it.
bool calls_as_32_bits() {
  long result = 0;
  asm volatile("int $0x80" : "=a"(result) : "a"(20L) : "memory", "r8", "r9", "r10", "r11");  // getpid
  return result > 0;
}

// mkdir, by the numbers of x32: its own are these with one bit more.
bool calls_as_x32() {
  return syscall(0x40000000L + 39) > 0;  // getpid
}
#endif

using Attack = bool (*)();

const std::map<std::string, Attack> kAttacks = {
    // files
    {"read", [] { return reads(in_folder("secret")); }},
    {"read_password", [] { return reads("/etc/passwd"); }},
    {"read_environment", [] { return reads("/proc/self/environ"); }},
    {"read_environment_of_another", [] { return reads("/proc/" + std::to_string(victim) + "/environ"); }},
    {"read_memory_of_another",
     [] { return open(("/proc/" + std::to_string(victim) + "/mem").c_str(), O_RDWR) >= 0; }},
    {"read_inherited",
     [] {
       char c = 0;
       return pread(200, &c, 1, 0) == 1;
     }},
    {"list", [] { return lists(folder, "secret"); }},
    {"list_root", [] { return lists("/", "home"); }},
    {"through_link", [] { return reads(in_folder("link")); }},
    {"write", [] { return writes(in_folder("made"), O_CREAT); }},
    {"append", [] { return writes(in_folder("secret"), O_APPEND); }},
    {"truncate", [] { return truncate(in_folder("cut").c_str(), 0) == 0; }},
    {"truncate_by_opening", [] { return open(in_folder("cut").c_str(), O_RDONLY | O_TRUNC) >= 0; }},
    {"remove", [] { return unlink(in_folder("gone").c_str()) == 0; }},
    {"rename", [] { return rename(in_folder("moved").c_str(), in_folder("to").c_str()) == 0; }},
    {"make_folder", [] { return mkdir(in_folder("folder").c_str(), 0755) == 0; }},
    {"symlink", [] { return symlink("/", in_folder("new_link").c_str()) == 0; }},
    {"link", [] { return link(in_folder("secret").c_str(), in_folder("second").c_str()) == 0; }},
    {"make_pipe", [] { return mkfifo(in_folder("pipe").c_str(), 0644) == 0; }},
    {"make_device", [] { return mknod(in_folder("device").c_str(), S_IFCHR | 0644, 0x103) == 0; }},
    {"mode", [] { return chmod(in_folder("secret").c_str(), 0644) == 0; }},
    {"owner", [] { return chown(in_folder("secret").c_str(), getuid(), getgid()) == 0; }},
    {"times", [] { return utimes(in_folder("secret").c_str(), nullptr) == 0; }},
    {"attribute", [] { return setxattr(in_folder("secret").c_str(), "user.x", "y", 1, 0) == 0; }},
    {"shared_memory", [] { return shm_open("/mlab_cell_attack", O_RDWR | O_CREAT, 0600) >= 0; }},
    {"system_v_memory", [] { return shmget(IPC_PRIVATE, 4096, IPC_CREAT | 0600) >= 0; }},
    {"message_queue", [] { return mq_open("/mlab_cell_attack", O_RDWR | O_CREAT, 0600, nullptr) >= 0; }},
    {"memory_file", [] { return memfd_create("x", 0) >= 0; }},
    {"watch_files", [] { return inotify_init1(0) >= 0; }},
    {"change_root", [] { return chroot("/") == 0; }},
    {"mount",
     [] { return mount("none", folder.c_str(), "tmpfs", 0, nullptr) == 0 && umount(folder.c_str()) == 0; }},
    // network
    {"internet", [] { return socket(AF_INET, SOCK_STREAM, 0) >= 0; }},
    {"internet_6", [] { return socket(AF_INET6, SOCK_DGRAM, 0) >= 0; }},
    {"unix_socket", connects_unix},
    {"netlink", [] { return socket(AF_NETLINK, SOCK_RAW, 0) >= 0; }},
    {"socket_pair",
     [] {
       int ends[2];
       return socketpair(AF_UNIX, SOCK_STREAM, 0, ends) == 0;
     }},
    // processes
    {"fork", [] { return has_child(fork()); }},
    {"raw_fork", [] { return has_child(static_cast<pid_t>(syscall(SYS_clone, SIGCHLD, 0, 0, 0, 0))); }},
    {"thread", has_thread},
    {"shell", [] { return becomes("/bin/sh"); }},
    {"exec", [] { return becomes("/usr/bin/true"); }},
    {"kill", [] { return kill(victim, SIGCONT) == 0; }},
    {"kill_thread", [] { return syscall(SYS_tgkill, victim, victim, SIGCONT) == 0; }},
    {"queue_signal",
     [] {
       siginfo_t info{};
       info.si_code = SI_QUEUE;
       return syscall(SYS_rt_sigqueueinfo, victim, SIGCONT, &info) == 0;
     }},
    {"kill_group", [] { return kill(0, SIGCONT) == 0; }},
    {"trace", traces},
    {"trace_me", [] { return ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) == 0; }},
    {"peek", peeks},
    {"process_descriptor", [] { return syscall(SYS_pidfd_open, victim, 0) >= 0; }},
    {"limit_another", limits_victim},
    {"limit_itself", frees_itself},
    {"leave_group", [] { return setpgid(0, 0) == 0 || setsid() >= 0; }},
    {"become_another", [] { return setuid(getuid()) == 0; }},
    {"own_namespace", [] { return unshare(CLONE_NEWUSER) == 0; }},
    {"schedule",
     [] {
       sched_param p{};
       return sched_setscheduler(0, SCHED_OTHER, &p) == 0;
     }},
    {"niceness", [] { return setpriority(PRIO_PROCESS, static_cast<id_t>(victim), 1) == 0; }},
    // memory
    {"memory", takes_memory},
    {"many_blocks", fills_memory},
    // the rest of the kernel
    {"signals_from_files", asks_for_signals},
    {"terminal", pushes_letters},
    {"keys", [] { return calls(SYS_keyctl); }},
    {"bpf", [] { return calls(SYS_bpf); }},
    {"performance", [] { return calls(SYS_perf_event_open); }},
    {"io_uring", [] { return calls(SYS_io_uring_setup); }},
    {"userfault", [] { return calls(SYS_userfaultfd); }},
    {"no_longer_die", [] { return prctl(PR_SET_DUMPABLE, 1) == 0; }},
#ifdef __x86_64__
    {"as_32_bits", calls_as_32_bits},
    {"as_x32", calls_as_x32},
#endif
};

[[noreturn]] void fail(const char* what) {
  std::printf("%s: %s\n", what, std::strerror(errno));
  std::fflush(stdout);
  _exit(20);
}

// All that a robot's program needs: shared memory as descriptor 3, waiting on it, time, pipes, exceptions.
int harmless() {
  void* shared = mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_SHARED, 3, 0);
  if (shared == MAP_FAILED) fail("mmap");
  auto* word = static_cast<std::uint32_t*>(shared);
  *word = 7;
  const timespec soon{0, 1000};
  if (syscall(SYS_futex, word, FUTEX_WAIT, 7, &soon, nullptr, 0) != -1 || errno != ETIMEDOUT) fail("futex");
  if (syscall(SYS_futex, word, FUTEX_WAKE, 1, nullptr, nullptr, 0) != 0) fail("wake");
  timespec now{};
  if (clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now) != 0) fail("clock_gettime");
  std::this_thread::sleep_for(std::chrono::microseconds(10));
  sched_yield();
  std::vector<double> values(1 << 20, 1.0);
  try {
    throw std::runtime_error("caught");
  } catch (const std::runtime_error&) {
    values.back() = 2.0;
  }
  char byte = 0;
  if (read(0, &byte, 1) != 0) fail("read");
  *word = values.back() == 2.0 ? 42 : 0;
  std::puts("done");
  return 0;
}

// Deeper than any stack; through a pointer, so that it stays a call.
int recurse(int depth);
int (*volatile again)(int) = recurse;
int recurse(int depth) {
  volatile char room[4096];
  room[0] = static_cast<char>(depth);
  return again(depth + 1) + room[0];
}

}  // namespace

int main(int count, char** words) {
  if (count != 4) return 2;
  const std::string name = words[1];
  folder = words[2];
  victim = static_cast<pid_t>(std::atoi(words[3]));
  if (name == "harmless") return harmless();
  if (name == "abort") std::abort();
  if (name == "crash") *static_cast<volatile int*>(nullptr) = 1;
  if (name == "recurse") return recurse(0);
  if (name == "loop") {
    for (volatile bool on = true; on;) {
    }
  }
  if (name == "names") {
    for (const auto& [each, attack] : kAttacks) std::puts(each.c_str());
    return 0;
  }
  const auto attack = kAttacks.find(name);
  if (attack == kAttacks.end()) return 3;
  if (attack->second()) return 0;
  std::printf("%s\n", std::strerror(errno));
  return 10;
}
// NOLINTEND(concurrency-mt-unsafe,clang-analyzer-unix.Malloc,clang-analyzer-core.NullDereference)
