#include "mlab/agents/stop_state.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace mlab::agents {
namespace {

StopState any_state() {
  const auto number = *rc::gen::inRange<std::uint64_t>(1, 5);
  const bool is_engaged = *rc::gen::arbitrary<bool>();
  return {number, is_engaged, "somebody", *rc::gen::inRange<std::uint64_t>(1, 4)};
}

// What somebody believes who has heard of these, in this order.
StopState believed(const std::vector<StopState>& heard) {
  StopState out;
  for (const StopState& one : heard) {
    if (one.overrides(out)) out = one;
  }
  return out;
}

RC_GTEST_PROP(StopState, WhoeverHearsTheSameComesToBelieveTheSame, ()) {
  std::vector<StopState> heard;
  const int count = *rc::gen::inRange(1, 8);
  for (int i = 0; i < count; ++i) heard.push_back(any_state());
  const StopState first = believed(heard);
  std::ranges::reverse(heard);
  const StopState second = believed(heard);
  RC_ASSERT(first.number == second.number);
  RC_ASSERT(first.is_engaged == second.is_engaged);
  RC_ASSERT(!first.is_engaged || first.pull == second.pull);
}

TEST(StopState, APullAndItsReleaseOverrideWhatWasBefore) {
  const StopState pull = pulled({}, "anna");
  EXPECT_TRUE(pull.overrides({}));
  EXPECT_TRUE(pull.is_engaged);
  const StopState release = released(pull, "ben");
  EXPECT_TRUE(release.overrides(pull));
  EXPECT_FALSE(pull.overrides(release));
  EXPECT_EQ(release.pull, pull.pull);
  const StopState again = pulled({release.number - 1, false, "", 0}, "cleo");
  EXPECT_EQ(again.number, release.number);
  EXPECT_TRUE(again.overrides(release)) << "of two at once, the one that stops";
  EXPECT_NE(again.pull, pull.pull);
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
  EXPECT_EQ(state->by.find('\x1b'), std::string::npos);
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
  EXPECT_FALSE(file.read().is_engaged) << "there has been none";
  EXPECT_EQ(file.write(pulled({}, "anna")), std::nullopt);
  EXPECT_TRUE(StopFile(path()).read().is_engaged);
  EXPECT_EQ(StopFile(path()).read().by, "anna");
  EXPECT_EQ(file.write(released(file.read(), "ben")), std::nullopt);
  EXPECT_FALSE(StopFile(path()).read().is_engaged);
  EXPECT_EQ(StopFile(path()).read().number, 2U);
}

TEST_F(StopFiles, ThatCannotBeReadStopAMachine) {
  const StopFile file(path());
  ASSERT_EQ(file.write(pulled({}, "anna")), std::nullopt);
  for (const char* const broken : {"", "\xff", "no message"}) {
    std::ofstream(path(), std::ios::trunc) << broken;
    EXPECT_TRUE(file.read().is_engaged) << broken;
    EXPECT_NE(file.read().by.find("can't be read"), std::string::npos);
  }
}

TEST_F(StopFiles, ThatAreNoFilesStopAMachine) {
  std::filesystem::create_directories(path());
  EXPECT_TRUE(StopFile(path()).read().is_engaged);
  std::filesystem::remove_all(path());
  std::filesystem::create_symlink("nowhere", path());
  EXPECT_TRUE(StopFile(path()).read().is_engaged) << "it leads to where it was";
}

TEST_F(StopFiles, ThatCannotBeWrittenSaySo) {
  ASSERT_EQ(StopFile(path()).write(pulled({}, "anna")), std::nullopt);
  const auto problem = StopFile(path() + "/below").write(pulled({}, "anna"));
  ASSERT_TRUE(problem);
  EXPECT_NE(problem->find("can't be written"), std::string::npos);
  EXPECT_EQ(StopFile("").write(pulled({}, "anna")), std::nullopt) << "nobody wants it to be kept";
}

}  // namespace
}  // namespace mlab::agents
