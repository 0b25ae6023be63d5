#include "mlab/agents/stop_state.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace mlab::agents {
namespace {

std::vector<std::uint64_t> ids(const std::vector<Pull>& pulls) {
  std::vector<std::uint64_t> out;
  for (const Pull& one : pulls) out.push_back(one.id);
  std::ranges::sort(out);
  return out;
}

bool is_same(const StopState& a, const StopState& b) {
  return ids(a.standing) == ids(b.standing) && ids(a.released) == ids(b.released);
}

StopState joined(StopState a, const StopState& b) {
  a.learn(b);
  return a;
}

// What it is after the way to somebody else.
StopState said(const StopState& state) {
  wire::EmergencyStop message;
  encode(state, message);
  return decode(message).value();
}

// An agent of a version that knows of one pull, and goes by numbers.
struct OldAgent {
  wire::EmergencyStop knows;
  void hear(const StopState& state) {
    wire::EmergencyStop heard;
    encode(state, heard);
    heard.clear_standing();
    heard.clear_released();
    if (heard.number() > knows.number() ||
        (heard.number() == knows.number() && heard.is_engaged() && !knows.is_engaged()))
      knows = heard;
  }
};

// What several know who pull, release, hear each other, and forget all when they are started again, in any
// order; and which pulls were released by somebody who knew of them.
struct Histories {
  std::vector<StopState> all = std::vector<StopState>(4);
  std::set<std::uint64_t> pulled_ids;
  std::set<std::uint64_t> released_ids;

