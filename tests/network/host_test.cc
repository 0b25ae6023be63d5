#include "network/host.h"

#include <unistd.h>

#include <fstream>
#include <iterator>
#include <thread>

#include <gtest/gtest.h>

#include "network/test_network.h"
#include "network/traces.h"

namespace mlab::network {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

class HostTest : public testing::Test {
 protected:
  void SetUp() override { MLAB_NEEDS_HOSTS(); }

  static std::string said(Process process) {
    const auto ending = process.wait(20s);
    EXPECT_TRUE(ending && ending->is_success()) << process.errors();
    return process.output();
  }
};

TEST_F(HostTest, HasANameAndNumbersOfItsOwnAndKnowsTheOthers) {
  TestNetwork network({.hosts = {{"alpha"}, {"bravo"}}});
  EXPECT_EQ(said(network.host("bravo").start({"uname", "-n"})), "bravo\n");
  EXPECT_EQ(said(network.host("bravo").start({"getent", "ahostsv4", "alpha"})).substr(0, 10), "10.77.0.1 ");
  EXPECT_LT(std::stoi(said(network.host("bravo").start({"sh", "-c", "echo $$"}))), 100);
  Process nobody = network.host("bravo").start({"getent", "hosts", "stranger"});
  EXPECT_EQ(nobody.wait(10s)->status, 2) << nobody.errors();
  EXPECT_EQ(network.host("bravo").address(), "10.77.0.2");
}

TEST_F(HostTest, HasFilesOfItsOwnBesideThoseThatAreShared) {
  const fs::path shared =
      fs::path(testing::TempDir()) / ("mlab_network_shared_" + std::to_string(::getpid()));
  fs::create_directories(shared);
  {
    TestNetwork network({.hosts = {{"alpha"}, {"bravo"}}, .shared = {shared}});
    said(network.host("alpha").start(
        {"sh", "-c", "echo mine > /tmp/own; echo ours > " + (shared / "file").string()}));
    // Where the project itself is there, hosts have to see it.
    const std::string own = fs::canonical("/proc/self/exe");
    const std::string project = own.starts_with("/tmp/") ? own.substr(5, own.find('/', 5) - 5) : "";
    const std::string others = project.empty() ? "" : " | grep -vx '" + project + "'";
    EXPECT_EQ(said(network.host("bravo").start(
                  {"sh", "-c", "ls /tmp" + others + "; cat " + (shared / "file").string()})),
              shared.filename().string() + "\nours\n");
    std::ifstream file(network.host("alpha").path("/tmp/own"));
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), "mine\n");
    EXPECT_FALSE(fs::exists("/tmp/own"));
    EXPECT_EQ(network.leftovers(), std::vector<std::string>{"alpha: /tmp/own"});
  }
  fs::remove_all(shared);
}

TEST_F(HostTest, NamesWhatIsLeftBehind) {
  TestNetwork network({.hosts = {{"alpha"}}});
  Host& host = network.host("alpha");
  const Process there = host.start({MLAB_NETWORK_TALK, "spawn"});
  ASSERT_TRUE(there.prints("ready", 10s));
  EXPECT_TRUE(host.leftovers().empty()) << host.leftovers().front();
  Process litter = host.start({MLAB_NETWORK_TALK, "litter", "/dev/shm/segment", "/tmp/file"});
  ASSERT_TRUE(litter.wait(10s));
  const std::vector<std::string> left = host.leftovers();
  ASSERT_EQ(left.size(), 3U);
  EXPECT_EQ(left[0], "alpha: /dev/shm/segment");
  EXPECT_EQ(left[1], "alpha: /tmp/file");
  EXPECT_TRUE(left[2].starts_with("alpha: process ") &&
              left[2].ends_with("litter /dev/shm/segment /tmp/file"))
      << left[2];
}

TEST_F(HostTest, ASmallDiskIsFullAtItsSize) {
  TestNetwork network({.hosts = {{"alpha"}}});
  Host& host = network.host("alpha");
  EXPECT_EQ(host.mount_disk("/tmp/state/disk", 65'536), "");
  EXPECT_EQ(said(host.start({MLAB_NETWORK_TALK, "fill", "/tmp/state/disk"})), "65536 ENOSPC\n");
  fs::remove(host.path("/tmp/state/disk/file"));
  EXPECT_EQ(said(host.start({MLAB_NETWORK_TALK, "fill", "/tmp/state/disk"})), "65536 ENOSPC\n");
  EXPECT_NE(host.mount_disk("/proc/no/such", 65'536), "");
}

TEST_F(HostTest, LosesAllButSharedFilesWithItsPower) {
  TestNetwork network({.hosts = {{"alpha"}, {"bravo"}}});
  Host& alpha = network.host("alpha");
  Process gone = alpha.start({"sh", "-c", "echo > /tmp/file; echo ready; exec sleep 1000"});
  ASSERT_TRUE(gone.prints("ready", 10s));
  alpha.power_off();
  EXPECT_EQ(gone.wait(10s)->words(), "went with its host");
  EXPECT_TRUE(processes_in(alpha.network_namespace()).empty());
  Process nowhere = network.host("bravo").start({MLAB_NETWORK_TALK, "ask", "alpha", "4000", "1", "200"});
  EXPECT_TRUE(said(std::move(nowhere)).starts_with("0 "));
  EXPECT_EQ(alpha.start({"true"}).errors(), "the host is off\n");
  alpha.power_on();
  EXPECT_TRUE(alpha.leftovers().empty());
  const Process echo = alpha.start({MLAB_NETWORK_TALK, "echo", "4000"});
  ASSERT_TRUE(echo.prints("ready", 10s));
  EXPECT_TRUE(
      said(network.host("bravo").start({MLAB_NETWORK_TALK, "ask", "alpha", "4000", "3"})).starts_with("3 "));
}

TEST_F(HostTest, LeavesNothingBehind) {
  const fs::path folder =
      fs::path(testing::TempDir()) / ("mlab_network_traces_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  why_no_hosts();  // the thread that forks stays
  const Traces traces({folder});
  std::string network_namespace;
  {
    TestNetwork network({.hosts = {{"alpha"}}});
    network_namespace = network.host("alpha").network_namespace();
    EXPECT_FALSE(processes_in(network_namespace).empty());
    const Process process = network.host("alpha").start({MLAB_NETWORK_TALK, "spawn"});
    EXPECT_GT(traces.left().size(), 2U);
  }
  EXPECT_TRUE(processes_in(network_namespace).empty());
  EXPECT_TRUE(traces.left().empty()) << traces.left().front();
  std::ofstream(folder / "file") << "left";
  EXPECT_EQ(traces.left(), std::vector<std::string>{"file " + (folder / "file").string()});
  fs::remove_all(folder);
}

TEST_F(HostTest, SaysWhyOneCantBeMade) {
  EXPECT_THROW(TestNetwork({.hosts = {{"alpha"}}, .shared = {"/tmp/no such folder"}}), std::runtime_error);
  try {
    const TestNetwork network({.hosts = {{"alpha"}}, .shared = {"/tmp/no such folder"}});
  } catch (const std::runtime_error& failure) {
    EXPECT_STREQ(failure.what(), "sharing /tmp/no such folder: No such file or directory");
  }
}

}  // namespace
}  // namespace mlab::network
