#include "mlab/robot/host/robot_program_process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "mlab/robot/host/testing/without_cell.h"

namespace mlab::robot_host {
namespace {

namespace fs = std::filesystem;

/// Executables that are no robot programs, each in its own way.
class RobotProgramProcessTest : public ::testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  std::string script(const std::string& lines) const {
    const fs::path path = folder_ / "program";
    std::ofstream(path) << "#!/bin/sh\n" << lines << "\n";
    fs::permissions(path, fs::perms::owner_all);
    return path.string();
  }
  static std::string failure_of(const std::string& executable, double patience = 5.0) {
    const auto process = RobotProgramProcess::start(testing::without_cell(executable), {patience, patience});
    return process ? "none" : process.error();
  }

  fs::path folder_ =
      fs::path(::testing::TempDir()) / ("mlab_robot_program_process_test" + std::to_string(::getpid()));
};

TEST_F(RobotProgramProcessTest, TellsWhyAProgramCannotBeStarted) {
  EXPECT_EQ(failure_of((folder_ / "missing").string()), "can't be started: No such file or directory");
  std::ofstream(folder_ / "data") << "no program";
  fs::permissions(folder_ / "data", fs::perms::owner_all);
  EXPECT_EQ(failure_of((folder_ / "data").string()), "can't be started: Exec format error");
}

TEST_F(RobotProgramProcessTest, TellsHowAProgramEndedAndItsLastWords) {
  EXPECT_EQ(failure_of(script("echo first >&2; echo no battery >&2; exit 3")),
            "ended with exit status 3, saying: no battery");
  EXPECT_EQ(failure_of(script("kill -SEGV $$")), "ended with signal 11 (Segmentation fault)");
  EXPECT_EQ(failure_of("/bin/true"), "ended with exit status 0");
}

TEST_F(RobotProgramProcessTest, EndsAProgramThatHangsWithAllThatItStarted) {
  const auto began = Clock::now();
  EXPECT_EQ(failure_of(script("sleep 100 & sleep 100"), 0.1), "gave no answer for 0.1 s");
  EXPECT_LT(Clock::now() - began, std::chrono::seconds(20));
}

// Who reads the pipe sees its end once nobody holds the other one any more.
TEST_F(RobotProgramProcessTest, LeavesNothingThatTheProgramStarted) {
  const fs::path pipe = folder_ / "held";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const int held = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  ASSERT_GE(held, 0);
  failure_of(script("sleep 100 > '" + pipe.string() + "' & sleep 100"), 0.5);
  const auto latest = Clock::now() + std::chrono::seconds(10);
  char byte = 0;
  ssize_t count = -1;
  while ((count = ::read(held, &byte, 1)) < 0 && Clock::now() < latest) ::poll(nullptr, 0, 10);
  EXPECT_EQ(count, 0) << "what it started goes on";
  ::close(held);
}

TEST_F(RobotProgramProcessTest, TellsWhatIsNoMessage) {
  EXPECT_EQ(failure_of(script("echo hello, I am a robot; cat >/dev/null")),
            "writes something to its standard output that is no message of the robot protocol");
  EXPECT_EQ(failure_of(script("printf '\\002\\0\\0\\0\\377\\377'; cat >/dev/null")),
            "answers what is no message of the robot protocol");
  EXPECT_EQ(failure_of("/bin/cat"), "answers something else than it was asked");
  // It talks and talks.
  EXPECT_EQ(failure_of("/usr/bin/yes"),
            "writes something to its standard output that is no message of the robot protocol");
}

TEST_F(RobotProgramProcessTest, TellsThatAProgramIsOfAnotherVersion) {
  // Welcome { protocol: 9 }
  EXPECT_EQ(failure_of(script("printf '\\004\\0\\0\\0\\132\\002\\010\\011'; cat >/dev/null")),
            "speaks version 9 of the robot protocol, and this is version 1");
}

TEST_F(RobotProgramProcessTest, SaysWhatAProgramRefuses) {
  // Problem { text: "no" }
  EXPECT_EQ(failure_of(script("printf '\\007\\0\\0\\0\\202\\001\\004\\012\\002no'; cat >/dev/null")),
            "refuses a message: no");
}

}  // namespace
}  // namespace mlab::robot_host
