#include "mlab/console/documents/documents.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "mlab/documents/testing/scratch_project.h"
#include "mlab/lang/cnl/compiler_room.h"
#include "mlab/text/line_ends.h"

namespace mlab::console {
namespace {

constexpr const char* kPlan =
    "MISSION NAME \"m\"\nOVERLAY m.odl\nUNIT <u> ROBOT ROBOT\nCOMMAND LIST:\n 0. UNIT u START AA-AA1\n 1. "
    "UNIT u "
    "MOVETO PP-Charlie\n";
constexpr const char* kOverlay =
    "-- the map\nMISSION-AREA 500 400\nCONTROL MEASURES:\nAA AA1 50 50\nPP Charlie 200 100 -- here\nOBSTACLE "
    "90 90 5\n";

class DocumentsOfAMission : public ::testing::Test {
 protected:
  DocumentsOfAMission() {
    scratch.write("project/m.mdl", kPlan);
    scratch.write("project/m.odl", kOverlay);
  }

  documents::ProjectFolder folder() const {
    return documents::ProjectFolder({scratch.path("project").string(), scratch.path("examples").string()});
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
      const std::size_t at = document->text.text().find(what);
      EXPECT_NE(at, std::string_view::npos) << what;
      edit.set_revision(document->text.revision());
      edit.set_begin(static_cast<std::uint32_t>(at));
      edit.set_end(static_cast<std::uint32_t>(at + what.size()));
    }
    return open.edit_text(edit, now);
  }
  static std::string text(const OpenDocuments& open, const std::string& path) {
    for (const OpenDocument* document : open.documents()) {
      if (document->path == path) return std::string(document->text.text());
    }
    return "not open";
  }

