#include "mlab/preflight/store.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/preflight/testing/yard.h"

namespace mlab::preflight {
namespace {

namespace fs = std::filesystem;
using testing::checklist;
using testing::signature;

class Stored : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(::testing::TempDir()) /
              (std::string("preflight_") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  Store store() const { return Store(folder_.string()); }
  std::vector<fs::path> files() const {
    std::vector<fs::path> out;
    for (const auto& one : fs::directory_iterator(folder_)) out.push_back(one.path());
    return out;
  }

  fs::path folder_;
};

TEST_F(Stored, ChecklistsAreFoundAsLongAsTheyHold) {
  EXPECT_EQ(store().find(checklist(), 0.0).error(), "nobody has signed one for this mission yet");
  const SignedChecklist one = {checklist(), signature(100.0)};
  ASSERT_EQ(store().keep(one), "");
  const auto found = store().find(checklist(), 200.0);
  ASSERT_TRUE(found) << found.error();
  EXPECT_EQ(*found, one);
  EXPECT_EQ(store().find(checklist(), 100.0 + 2.0 * kHoldsFor).error(),
            "Ada signed it 120 minutes ago, and it holds for 60 minutes");
  EXPECT_EQ(files().size(), 1U);
}

TEST_F(Stored, ChecklistsAreOfOneText) {
  ASSERT_EQ(store().keep({checklist(), signature(100.0)}), "");
  Checklist other = checklist();
  other.digest = "0123456789abcdef";
  EXPECT_EQ(store().find(other, 200.0).error(),
            "the mission, or a file that it is made from, was changed since");
  ASSERT_EQ(store().keep({other, signature(150.0)}), "");
  EXPECT_TRUE(store().find(other, 200.0));
  EXPECT_TRUE(store().find(checklist(), 200.0)) << "the first text is still signed for";
  other.mission = "Another";
  EXPECT_EQ(store().find(other, 200.0).error(), "nobody has signed one for this mission yet");
}

TEST_F(Stored, ChecklistsAreOfOneProcessOfEachVehicle) {
  ASSERT_EQ(store().keep({checklist(), signature(100.0)}), "");
  auto facts = testing::both_well();
  facts[0].session = "veh-1 started twice";
  EXPECT_EQ(store().find(checklist(facts), 200.0).error(),
            "the process of the vehicle `veh-1` was started anew since");
}

TEST_F(Stored, ABrokenFileIsNamed) {
  ASSERT_EQ(store().keep({checklist(), signature(100.0)}), "");
  const fs::path file = files().front();
  fs::resize_file(file, fs::file_size(file) / 2);
  const auto found = store().find(checklist(), 200.0);
  ASSERT_FALSE(found);
  EXPECT_NE(found.error().find(file.filename().string()), std::string::npos) << found.error();
  EXPECT_NE(found.error().find("can't be read: sign anew"), std::string::npos) << found.error();
  ASSERT_EQ(store().keep({checklist(), signature(150.0)}), "");
  EXPECT_TRUE(store().find(checklist(), 200.0));
}

TEST_F(Stored, WhatHoldsNoLongerGoesADayLater) {
  Checklist other = checklist();
  other.digest = "0123456789abcdef";
  ASSERT_EQ(store().keep({other, signature(100.0)}), "");
  ASSERT_EQ(store().keep({checklist(), signature(200.0)}), "");
  EXPECT_EQ(files().size(), 2U);
  ASSERT_EQ(store().keep({checklist(), signature(100'000.0)}), "");
  EXPECT_EQ(files().size(), 1U);
}

TEST_F(Stored, NothingIsLeftOfWhatCanNotBeWritten) {
  const SignedChecklist one = {checklist(), signature(100.0)};
  ASSERT_EQ(store().keep(one), "");
  const fs::path file = files().front();
  // A disk without room.
  fs::create_symlink("/dev/full", file.string() + "." + std::to_string(::getpid()) + ".part");
  const std::string full = store().keep({checklist(), signature(150.0)});
  EXPECT_TRUE(full.ends_with("can't be written: No space left on device")) << full;
  EXPECT_EQ(files(), std::vector<fs::path>{file});
  EXPECT_EQ(*store().find(checklist(), 200.0), one) << "what was signed before is still there";
  // A folder of its name.
  fs::remove(file);
  fs::create_directories(file / "inside");
  const std::string taken = store().keep(one);
  EXPECT_TRUE(taken.ends_with("can't be written: Is a directory")) << taken;
  EXPECT_EQ(files(), std::vector<fs::path>{file});
}

TEST(Store, SaysWhereNothingCanBeKept) {
  EXPECT_NE(Store("").keep({checklist(), signature()}), "");
  EXPECT_NE(Store("/dev/null/preflight").keep({checklist(), signature()}), "");
  EXPECT_FALSE(Store("").find(checklist(), 0.0));
}

}  // namespace
}  // namespace mlab::preflight
