#pragma once

// What a stranger's procedure may try. The test includes this for the names; what is here runs in a robot's
// process alone, in a cell, and in the twin without one.

#include <dirent.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <sched.h>
#include <spawn.h>
#include <sys/mman.h>
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
#include <unistd.h>

#include <cerrno>
#include <csetjmp>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

// NOLINTBEGIN: an attack does what no program should
namespace hostile {

/// What an attack knows of the world outside, as parameters of its robot.
struct World {
  double number;  ///< of the folder that belongs to others
  double tcp;     ///< ports that somebody else listens at
  double udp;
  double marker;  ///< address of a long in the parent

  std::string in(const char* name) const {
    return "/tmp/mlab_hostile_" + std::to_string(static_cast<long>(number)) + "/" + name;
  }
};

inline bool reads(const std::string& path) {
  const int file = open(path.c_str(), O_RDONLY);
  char byte = 0;
  return file >= 0 && read(file, &byte, 1) == 1;
}

inline bool writes(const std::string& path, int how = O_CREAT) {
  const int file = open(path.c_str(), O_WRONLY | how, 0644);
  return file >= 0 && write(file, "x", 1) == 1;
}

inline std::string touch(const World& w) {
  return "exec /usr/bin/touch " + w.in("made");
}

inline std::string of_parent(const char* what) {
  return "/proc/" + std::to_string(getppid()) + "/" + what;
}

// In a child that was made somehow.
inline bool leaves_trace(long child, const World& w) {
  if (child != 0) return child > 0 && waitpid(static_cast<pid_t>(child), nullptr, 0) == child;
  writes(w.in("made"));
  _exit(0);
}

inline bool sends(int family, int kind, double port) {
  sockaddr_in there{};
  there.sin_family = AF_INET;
  there.sin_port = htons(static_cast<std::uint16_t>(port));
  there.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const int end = socket(family, kind, 0);
  return end >= 0 && connect(end, reinterpret_cast<sockaddr*>(&there), sizeof there) == 0 &&
         write(end, "x", 1) == 1;
}

inline bool meets(int (*how)(int, const sockaddr*, socklen_t), const std::string& path) {
  sockaddr_un there{};
  there.sun_family = AF_UNIX;
  std::strncpy(there.sun_path, path.c_str(), sizeof there.sun_path - 1);
  const int end = socket(AF_UNIX, SOCK_STREAM, 0);
  return end >= 0 && how(end, reinterpret_cast<sockaddr*>(&there), sizeof there) == 0;
}

inline bool listens() {
  sockaddr_in here{};
  here.sin_family = AF_INET;
  const int end = socket(AF_INET, SOCK_STREAM, 0);
  return end >= 0 && bind(end, reinterpret_cast<sockaddr*>(&here), sizeof here) == 0 && listen(end, 1) == 0;
}

inline void* marker(const World& w) {
  return reinterpret_cast<void*>(static_cast<std::uintptr_t>(w.marker));
}

inline bool writes_through_proc(const World& w) {
  const long one = 1;
  const int file = open(of_parent("mem").c_str(), O_RDWR);
  return file >= 0 && pwrite(file, &one, sizeof one, static_cast<off_t>(w.marker)) == sizeof one;
}

inline bool writes_through_vm(const World& w) {
  long one = 1;
  const iovec mine{&one, sizeof one};
  const iovec theirs{marker(w), sizeof one};
  return process_vm_writev(getppid(), &mine, 1, &theirs, 1, 0) == sizeof one;
}

inline bool writes_through_trace(const World& w) {
  const pid_t parent = getppid();
  if (ptrace(PTRACE_SEIZE, parent, nullptr, nullptr) != 0) return false;
  ptrace(PTRACE_INTERRUPT, parent, nullptr, nullptr);
  waitpid(parent, nullptr, __WALL);
  const bool done = ptrace(PTRACE_POKEDATA, parent, marker(w), reinterpret_cast<void*>(1)) == 0;
  ptrace(PTRACE_DETACH, parent, nullptr, nullptr);
  return done;
}

inline bool limits_parent() {
  rlimit now{};
  if (prlimit(getppid(), RLIMIT_CORE, nullptr, &now) != 0 || now.rlim_cur == 0) return false;
  now.rlim_cur = 0;
  return prlimit(getppid(), RLIMIT_CORE, &now, nullptr) == 0;
}

inline bool runs_from_memory(const World& w) {
  const int program = memfd_create("program", 0);
  const std::string script = "#!/bin/sh\n" + touch(w) + "\n";
  if (program < 0 || write(program, script.data(), script.size()) < 0) return false;
  char* const words[] = {const_cast<char*>("program"), nullptr};
  fexecve(program, words, environ);
  return false;
}

inline bool spawns(const World& w) {
  const std::string line = touch(w);
  char* const words[] = {const_cast<char*>("sh"), const_cast<char*>("-c"), const_cast<char*>(line.c_str()),
                         nullptr};
  pid_t child = -1;
  errno = posix_spawn(&child, "/bin/sh", nullptr, nullptr, words, environ);
  return errno == 0 && waitpid(child, nullptr, 0) == child;
}

inline bool borrows(const World& w) {
  const std::string line = touch(w);
  const pid_t child = vfork();
  if (child == 0) {
    execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
    _exit(1);
  }
  return child > 0 && waitpid(child, nullptr, 0) == child;
}

inline bool asks_pipe(const World& w) {
  std::FILE* end = popen(touch(w).c_str(), "r");
  return end != nullptr && pclose(end) == 0;
}

// An exception of the standard library says why not.
inline bool has_thread(const World& w) {
  std::thread([&] { writes(w.in("made")); }).join();
  return true;
}

inline bool shares_memory(const World& w) {
  const std::string name = "/mlab_hostile_" + std::to_string(static_cast<long>(w.number));
  return shm_open(name.c_str(), O_RDWR | O_CREAT, 0600) >= 0;
}

inline bool maps_device() {
  const int file = open("/dev/mem", O_RDWR);
  return file >= 0 && mmap(nullptr, 4096, PROT_READ, MAP_SHARED, file, 0) != MAP_FAILED;
}

inline bool lists(const std::string& path) {
  DIR* folder = opendir(path.c_str());
  return folder != nullptr && readdir(folder) != nullptr;
}

inline bool raises_limit() {
  const rlimit any{RLIM_INFINITY, RLIM_INFINITY};
  return setrlimit(RLIMIT_AS, &any) == 0;
}

[[noreturn]] inline void spin() {
  for (;;) asm volatile("");
}

inline void ignore_everything() {
  for (int signal = 1; signal < NSIG; ++signal) std::signal(signal, SIG_IGN);
  sigset_t all;
  sigfillset(&all);
  sigprocmask(SIG_SETMASK, &all, nullptr);
}

inline int recurse(int depth);
inline int (*volatile again)(int) = recurse;
inline int recurse(int depth) {
  volatile char room[4096];
  room[0] = static_cast<char>(depth);
  return again(depth + 1) + room[0];
}

constexpr std::size_t kMuch = std::size_t{100} << 30;

// So that nobody finds that it is not used.
inline bool is_had(void* memory) {
  asm volatile("" : : "r"(memory) : "memory");
  return memory != nullptr;
}

inline bool grows() {
  std::vector<double> list;
  for (;;) list.reserve(2 * list.capacity() + 1);
}

inline bool talks(int to) {
  const std::string line(4000, 'x');
  for (;;) {
    if (write(to, line.data(), line.size()) < 0) std::abort();
  }
}

// Descriptor 3 is what the robot shares with the run.
inline bool scribbles() {
  void* shared = mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_SHARED, 3, 0);
  if (shared == MAP_FAILED) return false;
  std::memset(shared, 0xff, 4096);
  spin();
}

