#include "mlab/cell/cell.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "mlab/cell/landlock.h"
#include "mlab/cell/testing/poorer_kernel.h"

namespace mlab::cell {
namespace {

namespace fs = std::filesystem;
using testing::have_no_landlock;
using testing::have_no_namespaces;

constexpr uid_t kNobody = 65534;
constexpr int kRefused = 10;  // what cell_attack says
constexpr int kNotMade = 99;  // there was no cell

/// What a child was before it made its cell.
enum class Who { kAsWeAre, kAsNobody };

/// A folder with a secret, a process that is not the attacker's, and the attacker.
class CellTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string test = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    std::ranges::replace(test, '/', '_');  // of its parameter
    folder_ = fs::canonical(fs::path(::testing::TempDir())) /
              ("mlab_cell_" + std::to_string(getpid()) + "_" + test);
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    for (const char* name : {"secret", "gone", "moved", "cut"}) std::ofstream(folder_ / name) << "secret\n";
    fs::create_symlink(folder_ / "secret", folder_ / "link");
    // Beside the secrets, as mlab's own programs lie beside other files.
    program_ = folder_ / "program";
    fs::copy_file(MLAB_CELL_ATTACK, program_);
    listen_there();
    victim_ = fork();
    if (victim_ == 0) {
      if (getuid() == 0 && (setgid(kNobody) != 0 || setuid(kNobody) != 0)) _exit(1);
      prctl(PR_SET_DUMPABLE, 1);
      for (;;) pause();
    }
  }
  void TearDown() override {
    kill(victim_, SIGKILL);
    waitpid(victim_, nullptr, 0);
    close(listening_);
    fs::remove_all(folder_);
    fs::remove("/dev/shm/mlab_cell_attack");
  }

