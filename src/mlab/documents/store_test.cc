#include "mlab/documents/store.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/documents/testing/scratch_project.h"

namespace mlab::documents {
namespace {

using Disk = Document::Disk;

class StoreOfAProject : public ::testing::Test {
 protected:
  StoreOfAProject() : project({scratch.path("project").string(), ""}) {
    scratch.write("project/a.mdl", "one\ntwo\nthree\n");
  }

  static std::string text_of(const Document& document) { return std::string(document.text.text()); }

  // Until it has settled what stands there.
  static std::vector<Store::Seen> look(Store& store, double now) {
    std::vector<Store::Seen> seen = store.look_at_disk(now);
    return seen.empty() ? store.look_at_disk(now) : seen;
  }
  // As whoever edits it does it.
  Document& open(Store& store, const std::string& path) const {
    text::Result<std::string> content = store.read(path);
    EXPECT_TRUE(content);
    auto document = std::make_shared<Document>(
        path, std::make_shared<const text::Source>(project.disk_path(path), *content));
    document->saved = std::move(*content);
    return store.add(std::move(document));
  }
  std::string state() const { return scratch.path("state").string(); }

  testing::ScratchProject scratch;
  ProjectFolder project;
};

TEST_F(StoreOfAProject, UndoesAChangeOfSeveralDocumentsAsOne) {
  Store store(project, state());
  scratch.write("project/b.odl", "");
  Document& a = open(store, "a.mdl");
  Document& b = open(store, "b.odl");
  b.log = a.log;
  store.change({{&a, {{0, 3}, "ONE"}}, {&b, {{0, 0}, "new"}}, {&a, {{0, 3}, "Eins"}}}, "both", 0.0);
  EXPECT_EQ(text_of(a), "Eins\ntwo\nthree\n");
  EXPECT_EQ(text_of(b), "new");
  ASSERT_TRUE(a.log->undo());
  EXPECT_EQ(text_of(a), "one\ntwo\nthree\n");
  EXPECT_EQ(text_of(b), "");
  ASSERT_TRUE(b.log->redo());
  EXPECT_EQ(text_of(a), "Eins\ntwo\nthree\n");
  EXPECT_EQ(text_of(b), "new");
}

TEST_F(StoreOfAProject, EntersNothingWhereNothingChanges) {
  Store store(project, state());
  Document& a = open(store, "a.mdl");
  store.change({{&a, {{0, 3}, "one"}}}, "same", 0.0);
  EXPECT_EQ(a.text.revision(), 1U);
  EXPECT_FALSE(a.log->undo());
}

TEST_F(StoreOfAProject, TakesAChangedFileOverWhereNothingIsUnsaved) {
  Store store(project, state());
  Document& a = open(store, "a.mdl");
  EXPECT_TRUE(look(store, 0.0).empty());
  scratch.write("project/a.mdl", "theirs\n");
  const std::vector<Store::Seen> seen = look(store, 1.0);
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_EQ(seen[0].news, Store::News::kTakenOver);
  EXPECT_EQ(text_of(a), "theirs\n");
  EXPECT_FALSE(a.is_dirty());
  ASSERT_TRUE(a.log->undo()) << "the old one comes back";
  EXPECT_EQ(text_of(a), "one\ntwo\nthree\n");
  EXPECT_TRUE(a.is_dirty());
  EXPECT_TRUE(look(store, 2.0).empty());
}

TEST_F(StoreOfAProject, LeavesAloneWhatSomebodyIsStillWriting) {
  Store store(project, state());
  Document& a = open(store, "a.mdl");
  for (const char* so_far : {"", "the", "theirs, but", "theirs, but not whol"}) {
    scratch.write("project/a.mdl", so_far);
    EXPECT_TRUE(store.look_at_disk(1.0).empty()) << so_far;
    EXPECT_EQ(text_of(a), "one\ntwo\nthree\n");
  }
  scratch.write("project/a.mdl", "theirs, whole\n");
  EXPECT_TRUE(store.look_at_disk(2.0).empty());
  ASSERT_EQ(store.look_at_disk(3.0).size(), 1U);
  EXPECT_EQ(text_of(a), "theirs, whole\n");

  store.change(a, "mine\n", "type", 3.0);
  scratch.write("project/a.mdl", "half");
  EXPECT_TRUE(store.look_at_disk(4.0).empty()) << "nobody is asked about half a file";
  EXPECT_EQ(a.disk, Disk::kSame);
  scratch.write("project/a.mdl", "theirs, whole\n");
  EXPECT_TRUE(store.look_at_disk(5.0).empty());
  EXPECT_TRUE(store.look_at_disk(6.0).empty());
}

TEST_F(StoreOfAProject, AsksOnceWhereSomethingIsUnsavedAndMergesWhatDoesNotTouch) {
  Store store(project, state());
  Document& a = open(store, "a.mdl");
  store.change(a, "mine\ntwo\nthree\n", "type", 0.0);
  scratch.write("project/a.mdl", "one\ntwo\ntheirs\n");
  ASSERT_EQ(look(store, 1.0).size(), 1U);
  EXPECT_EQ(a.disk, Disk::kChanged);
  EXPECT_EQ(text_of(a), "mine\ntwo\nthree\n");
  EXPECT_TRUE(look(store, 2.0).empty()) << "it has been said";
  ASSERT_TRUE(store.reload(a, true, 3.0));
  EXPECT_EQ(text_of(a), "mine\ntwo\ntheirs\n");
  EXPECT_EQ(a.disk, Disk::kSame);
  ASSERT_TRUE(store.save(a));
  EXPECT_EQ(scratch.read("project/a.mdl"), "mine\ntwo\ntheirs\n");
  ASSERT_TRUE(a.log->undo());
  EXPECT_EQ(text_of(a), "mine\ntwo\nthree\n");
}

TEST_F(StoreOfAProject, MergesNothingThatTouches) {
  Store store(project, state());
  Document& a = open(store, "a.mdl");
  store.change(a, "mine\ntwo\nthree\n", "type", 0.0);
  scratch.write("project/a.mdl", "theirs\ntwo\nthree\n");
  EXPECT_EQ(store.reload(a, true, 1.0).error().kind, "conflict");
  EXPECT_EQ(text_of(a), "mine\ntwo\nthree\n");
  ASSERT_TRUE(store.reload(a, false, 1.0));
  EXPECT_EQ(text_of(a), "theirs\ntwo\nthree\n");
  ASSERT_TRUE(a.log->undo()) << "what was typed is not lost";
  EXPECT_EQ(text_of(a), "mine\ntwo\nthree\n");
}

TEST_F(StoreOfAProject, WritesOverNothingThatSomebodyElseWroteUnlessTold) {
  Store store(project, state());
  Document& a = open(store, "a.mdl");
  store.change(a, "mine\n", "type", 0.0);
  scratch.write("project/a.mdl", "theirs\n");
  EXPECT_EQ(store.save(a).error().kind, "changed-on-disk");
  EXPECT_EQ(a.disk, Disk::kChanged) << "so that people are asked";
  EXPECT_EQ(scratch.read("project/a.mdl"), "theirs\n");
  scratch.write("project/b.mdl", "theirs, too\n");
  EXPECT_EQ(store.save_as(a, "b.mdl").error().kind, "file-exists");
  ASSERT_TRUE(store.save(a, true));
  EXPECT_EQ(scratch.read("project/a.mdl"), "mine\n");
  EXPECT_EQ(a.disk, Disk::kSame);
}

TEST_F(StoreOfAProject, SavesUnderItsOwnNameAsEver) {
  Store store(project, state());
  Document& fresh = store.add(std::make_shared<Document>(
      "new.mdl", std::make_shared<const text::Source>(project.disk_path("new.mdl"), "")));
  ASSERT_TRUE(store.save_as(fresh, "new.mdl"));
  ASSERT_EQ(store.find("new.mdl"), &fresh);
  EXPECT_TRUE(fresh.saved);
  Document& a = open(store, "a.mdl");
  store.change(a, "mine\n", "type", 0.0);
  scratch.write("project/a.mdl", "theirs\n");
  EXPECT_EQ(store.save_as(a, "a.mdl").error().kind, "changed-on-disk");
  ASSERT_TRUE(store.save_as(a, "a.mdl", true));
  EXPECT_EQ(scratch.read("project/a.mdl"), "mine\n");
}

TEST_F(StoreOfAProject, SaysThatAFileIsGoneAndWritesItAnew) {
  Store store(project, state());
  Document& a = open(store, "a.mdl");
  std::filesystem::remove(scratch.path("project/a.mdl"));
  ASSERT_EQ(look(store, 0.0).size(), 1U);
  EXPECT_EQ(a.disk, Disk::kGone);
  EXPECT_TRUE(look(store, 1.0).empty());
  EXPECT_EQ(text_of(a), "one\ntwo\nthree\n");
  EXPECT_TRUE(a.is_dirty()) << "it is nowhere else";
  store.keep_drafts(1.0);
  EXPECT_TRUE(store.drafts().find("a.mdl"));
  ASSERT_TRUE(store.save(a));
  EXPECT_FALSE(a.is_dirty());
  EXPECT_EQ(scratch.read("project/a.mdl"), "one\ntwo\nthree\n");
}

TEST_F(StoreOfAProject, TakesOverAFileThatHasComeBackChanged) {
  Store store(project, state());
  Document& a = open(store, "a.mdl");
  std::filesystem::remove(scratch.path("project/a.mdl"));
  look(store, 0.0);
  ASSERT_EQ(a.disk, Disk::kGone);
  scratch.write("project/a.mdl", "theirs\n");
  look(store, 1.0);
  EXPECT_EQ(text_of(a), "theirs\n");
  EXPECT_EQ(a.disk, Disk::kSame);
  EXPECT_FALSE(a.is_dirty());
}

TEST_F(StoreOfAProject, BringsBackWhatWasNotSavedAsTheFirstChange) {
  {
    Store store(project, state());
    store.change(open(store, "a.mdl"), "mine\n", "type", 0.0);
    store.keep_drafts(0.0);
  }
  Store again(project, state());
  Document& a = open(again, "a.mdl");
  EXPECT_EQ(again.restore_draft(a, 0.0), Store::Restored::kText);
  EXPECT_EQ(text_of(a), "mine\n");
  ASSERT_TRUE(a.log->undo());
  EXPECT_EQ(text_of(a), "one\ntwo\nthree\n");
}

TEST_F(StoreOfAProject, AsksWhereTheFileOfADraftHasChangedMeanwhile) {
  {
    Store store(project, state());
    store.change(open(store, "a.mdl"), "mine\ntwo\nthree\n", "type", 0.0);
    store.keep_drafts(0.0);
  }
  scratch.write("project/a.mdl", "one\ntwo\ntheirs\n");
  Store again(project, state());
  Document& a = open(again, "a.mdl");
  EXPECT_EQ(again.restore_draft(a, 0.0), Store::Restored::kTextOfOlderFile);
  EXPECT_EQ(again.save(a).error().kind, "changed-on-disk");
  EXPECT_EQ(scratch.read("project/a.mdl"), "one\ntwo\ntheirs\n");
  a.disk = Disk::kSame;
  ASSERT_EQ(look(again, 1.0).size(), 1U);
  EXPECT_EQ(a.disk, Disk::kChanged);
  EXPECT_TRUE(look(again, 2.0).empty());
  EXPECT_EQ(again.reload(a, true, 3.0).error().kind, "conflict") << "what both come from is not known";
  ASSERT_TRUE(again.reload(a, false, 4.0));
  EXPECT_EQ(text_of(a), "one\ntwo\ntheirs\n");
  ASSERT_TRUE(a.log->undo());
  EXPECT_EQ(text_of(a), "mine\ntwo\nthree\n");
}

TEST_F(StoreOfAProject, AsksForTheFileOfADraftAlsoAfterMoreWasTyped) {
  {
    Store store(project, state());
    store.change(open(store, "a.mdl"), "mine\n", "type", 0.0);
    store.keep_drafts(0.0);
  }
  scratch.write("project/a.mdl", "theirs\n");
  {
    Store store(project, state());
    Document& a = open(store, "a.mdl");
    ASSERT_EQ(store.restore_draft(a, 0.0), Store::Restored::kTextOfOlderFile);
    store.change(a, "mine, too\n", "type", 1.0);
    store.keep_drafts(1.0);
  }
  Store again(project, state());
  Document& a = open(again, "a.mdl");
  EXPECT_EQ(again.restore_draft(a, 2.0), Store::Restored::kTextOfOlderFile);
  EXPECT_EQ(text_of(a), "mine, too\n");
  EXPECT_EQ(again.save(a).error().kind, "changed-on-disk");
  EXPECT_EQ(scratch.read("project/a.mdl"), "theirs\n");
}

TEST_F(StoreOfAProject, AsksNothingWhereTheDraftOfAnOlderFileWasUndone) {
  {
    Store store(project, state());
    store.change(open(store, "a.mdl"), "mine\n", "type", 0.0);
    store.keep_drafts(0.0);
  }
  scratch.write("project/a.mdl", "theirs\n");
  {
    Store store(project, state());
    Document& a = open(store, "a.mdl");
    ASSERT_EQ(store.restore_draft(a, 0.0), Store::Restored::kTextOfOlderFile);
    ASSERT_TRUE(a.log->undo());
    ASSERT_TRUE(a.log->redo());
    EXPECT_EQ(store.save(a).error().kind, "changed-on-disk") << "it has come back once more";
    ASSERT_TRUE(a.log->undo());
    EXPECT_TRUE(store.save(a)) << "there is nothing of the draft in it";
  }
  {
    Store store(project, state());
    store.drafts().keep_of("older", "a.mdl", "mine\n");
    Document& a = open(store, "a.mdl");
    ASSERT_EQ(store.restore_draft(a, 0.0), Store::Restored::kTextOfOlderFile);
    ASSERT_TRUE(a.log->undo());
    store.change(a, "theirs\nand mine\n", "type", 1.0, false);
    EXPECT_TRUE(look(store, 2.0).empty());
    EXPECT_TRUE(store.save(a));
    EXPECT_EQ(scratch.read("project/a.mdl"), "theirs\nand mine\n");
  }
}

TEST_F(StoreOfAProject, OpensWhatIsKeptOfAFileThatIsGone) {
  {
    Store store(project, state());
    store.change(open(store, "a.mdl"), "mine\n", "type", 0.0);
    store.keep_drafts(0.0);
  }
  std::filesystem::remove(scratch.path("project/a.mdl"));
  Store store(project, state());
  EXPECT_EQ(store.only_kept(), std::vector<std::string>{"a.mdl"});
  EXPECT_TRUE(store.files().is_file(project.disk_path("a.mdl")));
  Document& a = store.add(std::make_shared<Document>(
      "a.mdl", std::make_shared<const text::Source>(project.disk_path("a.mdl"), "")));
  EXPECT_EQ(store.restore_draft(a, 0.0), Store::Restored::kTextOfGoneFile);
  EXPECT_EQ(text_of(a), "mine\n");
  EXPECT_EQ(a.disk, Disk::kGone);
  store.change(a, "mine, too\n", "type", 1.0);
  store.keep_drafts(1.0);
  EXPECT_TRUE(store.drafts().find("a.mdl")->had_file) << "for whoever brings it back";
  scratch.write("project/a.mdl", "theirs\n");
  ASSERT_EQ(look(store, 2.0).size(), 1U);
  EXPECT_EQ(a.disk, Disk::kChanged);
  EXPECT_EQ(store.save(a).error().kind, "changed-on-disk");
  ASSERT_TRUE(store.save(a, true));
  EXPECT_EQ(scratch.read("project/a.mdl"), "mine, too\n");
}

TEST_F(StoreOfAProject, SaysThatNothingIsToBeDecidedAnyMore) {
  Store store(project, state());
  Document& a = open(store, "a.mdl");
  std::filesystem::remove(scratch.path("project/a.mdl"));
  look(store, 0.0);
  scratch.write("project/a.mdl", "one\ntwo\nthree\n");
  std::vector<Store::Seen> seen = look(store, 1.0);
  ASSERT_EQ(seen.size(), 1U) << "it has come back";
  EXPECT_EQ(seen[0].news, Store::News::kSameAgain);
  store.change(a, "mine\n", "type", 2.0);
  scratch.write("project/a.mdl", "mine\n");
  seen = look(store, 3.0);
  ASSERT_EQ(seen.size(), 1U) << "somebody else has saved the same";
  EXPECT_EQ(seen[0].news, Store::News::kSameAgain);
  EXPECT_FALSE(a.is_dirty());
  EXPECT_TRUE(look(store, 4.0).empty());
}

TEST_F(StoreOfAProject, GivesReadersTheOpenTextsAboveTheFiles) {
  Store store(project, state());
  scratch.write("project/b.odl", "file");
  Document& a = open(store, "a.mdl");
  store.change(a, "mine\n", "type", 0.0);
  const auto name = [&](const char* path) { return scratch.path("project").string() + "/" + path; };
  const std::shared_ptr<const text::Files> then =
      store.snapshot({std::make_shared<const text::Source>(name("c.odl"), "besides")});
  store.change(a, "later\n", "type", 0.0, false);
  const text::Files now = store.files();
  EXPECT_EQ((*now.read(name("x/../a.mdl")))->text(), "later\n");
  EXPECT_EQ((*then->read(name("x/../a.mdl")))->text(), "mine\n");
  EXPECT_EQ((*then->read(name("b.odl")))->text(), "file");
  EXPECT_EQ((*then->read(name("c.odl")))->text(), "besides");
  EXPECT_FALSE(then->is_file(name("d.odl")));
  EXPECT_FALSE(now.read("/etc/passwd"));
}

}  // namespace
}  // namespace mlab::documents