// More than its memory may be.
inline bool writes_behind_the_end() {
  return pwrite(3, "x", 1, off_t{900} << 20) == 1;
}

inline bool closes_everything() {
  for (int i = 0; i < 1024; ++i) close(i);
  std::abort();
}

inline bool disturbs_conversation() {
  const std::string noise(5000, '\xff');
  for (int i = 5; i < 16; ++i) {
    if (write(i, noise.data(), noise.size()) < 0) continue;
  }
  std::abort();
}

inline void handle_and_return(int) {}

struct Attack {
  const char* name;
  bool (*run)(const World& w);  ///< true: it got through
};

inline constexpr Attack kAttacks[] = {
    // files
    {"read_secret", [](const World& w) { return reads(w.in("outside/secret")); }},
    {"read_passwords", [](const World&) { return reads("/etc/passwd"); }},
    {"read_environment", [](const World&) { return reads("/proc/self/environ"); }},
    {"read_environment_of_parent", [](const World&) { return reads(of_parent("environ")); }},
    {"read_project", [](const World& w) { return reads(w.in("project/m.mdl")); }},
    {"list", [](const World& w) { return lists(w.in("outside")); }},
    {"make_file", [](const World& w) { return writes(w.in("made")); }},
    {"write_in_home", [](const World& w) { return writes(w.in("home/made")); }},
    {"write_in_project", [](const World& w) { return writes(w.in("project/made")); }},
    {"append", [](const World& w) { return writes(w.in("outside/whole"), O_APPEND); }},
    {"truncate", [](const World& w) { return truncate(w.in("outside/whole").c_str(), 0) == 0; }},
    {"remove", [](const World& w) { return unlink(w.in("outside/whole").c_str()) == 0; }},
    {"rename",
     [](const World& w) { return rename(w.in("outside/whole").c_str(), w.in("made").c_str()) == 0; }},
    {"mode", [](const World& w) { return chmod(w.in("outside/whole").c_str(), 0777) == 0; }},
    {"make_folder", [](const World& w) { return mkdir(w.in("made").c_str(), 0755) == 0; }},
    {"symbolic_link", [](const World& w) { return symlink("/etc", w.in("made").c_str()) == 0; }},
    {"hard_link",
     [](const World& w) { return link(w.in("outside/whole").c_str(), w.in("made").c_str()) == 0; }},
    {"make_pipe", [](const World& w) { return mkfifo(w.in("made").c_str(), 0644) == 0; }},
    {"make_socket", [](const World& w) { return meets(bind, w.in("made")); }},
    {"posix_memory", [](const World& w) { return shares_memory(w); }},
    // processes
    {"thread", has_thread},
    {"fork", [](const World& w) { return leaves_trace(fork(), w); }},
    {"raw_clone", [](const World& w) { return leaves_trace(syscall(SYS_clone, SIGCHLD, 0, 0, 0, 0), w); }},
    {"vfork", borrows},
    {"spawn", spawns},
    {"system", [](const World& w) { return system(touch(w).c_str()) == 0; }},
    {"popen", asks_pipe},
    {"exec",
     [](const World& w) { return execl("/usr/bin/touch", "touch", w.in("made").c_str(), nullptr) == 0; }},
    {"run_from_memory", runs_from_memory},
    // network
    {"tcp", [](const World& w) { return sends(AF_INET, SOCK_STREAM, w.tcp); }},
    {"udp", [](const World& w) { return sends(AF_INET, SOCK_DGRAM, w.udp); }},
    {"unix_socket", [](const World& w) { return meets(connect, w.in("socket")); }},
    {"netlink", [](const World&) { return socket(AF_NETLINK, SOCK_RAW, 0) >= 0; }},
    {"listen", [](const World&) { return listens(); }},
    // the parent
    {"kill_parent", [](const World&) { return kill(getppid(), SIGUSR1) == 0; }},
    {"trace_parent", writes_through_trace},
    {"write_parent_through_proc", writes_through_proc},
    {"write_parent_through_vm", writes_through_vm},
    {"limit_parent", [](const World&) { return limits_parent(); }},
    // its own process, and the rest of the kernel
    {"raise_limit", [](const World&) { return raises_limit(); }},
    {"dumpable", [](const World&) { return prctl(PR_SET_DUMPABLE, 1) == 0; }},
    {"outlive", [](const World&) { return prctl(PR_SET_PDEATHSIG, 0) == 0; }},
    {"system_v_memory",
     [](const World&) {
       const int memory = shmget(IPC_PRIVATE, 4096, IPC_CREAT | 0600);
       return memory >= 0 && shmctl(memory, IPC_RMID, nullptr) == 0;
     }},
    {"become_another", [](const World&) { return setuid(getuid()) == 0; }},
    {"own_namespace", [](const World&) { return unshare(CLONE_NEWUSER) == 0; }},
    {"device_memory", [](const World&) { return maps_device(); }},
    {"io_uring",
     [](const World&) {
       return syscall(SYS_io_uring_setup, 0, nullptr) >= 0 || errno == EFAULT || errno == EINVAL;
     }},
    // what it shares with the run
    {"write_percepts",
     [](const World&) { return mmap(nullptr, 4096, PROT_WRITE, MAP_SHARED, 4, 0) != MAP_FAILED; }},
    {"grow_shared_memory", [](const World&) { return writes_behind_the_end(); }},
    {"scribble", [](const World&) { return scribbles(); }},
    {"disturb_conversation", [](const World&) { return disturbs_conversation(); }},
    {"close_everything", [](const World&) { return closes_everything(); }},
    // never coming back
    {"spin", [](const World&) -> bool { spin(); }},
    {"sleep",
     [](const World&) -> bool {
       for (;;) sleep(1000);
     }},
    {"stop", [](const World&) { return raise(SIGSTOP) == 0; }},
    {"ignore_signals_and_spin",
     [](const World&) -> bool {
       ignore_everything();
       spin();
     }},
    {"handle_crash_for_ever",
     [](const World&) {
       std::signal(SIGSEGV, handle_and_return);
       *static_cast<volatile int*>(nullptr) = 1;
       return true;
     }},
    {"jump_out_of_crash_for_ever",
     [](const World&) -> bool {
       static sigjmp_buf before;
       struct sigaction action{};
       action.sa_handler = [](int) { siglongjmp(before, 1); };
       sigaction(SIGSEGV, &action, nullptr);
       sigsetjmp(before, 1);
       *static_cast<volatile int*>(nullptr) = 1;
       spin();
     }},
    {"talk_for_ever", [](const World&) { return talks(1); }},
    {"complain_for_ever", [](const World&) { return talks(2); }},
    // the end
    {"recurse", [](const World&) { return recurse(0) == 0; }},
    {"crash",
     [](const World&) {
       *static_cast<volatile int*>(nullptr) = 1;
       return true;
     }},
    {"end_at_once", [](const World&) -> bool { _exit(0); }},
    {"exit", [](const World&) -> bool { std::exit(0); }},
    {"abort", [](const World&) -> bool { std::abort(); }},
    {"kill_itself", [](const World&) { return raise(SIGKILL) == 0; }},
    {"terminate", [](const World&) -> bool { std::terminate(); }},
    {"throw", [](const World&) -> bool { return std::vector<bool>().at(1); }},
    {"jump_nowhere",
     [](const World&) -> bool {
       static std::jmp_buf never_set;
       std::longjmp(never_set, 1);
     }},
    // memory
    {"new_much", [](const World&) { return is_had(new char[kMuch]); }},
    {"malloc_much", [](const World&) { return is_had(std::malloc(kMuch)); }},
    {"map_much",
     [](const World&) {
       return mmap(nullptr, kMuch, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1,
                   0) != MAP_FAILED;
     }},
    {"grow", [](const World&) { return grows(); }},
};

/// @param which  index of kAttacks
/// @return  1: it got through. What was refused ends the process, saying why.
inline double run(double which, const World& w) {
  const Attack& attack = kAttacks[static_cast<std::size_t>(which)];
  if (attack.run(w)) return 1.0;
  std::fprintf(stderr, "%s: %s\n", attack.name, std::strerror(errno));
  std::abort();
}

}  // namespace hostile
// NOLINTEND
