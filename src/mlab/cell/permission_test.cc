#include "mlab/cell/permission.h"

#include <gtest/gtest.h>

namespace mlab::cell {
namespace {

const Means kMeans{7, ""};

Grounds grounds() {
  return {.purpose = Grounds::Purpose::kRun,
          .people = Grounds::People::kHere,
          .allows_native = false,
          .without_cell = false,
          .is_trusted = true,
          .known = nullptr};
}

TEST(Permission, PeopleHereCompileAndRunInACellWithoutBeingAsked) {
  const Permission it = Permission::decide(grounds(), kMeans);
  EXPECT_EQ(it.to_compile("code"), Wall::kLandlock);
  EXPECT_EQ(it.to_run("code"), Wall::kLandlock);
}

TEST(Permission, WhatComesFromAnotherMachineIsNeitherCompiledNorRun) {
  Grounds ours = grounds();
  ours.people = Grounds::People::kElsewhere;
  ours.known = std::make_shared<Texts>(Texts{"on disk"});
  const Permission it = Permission::decide(ours, kMeans);
  EXPECT_TRUE(it.to_compile("on disk"));
  EXPECT_TRUE(it.to_run("on disk"));
  EXPECT_FALSE(it.to_compile("on disk "));
  ASSERT_FALSE(it.to_run("typed"));
  EXPECT_NE(it.to_run("typed").error().find("--allow-native"), std::string::npos);
  EXPECT_FALSE(it.to_start("./evil"));
  EXPECT_TRUE(it.others_write_files());
  EXPECT_FALSE(Permission::decide(grounds(), kMeans).others_write_files());
  ours.allows_native = true;
  EXPECT_FALSE(Permission::decide(ours, kMeans).others_write_files());
}

TEST(Permission, AllowingNativeCodeTakesNoCellAway) {
  Grounds ours = grounds();
  ours.people = Grounds::People::kElsewhere;
  ours.allows_native = true;
  const Permission it = Permission::decide(ours, kMeans);
  EXPECT_EQ(it.to_compile("typed"), Wall::kLandlock);
  EXPECT_EQ(it.to_run("typed"), Wall::kLandlock);
  EXPECT_EQ(it.to_start("./forager"), Wall::kLandlock);
}

TEST(Permission, ExecutablesAreStartedOnlyWhereSomebodySaidSo) {
  EXPECT_FALSE(Permission::decide(grounds(), kMeans).to_start("./forager"));
}

TEST(Permission, WhatIsOnlyCheckedIsCompiledAndNeverRun) {
  Grounds ours = grounds();
  ours.purpose = Grounds::Purpose::kCheck;
  ours.allows_native = true;
  const Permission it = Permission::decide(ours, kMeans);
  EXPECT_TRUE(it.to_compile("code"));
  EXPECT_FALSE(it.to_run("code"));
  EXPECT_FALSE(it.to_start("./forager"));
}

TEST(Permission, WhereNobodyHasDecidedEverythingIsRefused) {
  const Permission it;
  EXPECT_FALSE(it.to_compile("code"));
  EXPECT_FALSE(it.to_run("code"));
  EXPECT_FALSE(it.to_start("./forager"));
  EXPECT_FALSE(it.takes_new_code());
}

TEST(Permission, NothingIsDoneInAFolderThatIsNotTrusted) {
  Grounds ours = grounds();
  ours.is_trusted = false;
  ours.allows_native = true;
  const Permission it = Permission::decide(ours, kMeans);
  EXPECT_FALSE(it.to_compile("code"));
  EXPECT_FALSE(it.to_run("code"));
  EXPECT_FALSE(it.to_start("./forager"));
}

TEST(Permission, AMachineThatCanMakeNoCellRefusesUnlessItIsToldToGoWithout) {
  EXPECT_FALSE(Permission::decide(grounds(), {0, ""}).to_run("code"));
  Grounds ours = grounds();
  ours.without_cell = true;
  EXPECT_EQ(Permission::decide(ours, {0, ""}).to_run("code"), Wall::kNone);
}

}  // namespace
}  // namespace mlab::cell
