// Definition, uses and other names of what the mission's texts name, by messages.

#include <chrono>
#include <string>

#include <gtest/gtest.h>

#include "mlab/console/session.h"
#include "mlab/console/testing/browser.h"
#include "mlab/documents/drafts.h"
#include "mlab/documents/testing/scratch_project.h"

namespace mlab::console {
namespace {

using documents::testing::ScratchProject;
using testing::Browser;
using testing::TestSession;

constexpr const char* kFarMission =
    "OVERLAY \"map.odl\"\n"
    "NEW-ROBOT scout \"robots.cdl#Scout\" (urge = 0.7)\n"
    "UNIT <pair> scout scout\n"
    "COMMAND LIST:\n"
    "0. UNIT pair START 100 100 0 40\n"
    "1. UNIT pair MOVETO PP-Far\n";
constexpr const char* kOtherMission =
    "OVERLAY \"map.odl\"\n"
    "UNIT <trio> ROBOT\n"
    "COMMAND LIST:\n"
    "0. UNIT trio START 100 100\n"
    "1. UNIT trio MOVETO PP-Far\n";
constexpr const char* kFarMap =
    "MISSION-AREA 2000 1000\n"
    "CONTROL MEASURES:\n"
    "PP Far 1900 100\n"
    "PP Near 200 100\n";
constexpr const char* kScoutRobots =
    "robot Scout(urge: gain = 0.5, far: Point = place(\"Far\")) is Scout {\n"
    "  movement = cooperate { urge: Noise(); 1: MoveToGoal(DetectGoal(far)); };\n"
    "}\n"
    "robot Idler is Scout {\n"
    "  movement = Wander();\n"
    "}\n";

bool has_words(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

class SessionNames : public ::testing::Test {
 protected:
  SessionNames()
      : session_((write(), ""), 10.0,
                 [&](SessionSettings& s) {
                   s.project_folder = project_.path("project").string();
                   s.state_folder = project_.path("state").string();
                   s.mission = project_.path("project/far.mdl").string();
                 }),
        anna_(session_, "Anna") {
    EXPECT_TRUE(anna_.wait([&] { return anna_.status().mode() == Status::READY; }, 20.0));
  }
  void write() {
    project_.write("project/far.mdl", kFarMission);
    project_.write("project/other.mdl", kOtherMission);
    project_.write("project/map.odl", kFarMap);
    project_.write("project/robots.cdl", kScoutRobots);
  }
  std::string file(const std::string& name) { return project_.read("project/" + name); }
  const Documents::Document& document(const std::string& path) {
    static const Documents::Document kNone;
    for (const Documents::Document& one : anna_.documents().documents()) {
      if (one.path() == path) return one;
    }
    return kNone;
  }
  static names::At at(const std::string& path, const std::string& text, const std::string& before_what) {
    names::At out;
    out.set_document(path);
    out.set_cursor(static_cast<std::uint32_t>(text.find(before_what)));
    return out;
  }
  Reply plan(const names::At& where, const std::string& name) {
    ToServer message;
    *message.mutable_plan_rename()->mutable_at() = where;
    message.mutable_plan_rename()->set_name(name);
    return anna_.ask(message);
  }
  static ToServer renaming(const names::At& where, const std::string& name, const std::string& seal) {
    ToServer message;
    *message.mutable_rename_everywhere()->mutable_at() = where;
    message.mutable_rename_everywhere()->set_name(name);
    message.mutable_rename_everywhere()->set_seal(seal);
    return message;
  }
  Reply rename(const names::At& where, const std::string& name) {
    return anna_.ask(renaming(where, name, plan(where, name).plan().seal()));
  }
  std::string undo() {
    ToServer message;
    message.mutable_undo();
    return Browser::error_of(anna_.ask(message));
  }
  std::string redo() {
    ToServer message;
    message.mutable_redo();
    return Browser::error_of(anna_.ask(message));
  }
  std::string type(const std::string& path, const std::string& text) {
    ToServer message;
    EditText& edit = *message.mutable_edit_text();
    edit.set_document(path);
    edit.set_revision(document(path).revision());
    edit.set_text(text);
    return Browser::error_of(anna_.ask(message));
  }
  Reply definition(const names::At& where) {
    ToServer message;
    *message.mutable_find_definition()->mutable_at() = where;
    return anna_.ask(message);
  }
  bool wait_for_text(const std::string& path, const std::string& part) {
    return anna_.wait([&] { return has_words(document(path).text(), part); }, 10.0);
  }

  ScratchProject project_;
  TestSession session_;
  Browser anna_;
};

TEST_F(SessionNames, DefinitionsAreFoundInOverlaysAndConfigurationsAndTheLibrary) {
  const Reply place = definition(at("far.mdl", kFarMission, "Far"));
  ASSERT_TRUE(place.ok()) << place.error();
  EXPECT_EQ(place.place().path(), "map.odl");
  EXPECT_EQ(place.place().line(), 3U);
  const Reply parameter = definition(at("far.mdl", kFarMission, "urge"));
  ASSERT_TRUE(parameter.ok()) << parameter.error();
  EXPECT_EQ(parameter.place().path(), "robots.cdl");
  EXPECT_EQ(parameter.place().line(), 1U);
  const Reply library = definition(at("robots.cdl", kScoutRobots, "Wander"));
  ASSERT_TRUE(library.ok()) << library.error();
  EXPECT_TRUE(library.place().path().starts_with("library:")) << library.place().path();
  ToServer read;
  read.mutable_read_text()->set_path(library.place().path());
  const Reply text = anna_.ask(read);
  ASSERT_TRUE(text.ok()) << text.error();
  EXPECT_EQ(text.text().text().substr(library.place().begin(), 6), "Wander");
  EXPECT_FALSE(definition(at("far.mdl", kFarMission, "MOVETO")).ok());
  EXPECT_FALSE(definition(at("no_such.mdl", kFarMission, "pair")).ok());
}

TEST_F(SessionNames, OnlyTextsOfTheProjectAreRead) {
  project_.write("project/secret.txt", "secret");
  project_.write("outside.mdl", kOtherMission);
  for (const char* path : {"secret.txt", "../outside.mdl", "/etc/passwd", "library:../x.cdl", ""}) {
    ToServer read;
    read.mutable_read_text()->set_path(path);
    EXPECT_FALSE(anna_.ask(read).ok()) << path;
  }
}

TEST_F(SessionNames, UsesAreFoundInAllFilesOfTheProject) {
  ToServer message;
  *message.mutable_find_uses()->mutable_at() = at("far.mdl", kFarMission, "Far");
  const Reply found = anna_.ask(message);
  ASSERT_TRUE(found.ok()) << found.error();
  std::vector<std::string> files;
  for (const names::File& one : found.uses().files())
    files.push_back(one.path() + " " + std::to_string(one.uses_size()));
  EXPECT_EQ(files, (std::vector<std::string>{"far.mdl 1", "map.odl 1", "other.mdl 1", "robots.cdl 1"}));
}

TEST_F(SessionNames, ARenamingIsOneEditOfAllFilesAndUndoTakesAllOfItBack) {
  const names::At far = at("far.mdl", kFarMission, "Far");
  const Reply shown = plan(far, "Gate");
  ASSERT_TRUE(shown.ok()) << shown.error();
  EXPECT_EQ(shown.plan().files_size(), 4);
  EXPECT_EQ(file("map.odl"), kFarMap) << "nothing is done yet";
  const Reply done = rename(far, "Gate");
  ASSERT_TRUE(done.ok()) << done.error();
  ASSERT_TRUE(wait_for_text("far.mdl", "MOVETO PP-Gate"));
  EXPECT_TRUE(has_words(file("far.mdl"), "MOVETO PP-Gate")) << "what was saved is saved";
  EXPECT_TRUE(has_words(file("map.odl"), "PP Gate 1900"));
  EXPECT_TRUE(has_words(file("other.mdl"), "MOVETO PP-Gate"));
  EXPECT_TRUE(has_words(file("robots.cdl"), "place(\"Gate\")"));
  EXPECT_TRUE(anna_.wait([&] { return anna_.edits().undo() == "rename Far to Gate"; }, 10.0));
  EXPECT_TRUE(anna_.wait([&] { return !anna_.edits().is_dirty(); }, 10.0));
  EXPECT_TRUE(anna_.wait([&] { return anna_.has_log("rename Far to Gate"); }, 10.0));

  ASSERT_EQ(undo(), "");
  ASSERT_TRUE(wait_for_text("far.mdl", "MOVETO PP-Far"));
  EXPECT_EQ(file("far.mdl"), kFarMission);
  EXPECT_EQ(file("map.odl"), kFarMap);
  EXPECT_EQ(file("other.mdl"), kOtherMission);
  EXPECT_EQ(file("robots.cdl"), kScoutRobots);
  ASSERT_EQ(redo(), "");
  ASSERT_TRUE(wait_for_text("far.mdl", "MOVETO PP-Gate"));
  EXPECT_TRUE(has_words(file("other.mdl"), "MOVETO PP-Gate"));
  EXPECT_TRUE(has_words(file("far.mdl"), "MOVETO PP-Gate"));
}

TEST_F(SessionNames, UnsavedWorkStaysUnsaved) {
  ASSERT_EQ(type("far.mdl", "-- mine\n"), "");
  ASSERT_TRUE(wait_for_text("far.mdl", "-- mine"));
  const Reply done = rename(at("far.mdl", document("far.mdl").text(), "pair"), "team");
  ASSERT_TRUE(done.ok()) << done.error();
  ASSERT_TRUE(wait_for_text("far.mdl", "UNIT <team>"));
  EXPECT_EQ(file("far.mdl"), kFarMission);
  EXPECT_TRUE(document("far.mdl").is_dirty());
}

TEST_F(SessionNames, UnsavedWorkOnAnotherMissionIsOpenedAndRenamedThere) {
  const std::string typed = std::string(kOtherMission) + "-- theirs, PP-Far\n2. UNIT trio MOVETO PP-Far\n";
  documents::Drafts drafts(project_.path("state").string(), project_.path("project").string());
  const std::string other = kOtherMission;
  ASSERT_EQ(drafts.keep("other.mdl", typed, &other), "");
  ASSERT_TRUE(rename(at("far.mdl", kFarMission, "Far"), "Gate").ok());
  ASSERT_TRUE(wait_for_text("other.mdl", "2. UNIT trio MOVETO PP-Gate"));
  EXPECT_EQ(document("other.mdl").language(), Complete::MISSION);
  EXPECT_EQ(file("other.mdl"), kOtherMission) << "it is saved by who typed it";
  EXPECT_TRUE(has_words(drafts.find("other.mdl")->text, "MOVETO PP-Gate"));
}

TEST_F(SessionNames, WhatTheDesignerHasNotSavedStaysAsItIs) {
  documents::Drafts drafts(project_.path("state").string() + "/designer", project_.path("project").string());
  const std::string robots = kScoutRobots;
  ASSERT_EQ(drafts.keep("robots.cdl", "anything", &robots), "");
  const Reply declared = plan(at("far.mdl", kFarMission, "urge"), "need");
  EXPECT_FALSE(declared.ok());
  EXPECT_TRUE(has_words(declared.error(), "has unsaved changes in the designer")) << declared.error();
  const Reply named = plan(at("far.mdl", kFarMission, "Far"), "Gate");
  EXPECT_FALSE(named.ok()) << "the mission's robots would not know the place any more";
  EXPECT_EQ(named.place().path(), "robots.cdl");
}

TEST_F(SessionNames, WhatChangedOnDiskMeanwhileIsNotWrittenOver) {
  const names::At far = at("far.mdl", kFarMission, "Far");
  const std::string seal = plan(far, "Gate").plan().seal();
  project_.write("project/other.mdl", std::string(kOtherMission) + "2. UNIT trio STOP\n");
  const Reply late = anna_.ask(renaming(far, "Gate", seal));
  EXPECT_FALSE(late.ok());
  EXPECT_TRUE(has_words(late.error(), "changed meanwhile")) << late.error();
  EXPECT_EQ(file("map.odl"), kFarMap);
  EXPECT_EQ(file("robots.cdl"), kScoutRobots);

  ASSERT_TRUE(rename(far, "Gate").ok());
  project_.write("project/other.mdl", file("other.mdl") + "3. UNIT trio STOP\n");
  project_.write("project/robots.cdl", "// another one\n");
  ASSERT_EQ(undo(), "");
  ASSERT_TRUE(wait_for_text("far.mdl", "MOVETO PP-Far"));
  EXPECT_EQ(file("other.mdl"), std::string(kOtherMission) + "2. UNIT trio STOP\n3. UNIT trio STOP\n")
      << "both";
  EXPECT_EQ(file("robots.cdl"), "// another one\n");
  EXPECT_TRUE(anna_.wait([&] { return anna_.has_log("robots.cdl has changed meanwhile"); }, 10.0));
}

TEST_F(SessionNames, ANameThatIsTakenIsRefusedWithItsPlace) {
  const Reply taken = plan(at("far.mdl", kFarMission, "Far"), "Near");
  ASSERT_FALSE(taken.ok());
  EXPECT_TRUE(has_words(taken.error(), "far.mdl, line 6")) << taken.error();
  EXPECT_EQ(taken.place().path(), "far.mdl");
  EXPECT_FALSE(plan(at("far.mdl", kFarMission, "Far"), "two words").ok());
  EXPECT_FALSE(plan(at("far.mdl", kFarMission, "Far"), "").ok());
  EXPECT_FALSE(plan(at("far.mdl", kFarMission, "MOVETO"), "x").ok());
  EXPECT_FALSE(plan(at("robots.cdl", kScoutRobots, "Wander"), "Roam").ok()) << "of the library";
}

TEST_F(SessionNames, WhoWatchesLooksUpAndDoesNotRename) {
  Browser ben(session_, "Ben");
  const names::At far = at("far.mdl", kFarMission, "Far");
  const std::string seal = plan(far, "Gate").plan().seal();
  ToServer looking;
  *looking.mutable_find_definition()->mutable_at() = far;
  EXPECT_TRUE(ben.ask(looking).ok());
  ToServer planning;
  *planning.mutable_plan_rename()->mutable_at() = far;
  planning.mutable_plan_rename()->set_name("Gate");
  EXPECT_FALSE(ben.ask(planning).ok());
  EXPECT_FALSE(ben.ask(renaming(far, "Gate", seal)).ok());
  EXPECT_EQ(file("map.odl"), kFarMap);
}

TEST_F(SessionNames, WhatARunIsMadeOfFollowsTheNewNames) {
  const auto is_ready = [&] { return anna_.status().mode() == Status::READY; };
  const auto has_place = [&](const std::string& name) {
    return anna_.plan().steps_size() == 2 &&
           has_words(anna_.plan().steps(1).commands(0).text(), "MOVETO PP-" + name);
  };
  ASSERT_TRUE(rename(at("far.mdl", kFarMission, "Far"), "Gate").ok());
  EXPECT_TRUE(anna_.wait([&] { return has_place("Gate") && is_ready(); }, 20.0));
  ASSERT_EQ(undo(), "");
  EXPECT_TRUE(anna_.wait([&] { return has_place("Far") && is_ready(); }, 20.0));
  EXPECT_FALSE(anna_.has_log("the mission has no place"));

  ASSERT_EQ(anna_.control(Control::EXECUTE), "");
  ASSERT_TRUE(anna_.wait([&] { return anna_.status().mode() == Status::RUNNING; }));
  ASSERT_TRUE(rename(at("far.mdl", kFarMission, "Far"), "Gate").ok());
  EXPECT_TRUE(anna_.wait([&] { return has_place("Gate"); }, 20.0));
  EXPECT_EQ(anna_.status().mode(), Status::RUNNING);
  EXPECT_FALSE(anna_.has_log("the mission has no place"));
}

TEST_F(SessionNames, ARunGoesOnWithTheNewNames) {
  ASSERT_EQ(anna_.control(Control::EXECUTE), "");
  ASSERT_TRUE(anna_.wait([&] { return anna_.status().mode() == Status::RUNNING; }));
  ASSERT_TRUE(rename(at("far.mdl", kFarMission, "pair"), "team").ok());
  EXPECT_TRUE(anna_.wait(
      [&] { return anna_.plan().steps_size() == 2 && anna_.plan().steps(1).commands(0).unit() == "team"; },
      20.0));
  EXPECT_EQ(anna_.status().mode(), Status::RUNNING);
}

}  // namespace
}  // namespace mlab::console
