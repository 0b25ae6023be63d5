#include "mlab/console/documents.h"

#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "mlab/console/testing/scratch_project.h"

namespace mlab::console {
namespace {

constexpr const char* kMission =
    "MISSION NAME \"m\"\nOVERLAY m.odl\nUNIT <u> ROBOT ROBOT\nCOMMAND LIST:\n 0. UNIT u START AA-AA1\n 1. "
    "UNIT u "
    "MOVETO PP-Charlie\n";
constexpr const char* kOverlay =
    "-- the map\nMISSION-AREA 500 400\nCONTROL MEASURES:\nAA AA1 50 50\nPP Charlie 200 100 -- here\nOBSTACLE "
    "90 90 5\n";

class DocumentsOfAMission : public ::testing::Test {
 protected:
  DocumentsOfAMission() {
    scratch.write("project/m.mdl", kMission);
    scratch.write("project/m.odl", kOverlay);
  }

  ProjectFolder folder() const {
    return ProjectFolder({scratch.path("project").string(), scratch.path("examples").string()});
  }
  std::string state() const { return scratch.path("state").string(); }

  // Replaces the one occurrence of `what`.
  static text::Result<bool> change(OpenDocuments& open, const std::string& path, const std::string& what,
                                   const std::string& by, double now = 0.0, const std::string& name = "") {
    EditText edit;
    edit.set_document(path);
    edit.set_text(by);
    edit.set_name(name);
    for (const OpenDocument* document : open.documents()) {
      if (document->path != path) continue;
      const std::size_t at = document->source->text().find(what);
      EXPECT_NE(at, std::string_view::npos) << what;
      edit.set_revision(document->revision);
      edit.set_begin(static_cast<std::uint32_t>(at));
      edit.set_end(static_cast<std::uint32_t>(at + what.size()));
    }
    return open.edit_text(edit, now);
  }
  static std::string text(const OpenDocuments& open, const std::string& path) {
    for (const OpenDocument* document : open.documents()) {
      if (document->path == path) return std::string(document->source->text());
    }
    return "not open";
  }

  testing::ScratchProject scratch;
};

TEST_F(DocumentsOfAMission, OpensTheMissionWithItsOverlays) {
  ProjectFolder project = folder();
  OpenDocuments open(project, {}, state());
  ASSERT_TRUE(open.open("m.mdl", 0.0));
  ASSERT_NE(open.mission(), nullptr);
  EXPECT_EQ(open.mission()->steps.size(), 2U);
  const Documents message = open.documents_message();
  ASSERT_EQ(message.documents_size(), 2);
  EXPECT_EQ(message.documents(0).path(), "m.mdl");
  EXPECT_EQ(message.documents(1).text(), kOverlay);
  EXPECT_FALSE(message.documents(1).is_dirty());
  const Scene& scene = open.scene();
  EXPECT_EQ(scene.width(), 500.0);
  ASSERT_EQ(scene.measures_size(), 2);
  EXPECT_EQ(scene.measures(1).name(), "Charlie");
  EXPECT_EQ(scene.measures(1).document(), "m.odl");
  EXPECT_EQ(scene.measures(1).line(), 5U);
  ASSERT_EQ(scene.obstacles_size(), 1);
  EXPECT_EQ(scene.obstacles(0).document(), "m.odl");
}

TEST_F(DocumentsOfAMission, RunTheEditedTextAndNotTheFile) {
  ProjectFolder project = folder();
  OpenDocuments open(project, {}, state());
  ASSERT_TRUE(open.open("m.mdl", 0.0));
  ASSERT_TRUE(change(open, "m.odl", "200 100", "210 100"));
  EXPECT_EQ(open.mission()->overlay.measures[1].points[0].x, 210.0);
  EXPECT_EQ(scratch.read("project/m.odl"), kOverlay);
  EXPECT_TRUE(open.edit_state().is_dirty());
}

TEST_F(DocumentsOfAMission, KeepTheLastGoodMissionWhileTheTextsHaveErrors) {
  ProjectFolder project = folder();
  OpenDocuments open(project, {}, state());
  ASSERT_TRUE(open.open("m.mdl", 0.0));
  const auto good = open.mission();
  ASSERT_TRUE(change(open, "m.mdl", "PP-Charlie", "PP-Charl"));
  EXPECT_EQ(open.mission(), good);
  const Documents message = open.documents_message();
  EXPECT_TRUE(message.runs_older_text());
  ASSERT_EQ(message.documents(0).diagnostics_size(), 1);
  const Diagnostic& diagnostic = message.documents(0).diagnostics(0);
  EXPECT_EQ(diagnostic.kind(), "unknown-control-measure");
  EXPECT_EQ(diagnostic.line(), 6U);
  EXPECT_EQ(message.documents(0).text().substr(diagnostic.begin(), diagnostic.end() - diagnostic.begin()),
            "PP-Charl");
  EXPECT_EQ(open.scene().measures_size(), 2);
  ASSERT_TRUE(open.undo());
  EXPECT_FALSE(open.documents_message().runs_older_text());
  EXPECT_NE(open.mission(), nullptr);
}

TEST_F(DocumentsOfAMission, RefuseAnEditOfAnOlderText) {
  ProjectFolder project = folder();
  OpenDocuments open(project, {}, state());
  ASSERT_TRUE(open.open("m.mdl", 0.0));
  EditText edit;
  edit.set_document("m.mdl");
  edit.set_revision(7);
  EXPECT_EQ(open.edit_text(edit, 0.0).error().kind, "older-text");
  edit.set_revision(1);
  edit.set_begin(3);
  edit.set_end(100000);
  EXPECT_EQ(open.edit_text(edit, 0.0).error().kind, "no-such-range");
  edit.set_document("other.mdl");
  EXPECT_EQ(open.edit_text(edit, 0.0).error().kind, "no-document");
}

}  // namespace
}  // namespace mlab::console