  documents::testing::ScratchProject scratch;
};

TEST_F(DocumentsOfAMission, AreNothingThatCodeOfTheProjectMayInclude) {
  for (const char* file : {"a.mdl", "sub/b.odl", "c.ovl", "d.MDL"}) {
    EXPECT_TRUE(folder().is_writable(file)) << file;
    EXPECT_FALSE(cnl::is_source(file)) << file;
  }
}

TEST_F(DocumentsOfAMission, OpensTheMissionWithItsOverlays) {
  documents::ProjectFolder project = folder();
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
  documents::ProjectFolder project = folder();
  OpenDocuments open(project, {}, state());
  ASSERT_TRUE(open.open("m.mdl", 0.0));
  ASSERT_TRUE(change(open, "m.odl", "200 100", "210 100"));
  EXPECT_EQ(open.mission()->overlay.measures[1].points[0].x, 210.0);
  EXPECT_EQ(scratch.read("project/m.odl"), kOverlay);
  EXPECT_TRUE(open.edit_state().is_dirty());
}

TEST_F(DocumentsOfAMission, KeepTheLastGoodMissionWhileTheTextsHaveErrors) {
  documents::ProjectFolder project = folder();
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
  documents::ProjectFolder project = folder();
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

// ---- the map

MapChange add_place(const std::string& name, double x, double y) {
  MapChange out;
  Measure& measure = *out.mutable_add_measure();
  measure.set_kind(Measure::PASSAGE_POINT);
  measure.set_name(name);
  measure.set_shows_label(true);
  measure.add_points()->set_x(x);
  measure.mutable_points(0)->set_y(y);
  return out;
}

EditMap edit_of(const std::vector<MapChange>& changes, const std::string& name = "edit") {
  EditMap out;
  out.set_name(name);
  for (const MapChange& change : changes) *out.add_changes() = change;
  return out;
}

TEST_F(DocumentsOfAMission, ChangeWithTheMapAndBackAgain) {
  documents::ProjectFolder project = folder();
  OpenDocuments open(project, {}, state());
  ASSERT_TRUE(open.open("m.mdl", 0.0));
  const std::uint64_t revision = open.scene().revision();
  MapChange rename;
  rename.mutable_replace_measure()->set_index(1);
  *rename.mutable_replace_measure()->mutable_measure() = open.scene().measures(1);
  rename.mutable_replace_measure()->mutable_measure()->set_name("Delta");
  ASSERT_TRUE(open.edit_map(edit_of({rename, add_place("New", 5, 6)}, "rename Charlie"), 0.0));
  EXPECT_GT(open.scene().revision(), revision);
  EXPECT_EQ(open.scene().measures(1).name(), "Delta");
  EXPECT_FALSE(open.has_errors());
  EXPECT_TRUE(text(open, "m.mdl").contains("MOVETO PP-Delta"));
  EXPECT_EQ(open.edit_state().undo(), "rename Charlie");
  ASSERT_TRUE(open.undo());
  EXPECT_EQ(text(open, "m.mdl"), kPlan);
  EXPECT_EQ(text(open, "m.odl"), kOverlay);
  ASSERT_TRUE(open.redo());
  EXPECT_EQ(open.scene().measures(2).name(), "New");
}

TEST_F(DocumentsOfAMission, GetAnOverlayWhenSomethingIsDrawnAndThereIsNone) {
  scratch.write("project/bare.mdl",
                "-- bare\nMISSION NAME \"x\" -- title\nUNIT <u> ROBOT\nCOMMAND LIST:\n0. QUIT\n");
  scratch.write("project/bare.odl", "somebody else's");
  documents::ProjectFolder project = folder();
  OpenDocuments open(project, {}, state());
  ASSERT_TRUE(open.open("bare.mdl", 0.0));
  for (int round = 0; round < 2; ++round) {
    ASSERT_TRUE(open.edit_map(edit_of({add_place("A", 1, 2)}), 0.0));
    EXPECT_EQ(text(open, "bare_2.odl"), "CONTROL MEASURES:\nPP A 1 2\n");
    EXPECT_EQ(text(open, "bare.mdl"),
              "-- bare\nMISSION NAME \"x\" -- title\nOVERLAY \"bare_2.odl\"\nUNIT <u> ROBOT\nCOMMAND "
              "LIST:\n0. QUIT\n");
    EXPECT_FALSE(open.has_errors());
    ASSERT_TRUE(open.undo());
    EXPECT_EQ(open.documents().size(), 1U);
    EXPECT_FALSE(open.edit_state().is_dirty());
  }
  ASSERT_TRUE(open.redo());
  ASSERT_TRUE(open.save({}));
  EXPECT_EQ(scratch.read("project/bare_2.odl"), "CONTROL MEASURES:\nPP A 1 2\n");
  EXPECT_EQ(scratch.read("project/bare.odl"), "somebody else's");
  EXPECT_FALSE(open.edit_map(edit_of({add_place("q\"", 1, 2)}), 0.0));
}

TEST_F(DocumentsOfAMission, AreAsTheyWereWhereTheFirstThatIsDrawnIsRefused) {
  scratch.write("project/bare.mdl", "MISSION NAME x\nUNIT <u> ROBOT\nCOMMAND LIST:\n0. QUIT\n");
  documents::ProjectFolder project = folder();
  OpenDocuments open(project, {}, state());
  ASSERT_TRUE(open.open("bare.mdl", 0.0));
  EXPECT_FALSE(open.edit_map(edit_of({add_place("q\"", 1, 2)}), 0.0));
  EXPECT_EQ(open.documents().size(), 1U);
  EXPECT_FALSE(open.edit_state().is_dirty());
}

TEST_F(DocumentsOfAMission, CreateObstaclesAsOneEdit) {
  documents::ProjectFolder project = folder();
  OpenDocuments open(project, {}, state());
  ASSERT_TRUE(open.open("m.mdl", 0.0));
  CreateObstacles request;
  request.set_coverage_percent(3);
  request.set_min_radius(2);
  request.set_max_radius(6);
  request.set_replace(true);
  ASSERT_TRUE(open.create_obstacles(request, 77, 0.0));
  EXPECT_GT(open.scene().obstacles_size(), 10);
  EXPECT_EQ(open.mission()->overlay.obstacles.size(),
            static_cast<std::size_t>(open.scene().obstacles_size()));
  EXPECT_EQ(open.edit_state().undo(), "random obstacles, seed 77");
  ASSERT_TRUE(open.undo());
  EXPECT_EQ(text(open, "m.odl"), kOverlay);
}

// ---- undo

RC_GTEST_FIXTURE_PROP(DocumentsOfAMission, ComeBackByteForByteWhateverWasEdited, ()) {
  documents::ProjectFolder project = folder();
  OpenDocuments open(project, {}, "");
  RC_ASSERT(open.open("m.mdl", 0.0).has_value());
  double now = 0.0;
  int other = 0;
  const int edits = *rc::gen::inRange(1, 25);
  for (int i = 0; i < edits; ++i) {
    now += *rc::gen::inRange(0, 3) * 0.6;
    const int what = *rc::gen::inRange(0, 8);
    if (what == 0) {
      open.undo();
    } else if (what == 1) {
      open.redo();
    } else if (what == 2) {
      other += 3;
      open.add_edit({"other", [&other] { other -= 3; }, [&other] { other += 3; }}, now);
    } else if (what == 3) {
      std::ignore = open.edit_map(edit_of({add_place("P" + std::to_string(i), i, 2 * i)}, "draw"), now);
    } else if (what == 4) {
      MapChange remove;
      remove.set_remove_measure(*rc::gen::inRange(0U, 4U));
      std::ignore = open.edit_map(edit_of({remove}, "remove"), now);
    } else {
      const auto documents = open.documents();
      const OpenDocument& document = *documents[*rc::gen::inRange<std::size_t>(0, documents.size())];
      EditText edit;
      edit.set_document(document.path);
      edit.set_revision(document.text.revision());
      const auto size = static_cast<std::uint32_t>(document.text.text().size());
      edit.set_begin(*rc::gen::inRange(0U, size + 1));
      edit.set_end(std::min(size, edit.begin() + *rc::gen::inRange(0U, 30U)));
      edit.set_text(*rc::gen::elementOf(
          std::vector<std::string>{"", "x", "PP a 1 2\n", "\"", "-- c\n", "OVERLAY m.odl\n"}));
      edit.set_name(*rc::gen::elementOf(std::vector<std::string>{"", "type", "paste"}));
      RC_ASSERT(open.edit_text(edit, now).has_value());
    }
  }
  std::vector<std::string> end;
  for (const OpenDocument* document : open.documents()) end.emplace_back(document->text.text());
  const int other_end = other;
  while (open.redo()) {
  }
  std::vector<std::string> last;
  for (const OpenDocument* document : open.documents()) last.emplace_back(document->text.text());
  const int other_last = other;
  while (open.undo()) {
  }
  RC_ASSERT(text(open, "m.mdl") == kPlan);
  RC_ASSERT(text(open, "m.odl") == kOverlay);
  RC_ASSERT(open.documents().size() == 2U);
  RC_ASSERT(other == 0);
  while (open.redo()) {
  }
  std::vector<std::string> again;
  for (const OpenDocument* document : open.documents()) again.emplace_back(document->text.text());
  RC_ASSERT(again == last);
  RC_ASSERT(other == other_last);
  RC_ASSERT(open.edit_state().redo().empty());
  RC_ASSERT(other_end <= other_last);
}

// ---- saving

TEST_F(DocumentsOfAMission, AreSavedAsTheyStand) {
  documents::ProjectFolder project = folder();
  OpenDocuments open(project, {}, state());
  ASSERT_TRUE(open.open("m.mdl", 0.0));
  ASSERT_TRUE(change(open, "m.odl", "here", "there"));
  ASSERT_TRUE(open.save({}));
  EXPECT_TRUE(scratch.read("project/m.odl").contains("-- there"));
  EXPECT_FALSE(open.edit_state().is_dirty());
  ASSERT_TRUE(open.undo());
  EXPECT_TRUE(open.edit_state().is_dirty());
  ASSERT_TRUE(open.save({}));
  EXPECT_EQ(scratch.read("project/m.odl"), kOverlay);
}

TEST_F(DocumentsOfAMission, TakeOverWhatChangedOnDiskWhereNothingIsUnsaved) {
  documents::ProjectFolder project = folder();
  OpenDocuments open(project, {}, state());
  ASSERT_TRUE(open.open("m.mdl", 0.0));
  EXPECT_FALSE(open.look_at_disk(0.0));
  scratch.write("project/m.odl", "CONTROL MEASURES:\nAA AA1 50 50\nPP Charlie 300 100\n");
  const std::uint64_t before = open.revision();
  EXPECT_FALSE(open.look_at_disk(1.0)) << "somebody may be writing it just now";
  EXPECT_TRUE(open.look_at_disk(1.0));
  EXPECT_GT(open.revision(), before);
  EXPECT_EQ(open.mission()->overlay.measures[1].points[0].x, 300.0) << "the run can follow";
  EXPECT_EQ(open.documents_message().documents(1).taken_over(), 1U);
  EXPECT_FALSE(open.edit_state().is_dirty());
  EXPECT_EQ(open.edit_state().undo(), "take over the changed file");
  EXPECT_EQ(open.take_notices().size(), 1U);
  ASSERT_TRUE(open.undo());
  EXPECT_EQ(text(open, "m.odl"), kOverlay);
  EXPECT_TRUE(open.edit_state().is_dirty());
  EXPECT_FALSE(open.look_at_disk(2.0)) << "nobody has changed it again";
}

TEST_F(DocumentsOfAMission, AskWhereAFileChangedUnderUnsavedEdits) {
  documents::ProjectFolder project = folder();
  OpenDocuments open(project, {}, state());
  ASSERT_TRUE(open.open("m.mdl", 0.0));
  ASSERT_TRUE(change(open, "m.odl", "here", "mine"));
  scratch.write("project/m.odl", std::string(kOverlay) + "PP Delta 1 1\n");
  EXPECT_FALSE(open.look_at_disk(1.0)) << "somebody may be writing it just now";
  EXPECT_TRUE(open.look_at_disk(1.0));
  EXPECT_EQ(open.documents_message().documents(1).disk(), Documents::CHANGED);
  EXPECT_FALSE(text(open, "m.odl").contains("Delta"));
  ReloadDocument reload;
  reload.set_document("m.odl");
  reload.set_merge(true);
  ASSERT_TRUE(open.reload(reload, 2.0));
  EXPECT_TRUE(text(open, "m.odl").contains("-- mine"));
  EXPECT_TRUE(text(open, "m.odl").contains("Delta"));
  EXPECT_EQ(open.scene().measures_size(), 3);
  EXPECT_EQ(open.documents_message().documents(1).disk(), Documents::SAME);
  ASSERT_TRUE(open.undo());
  EXPECT_FALSE(text(open, "m.odl").contains("Delta"));
  reload.set_document("other.odl");
  EXPECT_EQ(open.reload(reload, 3.0).error().kind, "no-document");
}

TEST_F(DocumentsOfAMission, AreWrittenOverTheDiskOnlyWhereThatIsWanted) {
  documents::ProjectFolder project = folder();
  OpenDocuments open(project, {}, state());
  ASSERT_TRUE(open.open("m.mdl", 0.0));
  ASSERT_TRUE(change(open, "m.odl", "here", "mine"));
  scratch.write("project/m.odl", "theirs");
  SaveDocuments save;
  save.add_documents("m.odl");
  EXPECT_EQ(open.save(save).error().kind, "changed-on-disk");
  EXPECT_EQ(open.documents_message().documents(1).disk(), Documents::CHANGED) << "the page asks";
  save.set_overwrite(true);
  ASSERT_TRUE(open.save(save));
  EXPECT_TRUE(scratch.read("project/m.odl").contains("mine"));
  std::filesystem::remove(scratch.path("project/m.odl"));
  EXPECT_TRUE(open.look_at_disk(1.0));
  EXPECT_EQ(open.documents_message().documents(1).disk(), Documents::GONE);
  ASSERT_TRUE(open.save({}));
  EXPECT_TRUE(scratch.read("project/m.odl").contains("mine"));
}

TEST_F(DocumentsOfAMission, KeepTheLineEndsOfTheirFiles) {
  scratch.write("project/m.mdl", mlab::text::lines_as_in("\r\n", kPlan));
  documents::ProjectFolder project = folder();
  OpenDocuments open(project, {}, state());
  ASSERT_TRUE(open.open("m.mdl", 0.0));
  EXPECT_EQ(text(open, "m.mdl"), kPlan);
  EXPECT_FALSE(open.documents_message().documents(0).is_dirty());
  ASSERT_TRUE(change(open, "m.mdl", "\"m\"", "\"n\""));
  ASSERT_TRUE(open.save({}));
  EXPECT_TRUE(scratch.read("project/m.mdl").contains("\"n\"\r\n"));
  EXPECT_TRUE(mlab::text::has_dos_lines(scratch.read("project/m.mdl")));
}

TEST_F(DocumentsOfAMission, NeverOverwriteWhatSomebodyElseWrote) {
  documents::ProjectFolder project = folder();
  OpenDocuments open(project, {}, state());
  ASSERT_TRUE(open.open("m.mdl", 0.0));
  ASSERT_TRUE(change(open, "m.odl", "here", "mine"));
  ASSERT_TRUE(change(open, "m.mdl", "\"m\"", "\"n\""));
  scratch.write("project/m.odl", "theirs");
  const auto saved = open.save({});
  ASSERT_FALSE(saved);
  EXPECT_EQ(saved.error().kind, "changed-on-disk");
  EXPECT_EQ(scratch.read("project/m.odl"), "theirs");
  EXPECT_TRUE(scratch.read("project/m.mdl").contains("\"n\"")) << "the other one is saved";
  std::filesystem::remove(scratch.path("project/m.odl"));
  EXPECT_TRUE(open.save({})) << "a file that is gone is written anew";
  EXPECT_TRUE(scratch.read("project/m.odl").contains("mine"));
}

TEST_F(DocumentsOfAMission, OfAnExampleAreSavedIntoTheProjectWithTheirOverlay) {
  scratch.write("examples/demo/d.mdl", kPlan);
  scratch.write("examples/demo/m.odl", kOverlay);
  documents::ProjectFolder project = folder();
  OpenDocuments open(project, {}, state());
  ASSERT_TRUE(open.open("examples:demo/d.mdl", 0.0));
  EXPECT_TRUE(open.documents_message().documents(0).is_read_only());
  ASSERT_TRUE(change(open, "examples:demo/d.mdl", "\"m\"", "\"mine\""));
  ASSERT_TRUE(change(open, "examples:demo/m.odl", "here", "there"));
  EXPECT_EQ(open.save({}).error().kind, "read-only");
  SaveDocuments as;
  as.add_documents("examples:demo/d.mdl");
  as.set_as("m.mdl");
  EXPECT_EQ(open.save(as).error().kind, "file-exists");
  as.set_as("copies/d.mdl");
  ASSERT_TRUE(open.save(as));
  EXPECT_EQ(open.mission_path(), "copies/d.mdl");
  EXPECT_FALSE(open.has_errors());
  EXPECT_TRUE(scratch.read("project/copies/m.odl").contains("-- there"));
  EXPECT_EQ(scratch.read("examples/demo/m.odl"), kOverlay);
  EXPECT_FALSE(open.edit_state().is_dirty());
  ASSERT_TRUE(open.undo());
  EXPECT_TRUE(text(open, "copies/m.odl").contains("-- here"));
}

TEST_F(DocumentsOfAMission, AreMadeAnewAndRunAtOnce) {
  documents::ProjectFolder project = folder();
  OpenDocuments open(project, {}, state());
  NewDocument request;
  request.set_path("new/scouts.mdl");
  ASSERT_TRUE(open.create(request, 0.0));
  ASSERT_NE(open.mission(), nullptr) << open.documents_message().ShortDebugString();
  EXPECT_EQ(open.mission()->name, "scouts");
  EXPECT_EQ(open.documents().size(), 2U);
  EXPECT_TRUE(open.edit_state().is_dirty());
  NewDocument second;
  second.set_kind(NewDocument::OVERLAY);
  second.set_path("new/more places.odl");
  ASSERT_TRUE(open.create(second, 0.0));
  EXPECT_FALSE(open.has_errors());
  EXPECT_EQ(open.documents().size(), 3U);
  ASSERT_TRUE(open.save({}));
  EXPECT_TRUE(scratch.read("project/new/scouts.mdl").contains("OVERLAY \"more places.odl\""));
  EXPECT_EQ(scratch.read("project/new/more places.odl"), "CONTROL MEASURES:\n");
  for (const char* bad : {"m.mdl", "../x.mdl", "x.sh", "examples:x.mdl", ""}) {
    request.set_path(bad);
    EXPECT_FALSE(open.create(request, 0.0)) << bad;
  }
}

// ---- drafts

TEST_F(DocumentsOfAMission, SurviveTheDeathOfTheServer) {
  documents::ProjectFolder project = folder();
  {
    OpenDocuments killed(project, {}, state());
    ASSERT_TRUE(killed.open("m.mdl", 0.0));
    ASSERT_TRUE(change(killed, "m.odl", "here", "draft"));
    killed.store().keep_drafts(10.0);
    ASSERT_TRUE(change(killed, "m.odl", "draft", "later draft"));
    killed.store().keep_drafts(10.001);
    OpenDocuments open(project, {}, state());
    ASSERT_TRUE(open.open("m.mdl", 0.0));
    EXPECT_TRUE(text(open, "m.odl").contains("-- later draft"));
    EXPECT_TRUE(open.edit_state().is_dirty());
    EXPECT_EQ(open.edit_state().not_kept(), "");
    EXPECT_EQ(open.take_notices().size(), 1U);
    EXPECT_EQ(open.edit_state().undo(), "restore unsaved text");
    ASSERT_TRUE(open.undo());
    EXPECT_EQ(text(open, "m.odl"), kOverlay);
    ASSERT_TRUE(open.redo());
    ASSERT_TRUE(open.save({}));
    OpenDocuments after(project, {}, state());
    ASSERT_TRUE(after.open("m.mdl", 0.0));
    EXPECT_TRUE(after.take_notices().empty()) << "what is saved is no draft";
    EXPECT_FALSE(after.edit_state().is_dirty());
  }
}

TEST_F(DocumentsOfAMission, SayWhenADraftIsOlderThanItsFile) {
  documents::ProjectFolder project = folder();
  {
    OpenDocuments first(project, {}, state());
    ASSERT_TRUE(first.open("m.mdl", 0.0));
    ASSERT_TRUE(change(first, "m.odl", "here", "draft"));
  }
  scratch.write("project/m.odl", std::string(kOverlay) + "-- theirs\n");
  OpenDocuments open(project, {}, state());
  ASSERT_TRUE(open.open("m.mdl", 0.0));
  const auto notices = open.take_notices();
  ASSERT_EQ(notices.size(), 1U);
  EXPECT_TRUE(notices[0].contains("has changed since"));
  ASSERT_TRUE(open.undo());
  EXPECT_TRUE(text(open, "m.odl").contains("-- theirs"));
}

TEST_F(DocumentsOfAMission, ThatWereNeverSavedAreFoundAgain) {
  documents::ProjectFolder project = folder();
  {
    OpenDocuments first(project, {}, state());
    NewDocument request;
    request.set_path("fresh.mdl");
    ASSERT_TRUE(first.create(request, 0.0));
  }
  OpenDocuments open(project, {}, state());
  const Project message = open.project_message();
  EXPECT_TRUE(std::ranges::any_of(message.missions(), [](const auto& e) { return e.path() == "fresh.mdl"; }));
  ASSERT_TRUE(open.open("fresh.mdl", 0.0));
  EXPECT_FALSE(open.has_errors()) << open.documents_message().ShortDebugString();
  EXPECT_EQ(open.documents().size(), 2U);
}

// ---- what may be opened

TEST_F(DocumentsOfAMission, FromTheCommandLineReadOverlaysOutsideButNoOthers) {
  scratch.write("elsewhere/secret.odl", kOverlay);
  scratch.write("elsewhere/far.odl", kOverlay);
  scratch.write("project/c.mdl",
                "OVERLAY \"" + scratch.path("elsewhere/far.odl").string() + "\"\nCOMMAND LIST:\n0. QUIT\n");
  documents::ProjectFolder project = folder();
  OpenDocuments open(project, {}, state());
  ASSERT_TRUE(open.open("c.mdl", 0.0));
  EXPECT_TRUE(open.has_errors()) << "a browser can't open it";
  ASSERT_TRUE(open.open_on_disk(scratch.path("project/c.mdl").string(), 0.0));
  EXPECT_FALSE(open.has_errors());
  ASSERT_EQ(open.documents().size(), 2U);
  EXPECT_FALSE(open.documents()[1]->is_writable);
  ASSERT_TRUE(change(open, "c.mdl", "far.odl", "secret.odl"));
  EXPECT_TRUE(open.has_errors());
  EXPECT_EQ(open.documents().size(), 1U);
  ASSERT_TRUE(open.open_on_disk(scratch.path("elsewhere/../project/m.mdl").string(), 0.0));
  EXPECT_EQ(open.mission_path(), "m.mdl");
  EXPECT_FALSE(open.open_on_disk("/dev/stdin", 0.0));
  EXPECT_FALSE(open.open("nothing.mdl", 0.0));
  EXPECT_EQ(open.mission_path(), "m.mdl") << "what was open stays open";
}

TEST_F(DocumentsOfAMission, InLatin1AreReadAndSavedAsUtf8) {
  scratch.write("project/m.odl", std::string(kOverlay) +
                                     "-- Stra\xdf"
                                     "e\n");
  documents::ProjectFolder project = folder();
  OpenDocuments open(project, {}, state());
  ASSERT_TRUE(open.open("m.mdl", 0.0));
  EXPECT_TRUE(text(open, "m.odl").contains("Stra\u00dfe"));
  EXPECT_EQ(open.take_notices().size(), 1U);
  EXPECT_FALSE(open.edit_state().is_dirty()) << "nobody has changed anything";
  ASSERT_TRUE(change(open, "m.odl", "200 100", "210 100"));
  ASSERT_TRUE(open.save({}));
  EXPECT_TRUE(scratch.read("project/m.odl").contains("Stra\u00dfe"));
}

TEST_F(DocumentsOfAMission, TellRecentOnesAndExamples) {
  scratch.write("examples/demo/d.mdl", kPlan);
  documents::ProjectFolder project = folder();
  OpenDocuments open(project, {}, state());
  ASSERT_TRUE(open.open("m.mdl", 0.0));
  const Project message = open.project_message();
  ASSERT_EQ(message.recent_size(), 1);
  EXPECT_EQ(message.recent(0).path(), "m.mdl");
  EXPECT_EQ(message.recent(0).title(), "m");
  EXPECT_EQ(message.examples(0).path(), "examples:demo/d.mdl");
  EXPECT_EQ(message.missions(0).path(), "m.mdl");
  EXPECT_EQ(message.mission(), "m.mdl");
}

}  // namespace
}  // namespace mlab::console
