#include "mlab/text/private_folder.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

namespace mlab::text {
namespace {

namespace fs = std::filesystem;

class PrivateFolder : public ::testing::Test {
 protected:
  void SetUp() override {
    root_ = fs::path(::testing::TempDir()) /
            (std::string("private_") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(root_);
  }
  void TearDown() override { fs::remove_all(root_); }

  fs::path root_;
};

TEST_F(PrivateFolder, IsMadeWithThoseAboveIt) {
  const fs::path folder = root_ / "a" / "b";
  const auto made = make_private_folder(folder);
  ASSERT_TRUE(made) << made.error();
  EXPECT_EQ(fs::status(folder).permissions(), fs::perms::owner_all);
}

TEST_F(PrivateFolder, IsClosedWhereItWasOpen) {
  fs::create_directories(root_);
  fs::permissions(root_, fs::perms::all);
  ASSERT_TRUE(make_private_folder(root_));
  EXPECT_EQ(fs::status(root_).permissions(), fs::perms::owner_all);
}

TEST_F(PrivateFolder, IsNotMadeWhereAFileIsInTheWay) {
  fs::create_directories(root_);
  std::ofstream(root_ / "file") << "x";
  const auto made = make_private_folder(root_ / "file" / "folder");
  ASSERT_FALSE(made);
  EXPECT_TRUE(made.error().starts_with("the folder `" + root_.string() + "/file/folder` can't be made: "))
      << made.error();
}

// Nobody may change the mode of what the kernel shows of a process, not even the superuser.
TEST_F(PrivateFolder, ThatStaysOpenIsTold) {
  const auto made = make_private_folder("/proc/self/fd");
  ASSERT_FALSE(made);
  EXPECT_TRUE(made.error().starts_with("the folder `/proc/self/fd` can't be kept from others: "))
      << made.error();
}

}  // namespace
}  // namespace mlab::text
