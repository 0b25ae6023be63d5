// Nothing that a mission's code does goes on once `mlab` is gone, even where it was killed.

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/cell/means.h"
#include "mlab/cell/testing/permission.h"
#include "mlab/cell/testing/poorer_kernel.h"
#include "team.h"

namespace mlab::brought_code {
namespace {

using Clock = std::chrono::steady_clock;

/// A process as /proc tells of it.
struct Seen {
  std::string name;
  char state = 'Z';
  pid_t parent = 0;
  double processor_time = 0.0;  ///< [s]
};

// Nothing where there is none (any more).
std::optional<Seen> look_at(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string text;
  if (!std::getline(file, text)) return std::nullopt;
  const std::size_t open = text.find('(');
  const std::size_t close = text.rfind(')');
  Seen out;
  out.name = text.substr(open + 1, close - open - 1);
  std::istringstream rest(text.substr(close + 1));
  rest >> out.state >> out.parent;
  std::string skipped;
  for (int i = 0; i < 9; ++i) rest >> skipped;
  double user = 0.0;
  double system = 0.0;
  rest >> user >> system;
  out.processor_time = (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
  return out;
}

// All that a process started, and what those started.
std::vector<pid_t> descendants_of(pid_t process) {
  std::multimap<pid_t, pid_t> children;
  for (const auto& entry : fs::directory_iterator("/proc")) {
    const pid_t one = std::atoi(entry.path().filename().c_str());
    if (const auto seen = one > 0 ? look_at(one) : std::nullopt) children.emplace(seen->parent, one);
  }
  std::vector<pid_t> out = {process};
  for (std::size_t i = 0; i < out.size(); ++i) {
    for (auto [at, end] = children.equal_range(out[i]); at != end; ++at) out.push_back(at->second);
  }
  out.erase(out.begin());
  return out;
}

bool is_gone(pid_t process) {
  const auto seen = look_at(process);
  return !seen || seen->state == 'Z';  // nobody has asked how it ended, but it has
}

/// Asks until it is so; false: it was not within the time.
bool becomes_true(double seconds, const std::function<bool()>& question) {
  const auto deadline = Clock::now() + std::chrono::duration<double>(seconds);
  while (!question()) {
    if (Clock::now() > deadline) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return true;
}

/// What keeps a program in.
enum class Walls { kLandlock, kBubblewrap, kNone };

/// `mlab run`, killed at the worst moment.
class Outliving : public ::testing::TestWithParam<Walls> {
 protected:
  void SetUp() override {
    if (GetParam() != Walls::kNone && cell::kIsSanitized)
      GTEST_SKIP() << "sanitizers want more than a cell gives";
    if (GetParam() == Walls::kLandlock && cell::means().landlock == 0)
      GTEST_SKIP() << "this kernel has no Landlock";
    if (GetParam() == Walls::kBubblewrap && cell::find_bubblewrap().empty())
      GTEST_SKIP() << "no bubblewrap works here";
  }

  static pid_t start(const Folder& folder) {
    const std::string cache = "XDG_CACHE_HOME=" + folder.path("cache");
    const pid_t child = fork();
    if (child != 0) return child;
    if (GetParam() == Walls::kBubblewrap) cell::testing::have_no_landlock();
    const int nothing = open("/dev/null", O_RDWR);
    for (const int descriptor : {0, 1, 2}) dup2(nothing, descriptor);
    if (chdir(folder.path().c_str()) != 0) _exit(1);
    execl("/usr/bin/env", "env", cache.c_str(), MLAB_COMMAND, "run", "m.mdl", "--headless", "--proceed",
          GetParam() == Walls::kNone ? "--no-cell" : nullptr, nullptr);
    _exit(1);
  }

  // Kills the run as soon as a program of this name has computed for so long.
  static void kill_run_during(const std::string& name, double busy, const std::string& network) {
    const Folder folder;
    write_mission(folder, network, 1);
    const pid_t run = start(folder);
    pid_t worker = -1;
    const bool is_at_work = becomes_true(60.0, [&] {
      for (const pid_t one : descendants_of(run)) {
        const auto seen = look_at(one);
        if (seen && seen->name == name && seen->processor_time > busy) worker = one;
      }
      return worker > 0 || is_gone(run);
    });
    const std::vector<pid_t> all = descendants_of(run);
    kill(run, SIGKILL);
    waitpid(run, nullptr, 0);
    ASSERT_TRUE(is_at_work && worker > 0) << name << " never was at work";
    for (const pid_t one : all) {
      EXPECT_TRUE(becomes_true(2.0, [&] { return is_gone(one); })) << name << " goes on";
      if (!is_gone(one)) kill(one, SIGKILL);
    }
  }
};

INSTANTIATE_TEST_SUITE_P(All, Outliving,
                         ::testing::Values(Walls::kLandlock, Walls::kBubblewrap, Walls::kNone),
                         [](const auto& each) {
                           return each.param == Walls::kLandlock     ? "Landlock"
                                  : each.param == Walls::kBubblewrap ? "Bubblewrap"
                                                                     : "None";
                         });

TEST_P(Outliving, ALoopInAProcedureEndsWithTheRun) {
  kill_run_during("mlab-robots", 0.2, network_that("for (;;) asm volatile(\"\");"));
}

TEST_P(Outliving, TheCompilerEndsWithTheRunAndAllThatItStarted) {
  kill_run_during("cc1plus", 0.2,
                  network_that("output.x = Many<24, 0>::kValue;",
                               "template <int kDepth, int kPlace> struct Many {\n"
                               "  static constexpr int kValue = Many<kDepth - 1, 2 * kPlace>::kValue + "
                               "Many<kDepth - 1, 2 * kPlace + 1>::kValue;\n};\n"
                               "template <int kPlace> struct Many<0, kPlace> { static constexpr int kValue = "
                               "1; };"));
}

}  // namespace
}  // namespace mlab::brought_code
