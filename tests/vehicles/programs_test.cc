// The programs as people start them, and devices over a line of the system's, in real time.

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/vehicle/mrv2/mrv2.h"
#include "mlab/vehicle/text_rover/text_rover.h"

namespace mlab::vehicle {
namespace {

using namespace std::chrono_literals;

/// A program that is killed with its object.
class Started {
 public:
  explicit Started(const std::vector<std::string>& words) {
    std::vector<char*> pointers;
    for (const std::string& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
    pointers.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    EXPECT_EQ(::posix_spawn(&pid_, pointers[0], &actions, nullptr, pointers.data(), environ), 0);
    posix_spawn_file_actions_destroy(&actions);
  }
  ~Started() { end(SIGKILL); }
  Started(const Started&) = delete;
  Started& operator=(const Started&) = delete;

  /// @return  exit status; -1: the signal ended it
  int end(int signal) {
    if (pid_ <= 0) return -1;
    if (signal != 0) ::kill(pid_, signal);
    int status = 0;
    ::waitpid(pid_, &status, 0);
    pid_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  pid_t pid_ = 0;
};

/// Works until it is so, for some seconds at most.
bool becomes(Device& device, const std::function<bool(const Report&)>& is_so) {
  const auto end = Clock::now() + 10s;
  while (Clock::now() < end) {
    device.work(Clock::now());
    if (is_so(device.report(Clock::now()))) return true;
    std::this_thread::sleep_for(5ms);
  }
  return false;
}

bool is_ready(const Report& report) {
  return report.readiness == Readiness::kReady;
}

/// Its program is started, drives, is killed, is started again, and ended.
void live_through_a_kill(const std::string& program, const std::string& link, Device& device) {
  {
    Started vehicle({program, "--link", link});
    ASSERT_TRUE(becomes(device, is_ready)) << device.report(Clock::now()).why;
    const bool moves = becomes(device, [&](const Report& report) {
      device.drive({0.1, 0.0}, Clock::now());
      return report.motion.has_value() && report.motion->speed > 0.05;
    });
    EXPECT_TRUE(moves);
    vehicle.end(SIGKILL);
    std::filesystem::remove(link);  // else it may soon be the name of somebody else's terminal
    const bool is_gone =
        becomes(device, [](const Report& report) { return report.readiness == Readiness::kAbsent; });
    EXPECT_TRUE(is_gone);
    EXPECT_FALSE(device.report(Clock::now()).motion.has_value());
  }
  Started again({program, "--link", link});
  ASSERT_TRUE(becomes(device, is_ready)) << device.report(Clock::now()).why;
  EXPECT_EQ(device.report(Clock::now()).motion->speed, 0.0);
  EXPECT_EQ(again.end(SIGTERM), 0);
  EXPECT_FALSE(std::filesystem::is_symlink(link));
}

std::string link_for(const std::string& name) {
  return (std::filesystem::temp_directory_path() / (name + std::to_string(::getpid()))).string();
}

TEST(Programs, TheMrv2IsDrivenOverAPseudoTerminal) {
  const std::string link = link_for("mlab_mrv2_");
  const auto device = make_mrv2("serial:" + link + ":9600");
  ASSERT_TRUE(device.has_value()) << device.error();
  live_through_a_kill(MLAB_MRV2_MODEL, link, **device);
}

TEST(Programs, TheTextRoverIsDrivenOverAPseudoTerminal) {
  const std::string link = link_for("mlab_text_rover_");
  const auto device = make_text_rover("serial:" + link + ":57600");
  ASSERT_TRUE(device.has_value()) << device.error();
  live_through_a_kill(MLAB_TEXT_ROVER_MODEL, link, **device);
}

TEST(Programs, SayByTheirExitWhatWasWrong) {
  EXPECT_EQ(Started({MLAB_MRV2_MODEL, "--help"}).end(0), 0);
  EXPECT_EQ(Started({MLAB_MRV2_MODEL, "--nonsense"}).end(0), 2);
  EXPECT_EQ(Started({MLAB_MRV2_MODEL, "--dropout", "2"}).end(0), 2);
  EXPECT_EQ(Started({MLAB_MRV2_MODEL, "--world", "/nowhere.odl"}).end(0), 2);
  EXPECT_EQ(Started({MLAB_MRV2_MODEL, "--link", "/"}).end(0), 1);
  EXPECT_EQ(Started({MLAB_TEXT_ROVER_MODEL, "--encoder-noise", "x"}).end(0), 2);
}

}  // namespace
}  // namespace mlab::vehicle
