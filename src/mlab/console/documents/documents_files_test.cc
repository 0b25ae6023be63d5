// Names that are taken, files that are gone: what is not saved outlives them.

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "mlab/console/documents/documents.h"
#include "mlab/documents/testing/scratch_project.h"

namespace mlab::console {
namespace {

class FilesOfDocuments : public ::testing::Test {
 protected:
  FilesOfDocuments() : project({scratch.path("project").string(), ""}) {}

  std::string state() const { return scratch.path("state").string(); }
  static text::Result<bool> make(OpenDocuments& open, const std::string& path,
                                 NewDocument::Kind kind = NewDocument::MISSION) {
    NewDocument request;
    request.set_path(path);
    request.set_kind(kind);
    return open.create(request, 0.0);
  }
  static const OpenDocument* find(OpenDocuments& open, const std::string& path) {
    return open.store().find(path);
  }
  // In front of all that it says.
  static void type(OpenDocuments& open, const std::string& path, const std::string& text) {
    EditText edit;
    edit.set_document(path);
    edit.set_revision(find(open, path)->text.revision());
    edit.set_text(text);
    ASSERT_TRUE(open.edit_text(edit, 0.0));
  }
  static std::string text(OpenDocuments& open, const std::string& path) {
    const OpenDocument* document = find(open, path);
    return document == nullptr ? "not open" : std::string(document->text.text());
  }

  documents::testing::ScratchProject scratch;
  documents::ProjectFolder project;
};

TEST_F(FilesOfDocuments, ANewOneTakesTheNameOfNoneThatWasNeverSaved) {
  OpenDocuments open(project, {}, state());
  ASSERT_TRUE(make(open, "patrol.mdl"));
  type(open, "patrol.mdl", "-- work\n");
  type(open, "patrol.odl", "-- a map\n");
  ASSERT_TRUE(make(open, "other.mdl"));
  const auto again = make(open, "patrol.mdl");
  ASSERT_FALSE(again);
  EXPECT_EQ(again.error().kind, "file-exists");
  EXPECT_EQ(make(open, "patrol.odl", NewDocument::OVERLAY).error().kind, "file-exists");
  ASSERT_TRUE(open.open("patrol.mdl", 1.0));
  EXPECT_TRUE(text(open, "patrol.mdl").starts_with("-- work\n"));
  EXPECT_TRUE(text(open, "patrol.odl").starts_with("-- a map\n"));
}

TEST_F(FilesOfDocuments, ANewMissionLeavesAnOverlayThatWasNeverSavedAsItIs) {
  documents::Store(project, state()).drafts().keep("patrol.odl", "-- a map\nCONTROL MEASURES:\n", nullptr);
  OpenDocuments open(project, {}, state());
  ASSERT_TRUE(make(open, "patrol.mdl"));
  EXPECT_TRUE(text(open, "patrol.odl").starts_with("-- a map\n"));
}

TEST_F(FilesOfDocuments, WhatIsKeptOfAFileThatIsGoneIsOpenedAndSaved) {
  scratch.write("project/m.mdl", "MISSION NAME \"m\"\nCOMMAND LIST:\n");
  {
    OpenDocuments open(project, {}, state());
    ASSERT_TRUE(open.open("m.mdl", 0.0));
    type(open, "m.mdl", "-- work\n");
  }
  std::filesystem::remove(scratch.path("project/m.mdl"));
  OpenDocuments open(project, {}, state());
  const Project message = open.project_message();
  ASSERT_EQ(message.missions_size(), 1);
  EXPECT_EQ(message.missions(0).path(), "m.mdl");
  EXPECT_EQ(make(open, "m.mdl").error().kind, "file-exists");
  ASSERT_TRUE(open.open("m.mdl", 1.0));
  EXPECT_TRUE(text(open, "m.mdl").starts_with("-- work\n"));
  const auto notices = open.take_notices();
  ASSERT_EQ(notices.size(), 1U);
  EXPECT_TRUE(notices[0].contains("whose file is gone")) << notices[0];
  EXPECT_EQ(open.documents_message().documents(0).disk(), Documents::GONE);
  ASSERT_TRUE(open.save({}));
  EXPECT_TRUE(scratch.read("project/m.mdl").starts_with("-- work\n"));
  EXPECT_EQ(open.documents_message().documents(0).disk(), Documents::SAME);
}

TEST_F(FilesOfDocuments, AFileThatHasComeBackIsTold) {
  scratch.write("project/m.mdl", "MISSION NAME \"m\"\nCOMMAND LIST:\n");
  OpenDocuments open(project, {}, state());
  ASSERT_TRUE(open.open("m.mdl", 0.0));
  std::filesystem::rename(scratch.path("project/m.mdl"), scratch.path("elsewhere/m.mdl"));
  ASSERT_TRUE(open.look_at_disk(1.0));
  EXPECT_EQ(open.take_notices().size(), 1U);
  std::filesystem::rename(scratch.path("elsewhere/m.mdl"), scratch.path("project/m.mdl"));
  const std::uint64_t before = open.revision();
  EXPECT_TRUE(open.look_at_disk(2.0));
  EXPECT_GT(open.revision(), before);
  EXPECT_TRUE(open.take_notices().empty());
}

TEST_F(FilesOfDocuments, NothingIsSavedInPlaceOfTheMissionThatIsOpen) {
  OpenDocuments open(project, {}, state());
  ASSERT_TRUE(make(open, "m.mdl"));
  EditText empty;
  empty.set_document("m.mdl");
  empty.set_revision(find(open, "m.mdl")->text.revision());
  empty.set_end(static_cast<std::uint32_t>(text(open, "m.mdl").size()));
  ASSERT_TRUE(open.edit_text(empty, 0.0));
  SaveDocuments save;
  save.add_documents("m.odl");
  save.set_as("m.mdl");
  EXPECT_EQ(open.save(save).error().kind, "file-exists");
  EXPECT_EQ(open.mission_path(), "m.mdl");
  save.clear_documents();
  save.add_documents("m.mdl");
  ASSERT_TRUE(open.save(save));
  EXPECT_EQ(open.mission_path(), "m.mdl");
}

}  // namespace
}  // namespace mlab::console
