#include "mlab/cell/tied_fork.h"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <thread>

#include <gtest/gtest.h>

namespace mlab::cell {
namespace {

void pause_for_ever() {
  for (;;) pause();
}

TEST(TiedFork, TheChildOutlivesTheThreadThatAskedForIt) {
  pid_t child = -1;
  std::thread([&] { child = tied_fork(pause_for_ever); }).join();
  ASSERT_GT(child, 0);
  usleep(50'000);
  EXPECT_EQ(waitpid(child, nullptr, WNOHANG), 0) << "it goes on";
  kill(child, SIGKILL);
  EXPECT_EQ(waitpid(child, nullptr, 0), child);
}

TEST(TiedFork, TheChildEndsWithTheProcess) {
  // Children whose parent is gone become children of this process, which can ask after them.
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const pid_t middle = fork();
  if (middle == 0) {
    const pid_t child = tied_fork(pause_for_ever);
    _exit(write(ends[1], &child, sizeof child) == sizeof child ? 0 : 1);
  }
  waitpid(middle, nullptr, 0);
  pid_t child = -1;
  ASSERT_EQ(read(ends[0], &child, sizeof child), static_cast<ssize_t>(sizeof child));
  close(ends[0]);
  close(ends[1]);
  ASSERT_GT(child, 0);
  int status = 0;
  EXPECT_EQ(waitpid(child, &status, 0), child);
  // Killed, or gone by itself where its process had ended before the kernel was told of the tie.
  const bool is_killed = WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL;
  const bool has_left = WIFEXITED(status) && WEXITSTATUS(status) == 127;
  EXPECT_TRUE(is_killed || has_left) << status;
  prctl(PR_SET_CHILD_SUBREAPER, 0);
}

}  // namespace
}  // namespace mlab::cell
