// What `mlab diff` says of two files, of a file and git, and how it ends.

#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "command.h"

namespace mlab {
namespace {

using Json = nlohmann::json;

constexpr const char* kDrift =
    "assemblage Drift() -> Vector {\n  cooperate {\n    1: Noise(persistence = 12 s);\n    1: Stand();\n  "
    "}\n}\n";
constexpr const char* kQuicker =
    "assemblage Drift() -> Vector {\n  cooperate {\n    1: Noise(persistence = 6 s);\n    1: Stand();\n  "
    "}\n}\n";
constexpr const char* kLayout = "\nlayout Drift {\n  Noise 40 40;\n}\n";
constexpr const char* kTold = "Drift\n  ~ Noise: persistence 12 s -> 6 s\n1 changed\n";

// Only what the test has written stands in it.
std::string git(const std::string& words) {
  return "git -c init.defaultBranch=main -c user.name=T -c user.email=t@example.org " + words + " && ";
}

TEST_F(Command, DiffTellsWhatDiffersAndEndsAsDiffDoes) {
  write("a.cdl", kDrift);
  write("b.cdl", kQuicker);
  const Outcome other = mlab("diff a.cdl b.cdl");
  EXPECT_EQ(other.status, 1);
  EXPECT_EQ(other.out, kTold);
  EXPECT_EQ(other.err, "");
  const Outcome same = mlab("diff a.cdl a.cdl");
  EXPECT_EQ(same.status, 0);
  EXPECT_EQ(same.out, "");
  EXPECT_EQ(mlab("diff a.cdl -", "cat b.cdl |").out, kTold);
}

TEST_F(Command, DiffTellsMovesOnlyWhereItIsAsked) {
  write("a.cdl", std::string(kDrift) + kLayout);
  write("b.cdl", std::string(kDrift) + "\nlayout Drift {\n  Noise 80 40;\n}\n");
  const Outcome quiet = mlab("diff a.cdl b.cdl");
  EXPECT_EQ(quiet.status, 0);
  EXPECT_EQ(quiet.out, "(both mean the same; what differs: the layout (1 moved or noted))\n");
  const Outcome told = mlab("diff --layout a.cdl b.cdl");
  EXPECT_EQ(told.status, 1);
  EXPECT_TRUE(has(told.out, "  > Noise: place 40, 40 -> 80, 40\n")) << told.out;
}

TEST_F(Command, DiffReadsFromGit) {
  write("my drift.cdl", kDrift);
  EXPECT_EQ(mlab("diff 'my drift.cdl'", git("init -q") + git("add .") + git("commit -q -m first")).status, 0);
  write("my drift.cdl", kQuicker);
  const Outcome changed = mlab("diff 'my drift.cdl'");
  EXPECT_EQ(changed.status, 1) << changed.err;
  EXPECT_EQ(changed.out, kTold);
  const std::string rename = git("mv 'my drift.cdl' other.cdl") + git("commit -qam second");
  EXPECT_EQ(mlab("diff --rev HEAD~1..HEAD other.cdl", rename).out, kTold);
  EXPECT_EQ(mlab("diff other.cdl").status, 0);
  const Outcome unknown = mlab("diff --rev nowhere other.cdl");
  EXPECT_EQ(unknown.status, 2);
  EXPECT_TRUE(has(unknown.err, "has no revision `nowhere`")) << unknown.err;
}

// What a file uses is found wherever it is called from, and whatever the revision is called.
TEST_F(Command, DiffReadsFromGitWhatAFileUses) {
  write("parts.cdl", "assemblage Still() -> Vector { Stand() }\n");
  const std::string uses = "use \"parts.cdl\";\n";
  write("a.cdl", uses + kDrift);
  const std::string begin =
      git("init -q") + git("add .") + git("commit -q -m first") + git("branch feature/a");
  const Outcome same = mlab("diff a.cdl", begin);
  EXPECT_EQ(same.status, 0) << same.err;
  write("a.cdl", uses + kQuicker);
  for (const char* revision : {"HEAD", "feature/a", "HEAD..feature/a"}) {
    const Outcome changed = mlab(std::string("diff --rev ") + revision + " a.cdl");
    EXPECT_EQ(changed.err, "") << revision;
  }
  EXPECT_EQ(mlab("diff --rev feature/a ./a.cdl").out, kTold);
  EXPECT_EQ(mlab("diff --rev feature/a a.cdl").out, kTold);
}

TEST_F(Command, DiffSaysWhatItCantCompare) {
  write("a.cdl", kDrift);
  write("torn.cdl", std::string(kQuicker) + "assemblage {\n");
  const Outcome torn = mlab("diff a.cdl torn.cdl");
  EXPECT_EQ(torn.status, 2);
  EXPECT_TRUE(has(torn.out, "Noise: persistence 12 s -> 6 s")) << torn.out;
  EXPECT_TRUE(has(torn.err, "torn.cdl:7:")) << torn.err;
  write("half.cdl", std::string(kDrift) + "assemblage {\n");
  const Outcome half = mlab("diff a.cdl half.cdl");
  EXPECT_EQ(half.status, 2);
  EXPECT_EQ(half.out, "(only what could be read was compared, and that is the same)\n");
  EXPECT_TRUE(Json::parse(mlab("diff --json a.cdl half.cdl").out).at("same").is_null());
  write("a.mdl", "COMMAND LIST:\n");
  const Outcome mission = mlab("diff a.mdl a.mdl");
  EXPECT_EQ(mission.status, 2);
  EXPECT_TRUE(has(mission.err, "`mlab diff` compares configurations (.cdl)")) << mission.err;
  EXPECT_EQ(mlab("diff a.cdl missing.cdl").status, 2);
  EXPECT_EQ(mlab("diff --rev HEAD a.cdl a.cdl").status, 2);
  EXPECT_EQ(mlab("diff").status, 2);
}

TEST_F(Command, DiffWritesJsonForPrograms) {
  write("a.cdl", kDrift);
  write("b.cdl", kQuicker);
  const Json json = Json::parse(mlab("diff --json a.cdl b.cdl").out);
  EXPECT_EQ(json.at("same"), false);
  ASSERT_EQ(json.at("differences").size(), 1U);
  const Json& one = json.at("differences").at(0);
  EXPECT_EQ(one.at("what"), "changed");
  EXPECT_EQ(one.at("kind"), "Noise");
  EXPECT_EQ(one.at("details").at(0).at("after"), "6 s");
  EXPECT_EQ(one.at("place").at("after").at("line"), 3);
}

// A stranger's text can't have the terminal do anything; programs get it as it is.
TEST_F(Command, DiffShowsControlCharactersAndDoesNotSendThem) {
  write("a.cdl", kDrift);
  write("b.cdl", "use \"\x1b[31mx.cdl\";\n" + std::string(kDrift));
  const Outcome told = mlab("diff a.cdl b.cdl");
  EXPECT_TRUE(has(told.out, "+ use \\x1b[31mx.cdl\n")) << told.out;
  EXPECT_EQ((told.out + told.err).find('\x1b'), std::string::npos);
  const Json json = Json::parse(mlab("diff --json a.cdl b.cdl").out);
  EXPECT_EQ(json.at("differences").at(0).at("name").at("after"), "\x1b[31mx.cdl");
}

}  // namespace
}  // namespace mlab
