// Nothing of a test is left when it is killed in its midst.

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <sstream>
#include <thread>

#include <gtest/gtest.h>

#include "network/test_network.h"

namespace mlab::network {
namespace {

using namespace std::chrono_literals;

TEST(Survival, NothingIsLeftOfATestThatIsKilled) {
  MLAB_NEEDS_HOSTS();
  int ends[2] = {-1, -1};
  ASSERT_EQ(::pipe(ends), 0);
  const pid_t doomed = ::fork();
  if (doomed == 0) {
    ::dup2(ends[1], STDOUT_FILENO);
    ::execl(MLAB_NETWORK_DOOMED, MLAB_NETWORK_DOOMED, nullptr);
    ::_exit(127);
  }
  ::close(ends[1]);
  const Descriptor output(ends[0]);
  std::string text;
  char one = 0;
  while (text.find("all is there\n") == std::string::npos && ::read(output.number(), &one, 1) == 1)
    text += one;
  std::vector<std::string> namespaces;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("net:[")) namespaces.push_back(line);
  }
  const std::size_t descendants = descendants_of(doomed).size();
  ::kill(doomed, SIGKILL);
  ::waitpid(doomed, nullptr, 0);
  ASSERT_EQ(namespaces.size(), 2U) << text;
  EXPECT_GE(descendants, 2 * 5U);  // two keepers, two first processes, and three of its own on each host
  std::size_t left = 1;
  for (int i = 0; i < 1000 && left > 0; ++i) {
    left = 0;
    for (const std::string& name : namespaces) left += processes_in(name).size();
    std::this_thread::sleep_for(10ms);
  }
  EXPECT_EQ(left, 0U);
}

}  // namespace
}  // namespace mlab::network