  // For `unix_socket`.
  void listen_there() {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    const std::string path = (folder_ / "socket").string();
    ASSERT_LT(path.size(), sizeof address.sun_path);
    std::strncpy(address.sun_path, path.c_str(), sizeof address.sun_path - 1);
    listening_ = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    ASSERT_EQ(bind(listening_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
    ASSERT_EQ(listen(listening_, 100), 0);
  }

  // nobody gets the folder as its own, so that the files are what keeps it out of nothing.
  void give_to(Who who) const {
    if (who != Who::kAsNobody) return;
    ASSERT_EQ(chown(folder_.c_str(), kNobody, kNobody), 0);
    for (const auto& entry : fs::directory_iterator(folder_)) {
      ASSERT_EQ(lchown(entry.path().c_str(), kNobody, kNobody), 0);
    }
  }

  Program program(const std::string& attack) const {
    return {program_.string(), {attack, folder_.string(), std::to_string(victim_)}, {"LC_ALL=C"}, 4};
  }

  /// Runs the attack in a process of its own, that first becomes `who` and has `before` done to it. Without a
  /// wall: as any program runs.
  /// @return  the exit status; 128 and more: the signal
  int run(const std::string& attack, std::optional<Wall> wall, Who who,
          const std::function<void()>& before = {}, const std::function<void(Policy&)>& change = {}) {
    const pid_t stage = fork();
    if (stage == 0) {
      if (who == Who::kAsNobody && (setgid(kNobody) != 0 || setuid(kNobody) != 0)) _exit(98);
      prctl(PR_SET_DUMPABLE, 1);
      if (before) before();
      _exit(run_here(attack, wall, change));
    }
    int status = 0;
    while (waitpid(stage, &status, 0) < 0 && errno == EINTR) {
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

  int run_here(const std::string& attack, std::optional<Wall> wall,
               const std::function<void(Policy&)>& change) {
    Policy policy = policy_for(program_.string());
    if (change) change(policy);
    auto room = Cell::prepare(program(attack), policy, wall.value_or(Wall::kNone));
    if (!room) {
      std::fprintf(stderr, "%s\n", room.error().c_str());
      return kNotMade;
    }
    const int secret = open((folder_ / "secret").c_str(), O_RDONLY);
    dup2(secret, 200);  // somebody forgot to close it
    const pid_t child = fork();
    if (child == 0) {
      dup2(open("/dev/null", O_RDONLY), 0);
      if (shared_ >= 0) dup2(shared_, 3);
      dup2(open("/dev/null", O_WRONLY), 1);
      if (wall) {
        room->become();
        _exit(97);
      }
      const std::string name = program_.string();
      const std::string victim = std::to_string(victim_);
      execl(name.c_str(), name.c_str(), attack.c_str(), folder_.c_str(), victim.c_str(), nullptr);
      _exit(97);
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    status = ending_of(status, wall.value_or(Wall::kNone));
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

  std::vector<std::string> attacks() const {
    int ends[2];
    if (pipe(ends) != 0) return {};
    if (fork() == 0) {
      dup2(ends[1], 1);
      execl(program_.c_str(), program_.c_str(), "names", ".", "0", nullptr);
      _exit(97);
    }
    close(ends[1]);
    std::string text;
    char block[512];
    for (ssize_t count = 0; (count = read(ends[0], block, sizeof block)) > 0;)
      text.append(block, static_cast<std::size_t>(count));
    close(ends[0]);
    wait(nullptr);
    std::istringstream lines(text);
    std::vector<std::string> out;
    for (std::string line; std::getline(lines, line);) out.push_back(line);
    return out;
  }

  std::set<std::string> files() const {
    std::set<std::string> out;
    for (const auto& entry : fs::directory_iterator(folder_)) out.insert(entry.path().filename().string());
    return out;
  }

  // By another architecture's numbers: that is no mistake, and ends the program.
  static bool is_foreign(const std::string& attack) { return attack == "as_32_bits" || attack == "as_x32"; }
  // Some kernels don't know the other architecture; then the program ends without a cell, too.
  bool ends_it(const std::string& attack, int status) {
    return status == 128 + SIGSYS ||
           (status == 128 + SIGSEGV && run(attack, std::nullopt, Who::kAsWeAre) == status);
  }

  void expect_nothing_is_reached(Wall wall, Who who, const std::function<void()>& before = {}) {
    give_to(who);
    const std::vector<std::string> all = attacks();
    EXPECT_GE(all.size(), 60U);
    const std::set<std::string> files_before = files();
    const auto changed = fs::last_write_time(folder_ / "secret");
    for (const std::string& attack : all) {
      const int status = run(attack, wall, who, before);
      EXPECT_TRUE(status == kRefused || (is_foreign(attack) && ends_it(attack, status)))
          << attack << ": " << status;
    }
    EXPECT_EQ(files(), files_before);
    EXPECT_EQ(fs::last_write_time(folder_ / "secret"), changed);
    EXPECT_EQ(kill(victim_, 0), 0);
  }

  fs::path folder_;
  fs::path program_;
  pid_t victim_ = -1;
  int listening_ = -1;
  int shared_ = -1;
};

bool is_root() {
  return getuid() == 0;
}

#define NEEDS_LANDLOCK() \
  if (landlock_version() == 0) GTEST_SKIP() << "this kernel has no Landlock"
#define NEEDS_BUBBLEWRAP() \
  if (find_bubblewrap().empty()) GTEST_SKIP() << "no bubblewrap works here"
#define NEEDS_ROOT() \
  if (!is_root()) GTEST_SKIP() << "only root may become nobody"

// The proof that the attacks bite: what no wall keeps from them, they do.
TEST_F(CellTest, OutsideOfACellTheAttacksSucceed) {
  std::set<std::string> sometimes;  // refused to some users, by some kernels, in some containers
  for (const char* name :
       {"own_namespace", "io_uring", "userfault", "bpf", "performance", "keys", "as_32_bits", "as_x32",
        "internet_6", "attribute", "terminal", "message_queue", "niceness"})
    sometimes.insert(name);
  if (!is_root()) {
    for (const char* name :
         {"mount", "change_root", "make_device", "trace", "peek", "kill", "kill_thread", "queue_signal",
          "process_descriptor", "limit_another", "read_memory_of_another", "read_environment_of_another"})
      sometimes.insert(name);
  }
  for (const std::string& attack : attacks()) {
    // The victim is nobody's, and some may do to their own what not even root may do to others.
    const int status = run(attack, std::nullopt, Who::kAsWeAre);
    if (status == 0 || (is_root() && run(attack, std::nullopt, Who::kAsNobody) == 0)) continue;
    EXPECT_TRUE(sometimes.contains(attack)) << attack << ": " << status;
    std::printf("not possible here without a cell either: %s\n", attack.c_str());
  }
}

TEST_F(CellTest, BehindLandlockNothingIsReached) {
  NEEDS_LANDLOCK();
  expect_nothing_is_reached(Wall::kLandlock, Who::kAsWeAre);
}

TEST_F(CellTest, BehindLandlockNothingIsReachedByNobody) {
  NEEDS_LANDLOCK();
  NEEDS_ROOT();
  expect_nothing_is_reached(Wall::kLandlock, Who::kAsNobody);
}

TEST_F(CellTest, BehindLandlockNothingIsReachedWhereNamespacesAreRefused) {
  NEEDS_LANDLOCK();
  expect_nothing_is_reached(Wall::kLandlock, Who::kAsWeAre, have_no_namespaces);
}

TEST_F(CellTest, InBubblewrapNothingIsReached) {
  NEEDS_BUBBLEWRAP();
  expect_nothing_is_reached(Wall::kBubblewrap, Who::kAsWeAre, have_no_landlock);
}

TEST_F(CellTest, InBubblewrapNothingIsReachedByNobody) {
  NEEDS_BUBBLEWRAP();
  NEEDS_ROOT();
  expect_nothing_is_reached(Wall::kBubblewrap, Who::kAsNobody, have_no_landlock);
}

TEST_F(CellTest, AKernelWithoutLandlockIsSeenAndBubblewrapTried) {
  const bool has_bubblewrap = !find_bubblewrap().empty();
  const pid_t child = fork();
  if (child == 0) {
    have_no_landlock();
    const Means means = find_means();
    _exit(means.landlock == 0 && means.bubblewrap.empty() != has_bubblewrap ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
}

TEST_F(CellTest, ABubblewrapThatMayNotMakeNamespacesCountsAsNone) {
  NEEDS_BUBBLEWRAP();
  const pid_t child = fork();
  if (child == 0) {
    have_no_landlock();
    have_no_namespaces();
    const Means means = find_means();
    _exit(means.bubblewrap.empty() && !choose_wall(means) ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
}

// With bubblewrap the program is a child of the child, whose end comes through as it is.
class EveryWall : public CellTest, public ::testing::WithParamInterface<Wall> {
 protected:
  void SetUp() override {
    if (GetParam() == Wall::kLandlock) NEEDS_LANDLOCK();
    if (GetParam() == Wall::kBubblewrap) NEEDS_BUBBLEWRAP();
    CellTest::SetUp();
  }
  void TearDown() override {
    if (!IsSkipped()) CellTest::TearDown();
  }
  Who nobody() const { return is_root() ? Who::kAsNobody : Who::kAsWeAre; }
};

INSTANTIATE_TEST_SUITE_P(All, EveryWall, ::testing::Values(Wall::kLandlock, Wall::kBubblewrap, Wall::kNone),
                         [](const auto& each) {
                           return each.param == Wall::kLandlock     ? "Landlock"
                                  : each.param == Wall::kBubblewrap ? "Bubblewrap"
                                                                    : "None";
                         });

TEST_P(EveryWall, SharedMemoryTimePipesAndExceptionsWork) {
  shared_ = memfd_create("shared", MFD_CLOEXEC);
  ASSERT_EQ(ftruncate(shared_, 4096), 0);
  EXPECT_EQ(run("harmless", GetParam(), Who::kAsWeAre), 0);
  std::uint32_t word = 0;
  EXPECT_EQ(pread(shared_, &word, sizeof word, 0), static_cast<ssize_t>(sizeof word));
  EXPECT_EQ(word, 42U);
  close(std::exchange(shared_, -1));
}

TEST_P(EveryWall, TellsHowAProgramEnded) {
  EXPECT_EQ(run("abort", GetParam(), Who::kAsWeAre), 128 + SIGABRT);
  EXPECT_EQ(run("crash", GetParam(), Who::kAsWeAre), 128 + SIGSEGV);
  EXPECT_EQ(run("recurse", GetParam(), Who::kAsWeAre), 128 + SIGSEGV);
}

TEST_P(EveryWall, EndsWhatWorksTooLong) {
  if (GetParam() == Wall::kNone) return;
  const int status =
      run("loop", GetParam(), Who::kAsWeAre, {}, [](Policy& policy) { policy.processor_time = 1; });
  EXPECT_TRUE(status == 128 + SIGXCPU || status == 128 + SIGKILL) << status;
}

TEST_P(EveryWall, ChangesFilesInTheFoldersThatItIsGiven) {
  const auto give = [&](Policy& policy) {
    policy.writable = {folder_.string()};
    policy.may_start_processes = true;
  };
  EXPECT_EQ(run("write", GetParam(), Who::kAsWeAre, {}, give), 0);
  EXPECT_TRUE(fs::exists(folder_ / "made"));
  EXPECT_EQ(run("make_folder", GetParam(), Who::kAsWeAre, {}, give), 0);
  EXPECT_EQ(run("remove", GetParam(), Who::kAsWeAre, {}, give), 0);
  EXPECT_EQ(run("rename", GetParam(), Who::kAsWeAre, {}, give), 0);
  EXPECT_EQ(run("fork", GetParam(), Who::kAsWeAre, {}, give), 0);
}

TEST_P(EveryWall, HasThreadsOnlyWhereTheyAreGiven) {
  const auto give = [](Policy& policy) { policy.may_start_threads = true; };
  EXPECT_EQ(run("thread", GetParam(), Who::kAsWeAre, {}, give), 0);
  if (GetParam() == Wall::kNone) return;
  EXPECT_EQ(run("fork", GetParam(), Who::kAsWeAre, {}, give), kRefused);
  EXPECT_EQ(run("own_namespace", GetParam(), Who::kAsWeAre, {}, give), kRefused);
}

TEST_F(CellTest, AFolderThatMayBeReadMayNotBeChanged) {
  NEEDS_LANDLOCK();
  const auto give = [&](Policy& policy) {
    policy.readable.push_back(folder_.string());
    policy.may_start_processes = true;
  };
  EXPECT_EQ(run("read", Wall::kLandlock, Who::kAsWeAre, {}, give), 0);
  for (const char* attack :
       {"write", "append", "truncate", "truncate_by_opening", "remove", "rename", "mode", "owner", "times"}) {
    EXPECT_EQ(run(attack, Wall::kLandlock, Who::kAsWeAre, {}, give), kRefused) << attack;
  }
}

TEST_F(CellTest, AWritableFolderThatIsNotThereIsNamed) {
  NEEDS_LANDLOCK();
  Policy policy = policy_for(program_.string());
  policy.writable = {(folder_ / "nowhere").string()};
  const auto room = Cell::prepare(program("read"), policy, Wall::kLandlock);
  ASSERT_FALSE(room);
  EXPECT_NE(room.error().find("nowhere"), std::string::npos) << room.error();
}

TEST_F(CellTest, EveryVersionOfLandlockUpToThisOneMakesACell) {
  NEEDS_LANDLOCK();
  for (int version = 1; version <= landlock_version(); ++version) {
    const auto rules = landlock_rules(policy_for(program_.string()), version);
    ASSERT_TRUE(rules) << version << ": " << rules.error();
    close(*rules);
  }
}

}  // namespace
}  // namespace mlab::cell
