#include "network/process.h"

#include <csignal>
#include <thread>

#include <gtest/gtest.h>

#include "network/test_network.h"

namespace mlab::network {
namespace {

using namespace std::chrono_literals;

class ProcessTest : public testing::Test {
 protected:
  void SetUp() override {
    MLAB_NEEDS_HOSTS();
    network_ = std::make_unique<TestNetwork>(NetworkSetup{.hosts = {{"alpha"}}});
  }
  Host& host() const { return *network_->hosts().front(); }

  std::unique_ptr<TestNetwork> network_;
};

TEST_F(ProcessTest, SaysHowItEndedAndWhatItWrote) {
  Process process = host().start({"sh", "-c", "echo out; echo err >&2; exit 3"});
  const auto ending = process.wait(10s);
  ASSERT_TRUE(ending);
  EXPECT_EQ(ending->words(), "exit status 3");
  EXPECT_FALSE(ending->is_success());
  EXPECT_EQ(process.output(), "out\n");
  EXPECT_EQ(process.errors(), "err\n");
}

TEST_F(ProcessTest, OneThatCantBeStartedEndsWithTheReason) {
  Process process = host().start({"/no/such/program"});
  EXPECT_EQ(process.wait(0s)->words(), "exit status 127");
  EXPECT_EQ(process.errors(), "starting /no/such/program: No such file or directory\n");
  EXPECT_EQ(process.id(), -1);
}

TEST_F(ProcessTest, KeepsTheBeginningAndTheEndOfWhatIsLong) {
  Process process = host().start({MLAB_NETWORK_TALK, "chatter", "4000000"});
  EXPECT_EQ(process.wait(20s)->words(), "exit status 3");
  EXPECT_TRUE(process.output().ends_with("the end\n"));
  EXPECT_NE(process.output().find("bytes are left out here"), std::string::npos);
  EXPECT_LT(process.output().size(), 2'000'000U);
  EXPECT_LT(process.errors().size(), 2'000'000U);
}

TEST_F(ProcessTest, ReadsWhatItIsToldInItsFolderAndEnvironment) {
  // NOLINTNEXTLINE(concurrency-mt-unsafe): nobody else asks
  ::setenv("MLAB_TO_BE_REMOVED", "there", 1);
  Process process =
      host().start({"sh", "-c", "read line; echo $line $ADDED $MLAB_TO_BE_REMOVED; pwd; cat"},
                   {.environment = {{"ADDED", "plus"}, {"MLAB_TO_BE_REMOVED", ""}}, .folder = "/usr"});
  EXPECT_TRUE(process.write("word\n"));
  EXPECT_TRUE(process.prints("/usr\n", 10s));
  process.close_input();
  EXPECT_TRUE(process.wait(10s)->is_success());
  EXPECT_EQ(process.output(), "word plus\n/usr\n");
}

TEST_F(ProcessTest, WritingToOneThatHasEndedIsRefused) {
  Process process = host().start({"true"});
  ASSERT_TRUE(process.wait(10s));
  EXPECT_FALSE(process.write("word\n"));
}

TEST_F(ProcessTest, IsStoppedAndGoesOnAndIsKilled) {
  Process process = host().start({"sh", "-c", "while :; do echo tick; sleep 0.01; done"});
  ASSERT_TRUE(process.prints("tick", 10s));
  ASSERT_TRUE(process.signal(SIGSTOP));
  for (int i = 0; i < 500 && descendants_of(process.id()).size() > 0; ++i) std::this_thread::sleep_for(10ms);
  const std::string before = process.output();
  std::this_thread::sleep_for(100ms);
  EXPECT_EQ(process.output(), before);
  EXPECT_TRUE(process.is_running());
  process.signal(SIGCONT);
  for (int i = 0; i < 500 && process.output() == before; ++i) std::this_thread::sleep_for(10ms);
  EXPECT_NE(process.output(), before);
  process.signal(SIGKILL);
  EXPECT_EQ(process.wait(10s)->words(), "killed by SIGKILL");
  EXPECT_FALSE(process.signal(SIGCONT));
}

TEST_F(ProcessTest, TakesAllThatItStartedWithIt) {
  {
    const Process process = host().start({MLAB_NETWORK_TALK, "spawn"});
    ASSERT_TRUE(process.prints("ready", 10s));
    for (int i = 0; i < 500 && host().processes().size() < 3; ++i) std::this_thread::sleep_for(10ms);
    EXPECT_EQ(host().processes().size(), 3U);
  }
  for (int i = 0; i < 500 && !host().processes().empty(); ++i) std::this_thread::sleep_for(10ms);
  EXPECT_TRUE(host().processes().empty());
}

TEST_F(ProcessTest, ManyAtOnceEndAsTheyAreTold) {
  std::vector<Process> processes;
  for (int i = 0; i < 30; ++i)
    processes.push_back(host().start({"sh", "-c", "read x; exit " + std::to_string(i)}));
  for (Process& one : processes) one.write("go\n");
  for (int i = 0; i < 30; ++i) EXPECT_EQ(processes[static_cast<std::size_t>(i)].wait(20s)->status, i);
}

}  // namespace
}  // namespace mlab::network
