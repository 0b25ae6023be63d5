#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <fstream>
#include <mutex>
#include <system_error>

#include "talk.h"

namespace mlab::network::talk {
namespace {

[[noreturn]] void sleep_for_ever() {
  for (;;) ::pause();
}

}  // namespace

int fill(const Words& words) {
  const int file = ::open((words.at(0) + "/file").c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0644);
  if (file < 0) give_up("opening");
  const std::array<char, 4096> block{};
  std::size_t all = 0;
  ssize_t size = 0;
  while ((size = ::write(file, block.data(), block.size())) > 0) all += static_cast<std::size_t>(size);
  tell(fmt::format("{} {}", all, errno == ENOSPC ? "ENOSPC" : std::generic_category().message(errno)));
  return 0;
}

int spawn(const Words&) {
  if (::fork() == 0) {
    ::setsid();
    sleep_for_ever();
  }
  if (::fork() == 0) sleep_for_ever();
  tell("ready");
  sleep_for_ever();
}

int litter(const Words& words) {
  for (const std::string& file : words) std::ofstream(file) << "left";
  if (::fork() == 0) {
    ::setsid();
    sleep_for_ever();
  }
  return 0;
}

int wait(const Words& words) {
  std::mutex mutex;
  std::condition_variable never;
  std::unique_lock lock(mutex);
  const auto begin = std::chrono::steady_clock::now();
  const auto until = std::chrono::system_clock::now() +
                     std::chrono::milliseconds(static_cast<int>(std::atof(words.at(0).c_str()) * 1000));
  tell("ready");  // the clock has been read
  while (never.wait_until(lock, until) != std::cv_status::timeout) continue;
  tell(fmt::format("waited {}", std::chrono::duration_cast<std::chrono::milliseconds>(
                                    std::chrono::steady_clock::now() - begin)
                                    .count()));
  return 0;
}

int clocks(const Words&) {
  const auto count = [](auto time) {
    return std::chrono::duration_cast<std::chrono::milliseconds>(time).count();
  };
  tell(fmt::format("{} {}", count(std::chrono::system_clock::now().time_since_epoch()),
                   count(std::chrono::steady_clock::now().time_since_epoch())));
  return 0;
}

int chatter(const Words& words) {
  const std::string line(99, 'x');
  for (long left = std::atol(words.at(0).c_str()); left > 0; left -= 100) {
    fmt::print("{}\n", line);
    fmt::print(stderr, "{}\n", line);
  }
  tell("the end");
  return 3;
}

}  // namespace mlab::network::talk
