// What `mlab test-components` says of tests that pass, that fail and that can't be read, and how it ends.

#include <string>

#include <gtest/gtest.h>

#include "command.h"

namespace mlab {
namespace {

constexpr const char* kGood =
    "test \"goes home\" of MoveToGoal(DetectGoal([9 m, 0 m])) {\n  expect abs(direction(it)) < 1 deg;\n}\n";
constexpr const char* kBad =
    "test \"stands\" of MoveToGoal(DetectGoal([9 m, 0 m])) {\n  expect length(it) == 0;\n}\n";

TEST_F(Command, TestComponentsRunsTheTestsOfFilesAndFolders) {
  write("good.cdl", kGood);
  write("none.cdl", "assemblage A() { Stand() }\n");
  const Outcome one = mlab("test-components good.cdl");
  EXPECT_EQ(one.status, 0) << one.err;
  EXPECT_EQ(one.out, "good.cdl\n  ok    goes home (1 cycle)\n1 test: all passed\n");
  EXPECT_EQ(mlab("test-components -", "cat good.cdl |").status, 0);
  EXPECT_TRUE(has(mlab("test-components").out, "1 test: all passed\n")) << "the current folder";
  EXPECT_EQ(mlab("test-components --quiet good.cdl").out, "1 test: all passed\n");
  EXPECT_EQ(mlab("test-components none.cdl").out, "none.cdl: no tests\n0 tests: nothing to do\n");
}

TEST_F(Command, TestComponentsSaysWhatFailedAndEndsSo) {
  write("all.cdl", std::string(kGood) + kBad);
  const Outcome all = mlab("test-components all.cdl");
  EXPECT_EQ(all.status, 1);
  EXPECT_TRUE(has(all.out, "  ok    goes home (1 cycle)\n  FAIL  stands\n")) << all.out;
  EXPECT_TRUE(
      has(all.out, "all.cdl:5:10: error: `length(it) == 0` is false in cycle 1 [failed-expectation]\n"))
      << all.out;
  EXPECT_TRUE(has(all.out, "      = length(it) is 1\n")) << all.out;
  EXPECT_TRUE(has(all.out, "2 tests: 1 failed\n")) << all.out;
  EXPECT_EQ(mlab("test-components --only HOME all.cdl").status, 0);
}

TEST_F(Command, TestComponentsTellsWhatItCannotRead) {
  write("good.cdl", kGood);
  write("bad.cdl", "test \"x\" of Nothing_of_that_name() { expect it; }\n");
  write("m.mdl", "MISSION NAME \"x\"\n");
  const Outcome bad = mlab("test-components bad.cdl");
  EXPECT_EQ(bad.status, 2);
  EXPECT_TRUE(has(bad.err, "bad.cdl:1:13: error:")) << bad.err;
  EXPECT_EQ(mlab("test-components nowhere.cdl").status, 2);
  EXPECT_TRUE(has(mlab("test-components m.mdl").err, "this is no configuration"));
  fs::create_symlink("nowhere.cdl", folder_ / "lost.cdl");
  const Outcome folder = mlab("test-components .");
  EXPECT_EQ(folder.status, 2);
  EXPECT_TRUE(has(folder.err, "lost.cdl")) << folder.err;
  const Outcome none = mlab("test-components --only homw good.cdl");
  EXPECT_EQ(none.status, 2);
  EXPECT_TRUE(has(none.err, "no test has `homw` in its name")) << none.err;
}

}  // namespace
}  // namespace mlab
