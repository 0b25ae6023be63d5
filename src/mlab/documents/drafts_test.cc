// What was acknowledged stays, and where it can't, that is known at once.

#include "mlab/documents/drafts.h"

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "mlab/documents/draft_keeper.h"
#include "mlab/documents/testing/scratch_project.h"

namespace mlab::documents {
namespace {

namespace fs = std::filesystem;
using When = DraftKeeper::When;

/// As long as it lives no file of this process takes a byte more, as on a disk that is full.
class FullDisk {
 public:
  FullDisk() {
    std::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit none{0, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &none);
  }
  ~FullDisk() { ::setrlimit(RLIMIT_FSIZE, &before_); }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit before_{};
};

class DraftsOfAProject : public ::testing::Test {
 protected:
  std::string state() const { return scratch.path("state").string(); }
  DraftKeeper::Text text(const std::string& words, std::uint64_t revision) const {
    return {"a.mdl", words, nullptr, revision, true};
  }
  std::string kept() const {
    const auto draft = drafts.find("a.mdl");
    return draft ? draft->text : "none";
  }
  // What stands in the folder of this project's state.
  std::size_t files() const {
    std::size_t out = 0;
    for (const auto& entry : fs::recursive_directory_iterator(state()))
      out += entry.is_regular_file() ? 1 : 0;
    return out;
  }

  testing::ScratchProject scratch;
  Drafts drafts{state(), "/project"};
};

TEST_F(DraftsOfAProject, FollowEveryChangeAtOnce) {
  DraftKeeper keeper(drafts);
  DraftState draft;
  keeper.follow(text("one", 1), draft, 0.0);
  EXPECT_EQ(kept(), "one");
  keeper.follow(text("two", 2), draft, 0.001);
  EXPECT_EQ(kept(), "two");
  keeper.sync("a.mdl", draft);
  EXPECT_EQ(draft.problem, "");
  EXPECT_EQ(draft.synced, 2U);
  keeper.follow({"a.mdl", "two", nullptr, 2, false}, draft, 0.002);
  EXPECT_EQ(kept(), "none") << "what is saved needs no draft";
}

TEST_F(DraftsOfAProject, SayThatTheDiskIsFullAndKeepTheOlderOne) {
  DraftKeeper keeper(drafts);
  DraftState draft;
  keeper.follow(text("one", 1), draft, 0.0);
  {
    const FullDisk full;
    keeper.follow(text("two", 2), draft, 0.0);
    EXPECT_NE(draft.problem, "");
    EXPECT_NE(drafts.problem(), "");
    EXPECT_EQ(kept(), "one") << "half of a draft would be worse than an old one";
  }
  EXPECT_EQ(files(), 1U) << "nothing half written is left";
  keeper.follow(text("two", 2), draft, 0.5);
  EXPECT_NE(draft.problem, "") << "it was tried a moment ago";
  keeper.follow(text("two", 2), draft, 0.5, When::kAtOnce);
  EXPECT_EQ(draft.problem, "");
  EXPECT_EQ(kept(), "two");
}

TEST_F(DraftsOfAProject, AreTriedAgainByThemselvesOnceThereIsRoom) {
  DraftKeeper keeper(drafts);
  DraftState draft;
  {
    const FullDisk full;
    keeper.follow(text("one", 1), draft, 0.0);
    EXPECT_NE(draft.problem, "");
  }
  keeper.follow(text("one", 1), draft, 1.5);
  EXPECT_EQ(draft.problem, "");
  EXPECT_EQ(kept(), "one");
}

TEST_F(DraftsOfAProject, SayWhereThereIsNoFolderForThem) {
  Drafts nowhere("", "/project");
  EXPECT_NE(nowhere.problem(), "");
  EXPECT_NE(nowhere.keep("a.mdl", "one", nullptr), "");
  EXPECT_EQ(nowhere.drop("a.mdl"), "") << "what is not there is gone";
  scratch.write("file", "no folder");
  Drafts below_a_file(scratch.path("file/state").string(), "/project");
  EXPECT_NE(below_a_file.problem(), "");
}

TEST_F(DraftsOfAProject, FindAFolderThatCanBeMadeLater) {
  scratch.write("late", "no folder yet");
  Drafts late(scratch.path("late").string(), "/project");
  DraftKeeper keeper(late);
  EXPECT_NE(keeper.folder_problem(), "");
  fs::remove(scratch.path("late"));
  keeper.look(10.0);
  EXPECT_EQ(keeper.folder_problem(), "");
  EXPECT_EQ(late.keep("a.mdl", "one", nullptr), "");
}

TEST_F(DraftsOfAProject, SayThatANameWithTwoLinesIsNotKept) {
  EXPECT_NE(drafts.keep("a\nb.mdl", "one", nullptr), "");
}

TEST_F(DraftsOfAProject, AreReadableForNobodyElse) {
  ASSERT_EQ(drafts.keep("a.mdl", "one", nullptr), "");
  for (const auto& entry : fs::recursive_directory_iterator(state())) {
    struct stat status{};
    ASSERT_EQ(::stat(entry.path().c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 077U, 0U) << entry.path();
  }
}

TEST_F(DraftsOfAProject, WhatAKilledProcessLeftHalfWrittenGoes) {
  ASSERT_EQ(drafts.keep("a.mdl", "one", nullptr), "");
  const fs::path folder = fs::directory_iterator(state())->path();
  std::ofstream(folder / ".x.draft.2147483646.part") << "half";  // no process has such a number
  std::ofstream(folder / (".y.draft." + std::to_string(::getpid()) + ".part")) << "being written";
  const Drafts again(state(), "/project");
  EXPECT_EQ(files(), 2U) << "the draft, and what a process that lives is writing";
  EXPECT_EQ(kept(), "one");
}

}  // namespace
}  // namespace mlab::documents