  void step() {
    const auto who = *rc::gen::inRange<std::size_t>(0, all.size());
    const auto other = *rc::gen::inRange<std::size_t>(0, all.size());
    switch (*rc::gen::inRange(0, 8)) {
      case 0:
        all[who] = pulled(all[who], "anna");
        pulled_ids.insert(all[who].standing.back().id);
        break;
      case 1:
        for (const Pull& one : all[who].standing) released_ids.insert(one.id);
        all[who] = released(all[who], "ben");
        break;
      case 2:
        if (!all[who].is_engaged()) all[who] = {};  // what stands is on the disk
        break;
      default:
        all[who].learn(said(all[other]));
    }
  }
  void let_all_hear_all() {
    for (std::size_t round = 0; round < 2; ++round) {
      for (StopState& one : all) {
        for (const StopState& other : all) one.learn(said(other));
      }
    }
  }
};

RC_GTEST_PROP(StopState, IsReleasedOnlyByWhoKnewOfIt, ()) {
  Histories histories;
  const int count = *rc::gen::inRange(1, 25);
  for (int i = 0; i < count; ++i) histories.step();
  histories.let_all_hear_all();
  std::set<std::uint64_t> left;
  for (const std::uint64_t one : histories.pulled_ids) {
    if (!histories.released_ids.contains(one)) left.insert(one);
  }
  for (const StopState& one : histories.all) {
    RC_ASSERT(is_same(one, histories.all.front()));
    // A release that all have forgotten releases nothing any more.
    for (const std::uint64_t id : left) RC_ASSERT(std::ranges::count(ids(one.standing), id) == 1);
  }
}

RC_GTEST_PROP(StopState, IsTheSameInWhateverOrderItIsHeardOf, ()) {
  Histories histories;
  const int count = *rc::gen::inRange(1, 25);
  for (int i = 0; i < count; ++i) histories.step();
  const StopState& a = histories.all[0];
  const StopState& b = histories.all[1];
  const StopState& c = histories.all[2];
  RC_ASSERT(is_same(joined(a, b), joined(b, a)));
  RC_ASSERT(is_same(joined(joined(a, b), c), joined(a, joined(b, c))));
  RC_ASSERT(joined(a, a).learn(a) == Learnt::kNothing);
}

RC_GTEST_PROP(StopState, IsFollowedByOlderAgents, ()) {
  Histories histories;
  OldAgent old;
  const int count = *rc::gen::inRange(1, 25);
  for (int i = 0; i < count; ++i) {
    histories.step();
    old.hear(histories.all[0]);
  }
  StopState& here = histories.all[0];
  here.learn(decode(old.knows).value());
  old.hear(here);
  RC_ASSERT(old.knows.is_engaged() == here.is_engaged());
  RC_ASSERT(here.number == 0 || has_confirmed(old.knows, here));
}

TEST(StopState, APullAndItsReleaseAreLearnt) {
  const StopState pull = pulled({}, "anna");
  EXPECT_TRUE(pull.is_engaged());
  StopState other;
  EXPECT_EQ(other.learn(said(pull)), Learnt::kStop);
  EXPECT_EQ(other.by(), "anna");
  const StopState release = released(pull, "ben");
  EXPECT_EQ(other.learn(said(release)), Learnt::kSomething);
  EXPECT_FALSE(other.is_engaged());
  EXPECT_EQ(other.by(), "ben");
  EXPECT_EQ(other.learn(said(pull)), Learnt::kNothing) << "who has not heard of the release";
  EXPECT_FALSE(other.is_engaged());
}

TEST(StopState, AnOldReleaseDoesNotReleaseANewPull) {
  const StopState long_over = released(pulled({}, "anna"), "anna");
  StopState here = pulled({}, "ben");  // where the old one was forgotten, and so its number
  EXPECT_LT(here.number, long_over.number);
  EXPECT_EQ(here.learn(said(long_over)), Learnt::kSomething);
  EXPECT_TRUE(here.is_engaged());
  StopState there = long_over;
  EXPECT_EQ(there.learn(said(here)), Learnt::kStop);
  EXPECT_EQ(there.by(), "ben");
}

TEST(StopState, APullThatAReleaseDidNotKnowOfStands) {
  const StopState first = pulled({}, "anna");
  StopState second = pulled(first, "ben");
  EXPECT_EQ(second.learn(said(released(first, "cleo"))), Learnt::kSomething);
  EXPECT_TRUE(second.is_engaged());
  EXPECT_FALSE(released(second, "cleo").is_engaged());
}

TEST(StopState, AnOldReleaseOfAnOlderAgentDoesNotReleaseANewPull) {
  wire::EmergencyStop old;
  old.set_number(2);
  old.set_pull(7);
  old.set_by("anna");
  StopState here = pulled({}, "ben");
  here.learn(decode(old).value());
  EXPECT_TRUE(here.is_engaged());
  EXPECT_GT(here.number, 2U) << "so that it stops the older agent";
  EXPECT_FALSE(has_confirmed(old, here));
}

TEST(StopState, IsConfirmedByWhoKnowsOfAllThatStands) {
  const StopState first = pulled({}, "anna");
  const StopState both = pulled(first, "ben");
  wire::EmergencyStop there;
  EXPECT_FALSE(has_confirmed(there, first));
  encode(first, there);
  EXPECT_TRUE(has_confirmed(there, first));
  EXPECT_FALSE(has_confirmed(there, both));
  EXPECT_FALSE(has_confirmed(there, released(both, "ben")));
}

TEST(StopState, GrowsNoFurtherAndForgetsTheOldest) {
  StopState state;
  for (std::size_t i = 0; i < 3 * kMostPulls; ++i) state = pulled(state, "anna");
  const std::uint64_t newest = state.standing.back().id;
  EXPECT_EQ(state.standing.size(), kMostPulls);
  EXPECT_EQ(state.learn(said(state)), Learnt::kNothing);
  state = released(state, "ben");
  EXPECT_EQ(state.released.size(), kMostPulls);
  EXPECT_EQ(std::ranges::count(ids(state.released), newest), 1);
}

TEST(StopState, IsEngagedWhateverNumbersAStrangerSays) {
  wire::EmergencyStop high;
  high.set_number(std::uint64_t{1} << 62);
  StopState here;
  here.learn(decode(high).value());
  here = pulled(here, "anna");
  StopState there = decode(high).value();
  EXPECT_EQ(there.learn(said(here)), Learnt::kStop);
}

TEST(StopFile, IsRemovedWhereItIsWantedNoMore) {
  const std::string path =
      (std::filesystem::temp_directory_path() / ("mlab-stop-removed-" + std::to_string(::getpid()))).string();
  const StopFile file(path);
  file.remove();
  ASSERT_EQ(file.write(pulled({}, "anna")), std::nullopt);
  file.remove();
  EXPECT_FALSE(std::filesystem::exists(path));
  EXPECT_EQ(file.read().number, 0U);
  StopFile("").remove();
}

TEST(StopState, NonsenseIsNotTaken) {
  EXPECT_FALSE(decode("\xff\xff"));
  wire::EmergencyStop message;
  message.set_number(std::numeric_limits<std::uint64_t>::max());
  EXPECT_FALSE(decode(message)) << "no next one would be left";
  message.set_number(0);
  message.set_is_engaged(true);
  EXPECT_FALSE(decode(message));
  message.set_number(1);
  message.set_by("a\x1b[31m");
  const auto state = decode(message.SerializeAsString());
  ASSERT_TRUE(state);
  EXPECT_EQ(state->by().find('\x1b'), std::string::npos);
}

class StopFiles : public ::testing::Test {
 protected:
  void SetUp() override { std::filesystem::remove_all(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string path() const { return (folder_ / "alpha" / "north.stop").string(); }

 private:
  std::filesystem::path folder_ =
      std::filesystem::path(::testing::TempDir()) / ("mlab_stop_file_" + std::to_string(::getpid()));
};

TEST_F(StopFiles, KeepWhatWasWrittenLast) {
  const StopFile file(path());
  EXPECT_FALSE(file.read().is_engaged()) << "there has been none";
  EXPECT_EQ(file.write(pulled({}, "anna")), std::nullopt);
  EXPECT_TRUE(StopFile(path()).read().is_engaged());
  EXPECT_EQ(StopFile(path()).read().by(), "anna");
  EXPECT_EQ(file.write(released(file.read(), "ben")), std::nullopt);
  EXPECT_FALSE(StopFile(path()).read().is_engaged());
  EXPECT_EQ(StopFile(path()).read().number, 2U);
}

TEST_F(StopFiles, ThatCannotBeReadStopAMachine) {
  const StopFile file(path());
  ASSERT_EQ(file.write(pulled({}, "anna")), std::nullopt);
  for (const char* const broken : {"", "\xff", "no message"}) {
    std::ofstream(path(), std::ios::trunc) << broken;
    EXPECT_TRUE(file.read().is_engaged()) << broken;
    EXPECT_NE(file.read().by().find("can't be read"), std::string::npos);
  }
}

TEST_F(StopFiles, ThatCannotBeReadAreNotReleasedByWhatWasReleasedBefore) {
  const StopFile file(path());
  ASSERT_EQ(file.write(pulled({}, "anna")), std::nullopt);
  const StopState long_over = released(file.read(), "anna");
  std::ofstream(path(), std::ios::trunc) << "garbage";
  StopState here = file.read();
  here.learn(long_over);
  here.learn(released(file.read(), "ben"));
  EXPECT_TRUE(here.is_engaged());
  EXPECT_FALSE(released(here, "cleo").is_engaged());
}

TEST_F(StopFiles, OfOlderAgentsAreRead) {
  wire::EmergencyStop old;
  old.set_number(3);
  old.set_is_engaged(true);
  old.set_by("anna");
  old.set_pull(7);
  ASSERT_EQ(StopFile(path()).write({}), std::nullopt);  // makes the folder
  std::ofstream(path(), std::ios::trunc) << old.SerializeAsString();
  const StopState read = StopFile(path()).read();
  EXPECT_EQ(ids(read.standing), std::vector<std::uint64_t>{7});
  EXPECT_EQ(read.by(), "anna");
  old.clear_pull();
  std::ofstream(path(), std::ios::trunc) << old.SerializeAsString();
  EXPECT_NE(StopFile(path()).read().standing.at(0).id, 0U) << "of no other one that nobody knew";
}

TEST_F(StopFiles, ThatAreNoFilesStopAMachine) {
  std::filesystem::create_directories(path());
  EXPECT_TRUE(StopFile(path()).read().is_engaged());
  std::filesystem::remove_all(path());
  std::filesystem::create_symlink("nowhere", path());
  EXPECT_TRUE(StopFile(path()).read().is_engaged()) << "it leads to where it was";
}

TEST_F(StopFiles, ThatCannotBeWrittenSaySo) {
  ASSERT_EQ(StopFile(path()).write(pulled({}, "anna")), std::nullopt);
  const auto problem = StopFile(path() + "/below").write(pulled({}, "anna"));
  ASSERT_TRUE(problem);
  EXPECT_NE(problem->find("can't be written"), std::string::npos);
  EXPECT_TRUE(StopFile("").write(pulled({}, "anna"))) << "there is no place for it";
}

// As on a disk that is full: no file takes a byte.
class FullDisk {
 public:
  FullDisk() {
    EXPECT_EQ(::getrlimit(RLIMIT_FSIZE, &before_), 0);
    const rlimit none{0, before_.rlim_max};
    EXPECT_EQ(::setrlimit(RLIMIT_FSIZE, &none), 0);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  void (*handler_)(int) = std::signal(SIGXFSZ, SIG_IGN);
  rlimit before_{};
};

TEST_F(StopFiles, OnAFullDiskSaySoBeforeAndLeaveWhatWasThere) {
  const StopFile file(path());
  EXPECT_EQ(file.why_not_kept(), std::nullopt);
  ASSERT_EQ(file.write(pulled({}, "anna")), std::nullopt);
  std::optional<std::string> before;
  std::optional<std::string> problem;
  {
    const FullDisk full;
    before = file.why_not_kept();
    problem = file.write(released(file.read(), "ben"));
  }
  ASSERT_TRUE(before && problem);
  EXPECT_NE(before->find("can't be written"), std::string::npos) << *before;
  EXPECT_NE(problem->find("can't be written"), std::string::npos) << *problem;
  EXPECT_EQ(file.read().by(), "anna");
  EXPECT_FALSE(std::filesystem::exists(path() + ".new"));
  EXPECT_EQ(file.why_not_kept(), std::nullopt);
  EXPECT_FALSE(std::filesystem::exists(path() + ".new"));
}

}  // namespace
}  // namespace mlab::agents
