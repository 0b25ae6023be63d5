#include "mlab/git/run_git.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <string_view>

namespace mlab::git {
namespace {

constexpr std::size_t kMostErrors = 8192;

// What a repository's own settings could have executed is shut, command by command (git.cc) and here.
constexpr std::array kSettings = {
    "core.fsmonitor=false",
    "core.hooksPath=/dev/null",
    "core.pager=cat",
    "log.showSignature=false",
    "safe.bareRepository=explicit",
    "protocol.allow=never",
    "core.sshCommand=false",
    "core.askPass=",
    "core.alternateRefsCommand=",
    "credential.helper=",
};

std::vector<std::string> environment() {
  constexpr std::array kKept = {
      "GIT_CEILING_DIRECTORIES=", "GIT_CONFIG_GLOBAL=", "GIT_CONFIG_SYSTEM=", "GIT_CONFIG_NOSYSTEM="};
  std::vector<std::string> out;
  for (char** one = environ; *one != nullptr; ++one) {
    const std::string_view entry = *one;
    const bool is_kept =
        std::ranges::any_of(kKept, [&](const char* kept) { return entry.starts_with(kept); });
    if (!entry.starts_with("GIT_") || is_kept) out.emplace_back(entry);
  }
  std::erase_if(out, [](const std::string& entry) { return entry.starts_with("LC_ALL="); });
  for (const char* entry : {"LC_ALL=C.UTF-8", "GIT_OPTIONAL_LOCKS=0", "GIT_TERMINAL_PROMPT=0",
                            "GIT_ALLOW_PROTOCOL=", "GIT_NO_LAZY_FETCH=1", "GIT_LITERAL_PATHSPECS=1",
                            "GIT_PAGER=cat", "GIT_NO_REPLACE_OBJECTS=1"})
    out.emplace_back(entry);
  return out;
}

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> out;
  out.reserve(words.size() + 1);
  for (std::string& word : words) out.push_back(word.data());
  out.push_back(nullptr);
  return out;
}

struct Pipe {
  Pipe() {
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) ends = {-1, -1};
  }
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  void close_end(std::size_t which) {
    if (ends[which] >= 0) ::close(ends[which]);
    ends[which] = -1;
  }
  std::array<int, 2> ends{-1, -1};
};

// False at its end.
bool take(int from, std::string& into) {
  std::array<char, 65536> piece{};
  const ssize_t count = ::read(from, piece.data(), piece.size());
  if (count < 0) return errno == EINTR || errno == EAGAIN;
  into.append(piece.data(), static_cast<std::size_t>(count));
  return count > 0;
}

// Everything that it writes, until it closes both.
void read_all(Pipe& output, Pipe& errors, std::size_t most, double seconds, GitAnswer& out) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  std::array<pollfd, 2> waiting = {{{output.ends[0], POLLIN, 0}, {errors.ends[0], POLLIN, 0}}};
  while (waiting[0].fd >= 0 || waiting[1].fd >= 0) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
    if (left.count() <= 0 || out.output.size() > most) {
      out.is_whole = false;
      return;
    }
    if (::poll(waiting.data(), waiting.size(), static_cast<int>(left.count())) < 0 && errno != EINTR) return;
    if (waiting[0].fd >= 0 && waiting[0].revents != 0 && !take(waiting[0].fd, out.output)) waiting[0].fd = -1;
    if (waiting[1].fd >= 0 && waiting[1].revents != 0) {
      std::string piece;
      if (!take(waiting[1].fd, piece)) waiting[1].fd = -1;
      if (out.errors.size() < kMostErrors) out.errors += piece;
    }
  }
}

}  // namespace

GitAnswer run_git(const std::string& folder, const std::vector<std::string>& arguments, std::size_t most,
                  double seconds) {
  GitAnswer out;
  std::vector<std::string> words = {"git", "--no-pager", "-C", folder};
  for (const char* setting : kSettings) {
    words.emplace_back("-c");
    words.emplace_back(setting);
  }
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<std::string> settings = environment();
  Pipe output;
  Pipe errors;
  posix_spawn_file_actions_t actions{};
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, output.ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, errors.ends[1], STDERR_FILENO);
  pid_t process = 0;
  out.failure =
      posix_spawnp(&process, "git", &actions, nullptr, pointers(words).data(), pointers(settings).data());
  posix_spawn_file_actions_destroy(&actions);
  if (out.failure != 0) return out;
  output.close_end(1);
  errors.close_end(1);
  read_all(output, errors, most, seconds, out);
  if (!out.is_whole) ::kill(process, SIGKILL);
  int status = 0;
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  out.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return out;
}

}  // namespace mlab::git
