#include "keeper/children.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <system_error>

#include "pidfd.h"

namespace mlab::network {
namespace {

std::vector<char*> pointers_to(std::vector<std::string>& words, std::size_t begin, std::size_t end) {
  std::vector<char*> out;
  for (std::size_t i = begin; i < end; ++i) out.push_back(words[i].data());
  out.push_back(nullptr);
  return out;
}

[[noreturn]] void become(const Message& request, char* const* words, char* const* environment, int failure) {
  sigset_t none;
  sigemptyset(&none);
  ::pthread_sigmask(SIG_SETMASK, &none, nullptr);
  set_broken_pipe(SIG_DFL);
  ::setsid();
  for (int i = 0; i < 3; ++i) ::dup2(request.files[static_cast<std::size_t>(i)].number(), i);
  const std::string& folder = request.words[0];
  if (::chdir(folder.empty() ? "/" : folder.c_str()) == 0) ::execvpe(words[0], words, environment);
  const int why = errno;
  [[maybe_unused]] const ssize_t written = ::write(failure, &why, sizeof why);
  ::_exit(127);
}

}  // namespace

void set_broken_pipe(void (*handler)(int)) {
  struct sigaction action{};
  action.sa_handler = handler;
  ::sigaction(SIGPIPE, &action, nullptr);
}

Message Children::start(Message request) {
  constexpr std::size_t kCommand = 2;
  Message answer;
  const std::size_t end = request.words.size() < kCommand
                              ? 0
                              : kCommand + static_cast<std::size_t>(std::atoi(request.words[1].c_str()));
  if (end <= kCommand || end > request.words.size() || request.files.size() != 4) {
    answer.words = {"failed", "no command line"};
    return answer;
  }
  const std::vector<char*> words = pointers_to(request.words, kCommand, end);
  const std::vector<char*> environment = pointers_to(request.words, end, request.words.size());
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
    answer.words = {"failed", std::generic_category().message(errno)};
    return answer;
  }
  const Descriptor failure(ends[0]);
  Descriptor in_child(ends[1]);
  const pid_t child = ::fork();
  if (child == 0) become(request, words.data(), environment.data(), in_child.number());
  int why = errno;
  in_child.close();
  if (child > 0 && ::read(failure.number(), &why, sizeof why) == 0) {
    answer.words = {"started", std::to_string(child)};
    answer.files.push_back(open_pidfd(child));
    status_of_.emplace(child, std::move(request.files[3]));
    return answer;
  }
  answer.words = {"failed",
                  "starting " + request.words[kCommand] + ": " + std::generic_category().message(why)};
  return answer;
}

void Children::kill_group(pid_t process) const {
  ::kill(-process, SIGKILL);
}

void Children::reap() {
  int status = 0;
  for (pid_t one = ::waitpid(-1, &status, WNOHANG); one > 0; one = ::waitpid(-1, &status, WNOHANG)) {
    const auto found = status_of_.find(one);
    if (found == status_of_.end()) continue;
    [[maybe_unused]] const ssize_t written = ::write(found->second.number(), &status, sizeof status);
    status_of_.erase(found);
  }
}

}  // namespace mlab::network
