#include "mlab/git/git.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "mlab/git/run_git.h"

namespace mlab::git {
namespace {

namespace fs = std::filesystem;

/// A repository of its own; nothing of the person's settings holds in it.
class Repository : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(::testing::TempDir()) / fmt::format("a repository {}", ::getpid());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    ::setenv("GIT_CONFIG_GLOBAL", "/dev/null", 1);
    ::setenv("GIT_CONFIG_NOSYSTEM", "1", 1);
    git("init -q -b main");
    git("config user.name Tester");
    git("config user.email tester@example.org");
  }
  void TearDown() override { fs::remove_all(folder_); }

  void git(const std::string& command) const {
    const std::string whole = fmt::format("cd '{}' && git {} >/dev/null 2>&1", folder_.string(), command);
    ASSERT_EQ(std::system(whole.c_str()), 0) << whole;  // NOLINT(cert-env33-c): the test's own words
  }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  void commit(const std::string& subject) const {
    git("add -A");
    git(fmt::format("commit -q -m '{}'", subject));
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  fs::path folder_;
};

text::Result<text::SourcePtr> text_at(const TrackedFile& file, const std::string& revision) {
  const text::Result<FileThen> then = file.find(revision);
  if (!then) return std::unexpected(then.error());
  return file.at(*then);
}

std::string refusal_at(const TrackedFile& file, const std::string& revision) {
  const text::Result<text::SourcePtr> found = text_at(file, revision);
  return found ? "" : found.error().message;
}

TEST_F(Repository, GivesTheTextOfARevisionWhoeverIsInTheWay) {
  write("my skills.cdl", "one\n");
  commit("first");
  write("my skills.cdl", "two\n");
  commit("second");
  write("my skills.cdl", "three\n");
  const TrackedFile file(path("my skills.cdl"));
  EXPECT_EQ((*text_at(file, "HEAD"))->text(), "two\n");
  EXPECT_EQ((*text_at(file, "HEAD~1"))->text(), "one\n");
  EXPECT_EQ((*text_at(file, "HEAD"))->name(), "HEAD:" + path("my skills.cdl"));
}

TEST_F(Repository, ListsWhatTouchedAFileThroughItsNames) {
  write("old.cdl", "a\nb\nc\nd\ne\n");
  commit("begin");
  write("other.cdl", "x\n");
  commit("something else");
  git("mv old.cdl new.cdl");
  commit("another name");
  const TrackedFile file(path("new.cdl"));
  const auto all = file.revisions(10);
  ASSERT_TRUE(all.has_value()) << all.error().message;
  ASSERT_EQ(all->size(), 2U);
  EXPECT_EQ((*all)[0].subject, "another name");
  EXPECT_EQ((*all)[1].subject, "begin");
  EXPECT_EQ((*all)[1].author, "Tester");
  EXPECT_EQ((*all)[1].path, "old.cdl");
  EXPECT_EQ((*all)[0].date.size(), 10U);
  EXPECT_EQ((*text_at(file, "HEAD~2"))->text(), "a\nb\nc\nd\ne\n");
}

TEST_F(Repository, SaysWhatIsWrong) {
  const TrackedFile empty(path("a.cdl"));
  EXPECT_NE(refusal_at(empty, "HEAD").find("has no revision yet"), std::string::npos);
  write("a.cdl", "a\n");
  commit("first");
  EXPECT_NE(refusal_at(TrackedFile(path("b.cdl")), "HEAD").find("is not in revision `HEAD`"),
            std::string::npos);
  EXPECT_NE(refusal_at(empty, "nowhere").find("has no revision `nowhere`"), std::string::npos);
  EXPECT_NE(refusal_at(empty, "--output=x").find("is no revision"), std::string::npos);
  EXPECT_NE(refusal_at(TrackedFile(path("gone/a.cdl")), "HEAD").find("is not there"), std::string::npos);
  ::setenv("GIT_CEILING_DIRECTORIES", fs::path(::testing::TempDir()).c_str(), 1);
  const fs::path outside = fs::path(::testing::TempDir()) / "no repository";
  fs::create_directories(outside);
  EXPECT_NE(refusal_at(TrackedFile((outside / "a.cdl").string()), "HEAD").find("in no repository"),
            std::string::npos);
  ::unsetenv("GIT_CEILING_DIRECTORIES");
}

TEST_F(Repository, ReadsFilesBesideItAsTheyWere) {
  fs::create_directories(folder_ / "sub");
  write("sub/a.cdl", "use \"../b.cdl\";\n");
  write("b.cdl", "old\n");
  commit("first");
  write("b.cdl", "new\n");
  const TrackedFile file(path("sub/a.cdl"));
  const text::Files files = file.files_at(*file.find("HEAD"));
  const std::string name = "HEAD:" + path("sub/../b.cdl");
  EXPECT_TRUE(files.is_file(name));
  EXPECT_EQ((*files.read(name))->text(), "old\n");
  EXPECT_FALSE(files.is_file("HEAD:" + path("c.cdl")));
  EXPECT_FALSE(files.is_file(path("b.cdl")));
}

TEST_F(Repository, FindsWhatStoodBesideItBeforeItsFolderWasRenamed) {
  fs::create_directories(folder_ / "old");
  write("old/a.cdl", "use \"b.cdl\";\nuse \"../c.cdl\";\n");
  write("old/b.cdl", "beside\n");
  write("c.cdl", "above\n");
  commit("first");
  git("tag v1");
  git("mv old new");
  git("mv c.cdl new/c.cdl");
  commit("another folder");
  const TrackedFile file(path("new/a.cdl"));
  const text::Result<FileThen> then = file.find("v1");
  ASSERT_TRUE(then.has_value()) << then.error().message;
  EXPECT_EQ(then->path, "old/a.cdl");
  const text::Files files = file.files_at(*then);
  const std::string beside = "v1:" + path("new/b.cdl");
  ASSERT_TRUE(files.is_file(beside));
  EXPECT_EQ((*files.read(beside))->text(), "beside\n");
  EXPECT_EQ((*files.read("v1:" + path("new/../c.cdl")))->text(), "above\n");
  EXPECT_FALSE(files.is_file("v1:" + path("new/c.cdl")));
  EXPECT_FALSE(files.is_file("v1:" + path("new/../../x.cdl")));
}

TEST_F(Repository, FollowsAMoveThatIsNotCommittedYet) {
  fs::create_directories(folder_ / "old");
  write("old/a.cdl", "a\nb\nc\nd\ne\n");
  commit("first");
  git("tag v1");
  fs::create_directories(folder_ / "new");
  git("mv old/a.cdl new/b.cdl");
  commit("moved");
  git("mv new/b.cdl 'c [1].cdl'");
  const TrackedFile file(path("c [1].cdl"));
  ASSERT_TRUE(file.find("HEAD").has_value()) << refusal_at(file, "HEAD");
  EXPECT_EQ(file.find("HEAD")->path, "new/b.cdl");
  ASSERT_TRUE(file.find("v1").has_value()) << refusal_at(file, "v1");
  EXPECT_EQ(file.find("v1")->path, "old/a.cdl");
  EXPECT_EQ((*file.at(*file.find("v1")))->text(), "a\nb\nc\nd\ne\n");
  ASSERT_EQ(file.revisions(10)->size(), 2U);
  EXPECT_EQ(file.revisions(10)->front().path, "new/b.cdl");
}

TEST_F(Repository, TakesACopyForAFileOfItsOwn) {
  write("original.cdl", "a\nb\nc\nd\ne\n");
  commit("first");
  git("tag v1");
  fs::copy_file(folder_ / "original.cdl", folder_ / "copy.cdl");
  commit("copied");
  git("tag v2");
  git("mv copy.cdl mine.cdl");
  commit("renamed");
  const TrackedFile file(path("mine.cdl"));
  EXPECT_EQ(refusal_at(file, "v1"), fmt::format("`{}` is not in revision `v1`", path("mine.cdl")));
  ASSERT_TRUE(file.find("v2").has_value());
  EXPECT_EQ(file.find("v2")->path, "copy.cdl");
  const auto all = file.revisions(10);
  ASSERT_EQ(all->size(), 2U);
  EXPECT_EQ(all->back().subject, "copied");
  EXPECT_EQ(all->back().path, "copy.cdl");
}

TEST_F(Repository, ReadsNoSymbolicLinkAsAText) {
  write("real.cdl", "one\n");
  fs::create_symlink("real.cdl", folder_ / "link.cdl");
  commit("first");
  EXPECT_EQ(refusal_at(TrackedFile(path("link.cdl")), "HEAD"),
            "`link.cdl` is a symbolic link in this revision");
  const TrackedFile file(path("real.cdl"));
  const text::Files files = file.files_at(*file.find("HEAD"));
  EXPECT_FALSE(files.is_file("HEAD:" + path("link.cdl")));
  EXPECT_TRUE(files.is_file("HEAD:" + path("real.cdl")));
}

// Everything that a stranger's repository could bring to have something run.
TEST_F(Repository, RunsNothingThatTheRepositoryBrings) {
  const std::string trap = path("trap.sh");
  const std::string sprung = path("sprung");
  write("trap.sh", fmt::format("#!/bin/sh\necho \"$0 $*\" >> '{}'\ncat\n", sprung));
  ::chmod(trap.c_str(), 0755);
  write("a.cdl", "one\n");
  commit("first");
  write("a.cdl", "two\n");
  commit("second");
  write(".gitattributes", "*.cdl filter=trap diff=trap\n");
  for (const char* setting :
       {"core.fsmonitor", "filter.trap.smudge", "filter.trap.clean", "filter.trap.process",
        "diff.trap.textconv", "diff.trap.command", "diff.external", "core.pager", "gpg.program",
        "core.sshCommand", "core.alternateRefsCommand", "pager.log", "pager.cat-file", "pager.rev-parse",
        "uploadpack.packObjectsHook"})
    git(fmt::format("config {} '{}'", setting, trap));
  git("config log.showSignature true");
  git("config alias.log '!sh trap.sh'");
  git("config alias.cat-file '!sh trap.sh'");
  for (const char* hook : {"post-checkout", "pre-commit", "post-index-change", "reference-transaction"})
    fs::copy_file(trap, folder_ / ".git" / "hooks" / hook);
  // A commit that says it is signed: to check that, git would call `gpg.program`.
  git("update-ref HEAD $(git cat-file commit HEAD | sed \"s/^committer.*/&\\ngpgsig -----BEGIN PGP "
      "SIGNATURE-----"
      "\\n \\n x\\n -----END PGP SIGNATURE-----/\" | git hash-object -t commit -w --stdin)");
  fs::remove(sprung);
  const TrackedFile file(path("a.cdl"));
  ASSERT_TRUE(text_at(file, "HEAD~1").has_value());
  EXPECT_EQ((*text_at(file, "HEAD~1"))->text(), "one\n");
  ASSERT_TRUE(file.revisions(10).has_value());
  EXPECT_EQ(file.revisions(10)->size(), 2U);
  EXPECT_FALSE(text_at(TrackedFile(path("b.cdl")), "HEAD").has_value());
  EXPECT_FALSE(fs::exists(sprung));
}

TEST_F(Repository, DoesNotFetchWhatAPartialCloneLacks) {
  write("a.cdl", "one\n");
  commit("first");
  const std::string sprung = path("sprung");
  write("trap.sh", fmt::format("#!/bin/sh\necho fetch >> '{}'\n", sprung));
  ::chmod(path("trap.sh").c_str(), 0755);
  git("config extensions.partialClone origin");
  git("config remote.origin.url '" + folder_.string() + "'");
  git("config remote.origin.promisor true");
  git("config remote.origin.uploadpack '" + path("trap.sh") + "'");
  const GitAnswer blob = run_git(folder_.string(), {"rev-parse", "HEAD:./a.cdl"}, 4096);
  const std::string id = blob.output.substr(0, 40);
  fs::remove(folder_ / ".git/objects" / id.substr(0, 2) / id.substr(2));
  EXPECT_FALSE(text_at(TrackedFile(path("a.cdl")), "HEAD").has_value());
  EXPECT_FALSE(fs::exists(sprung));
}

TEST_F(Repository, SaysWhyGitCantBeStarted) {
  write("git", "no program\n");
  const std::string before = std::getenv("PATH");  // NOLINT(concurrency-mt-unsafe): a test has one thread
  ::setenv("PATH", folder_.c_str(), 1);
  const std::string forbidden = refusal_at(TrackedFile(path("a.cdl")), "HEAD");
  fs::remove(folder_ / "git");
  const std::string none = refusal_at(TrackedFile(path("a.cdl")), "HEAD");
  ::setenv("PATH", before.c_str(), 1);
  EXPECT_EQ(forbidden, "the program `git` can't be started: Permission denied");
  EXPECT_EQ(none, "there is no program `git`");
}

TEST(RunGit, EndsWhatTakesTooLongOrSaysTooMuch) {
  EXPECT_FALSE(run_git(".", {"help", "-a"}, 10).is_whole);
  EXPECT_FALSE(run_git(".", {"version"}, 4096, 0.0).is_whole);
}

}  // namespace
}  // namespace mlab::git
