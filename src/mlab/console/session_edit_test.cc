#include <algorithm>
#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "mlab/console/session.h"
#include "mlab/console/testing/browser.h"
#include "mlab/documents/testing/scratch_project.h"

namespace mlab::console {
namespace {

using documents::testing::ScratchProject;
using testing::Browser;
using testing::TestSession;

constexpr const char* kEditedMission =
    "OVERLAY \"map.odl\"\n"
    "UNIT <pair> ROBOT ROBOT\n"
    "COMMAND LIST:\n"
    "0. UNIT pair START 100 100 0 40\n"
    "1. UNIT pair MOVETO PP-Far\n";
constexpr const char* kMap =
    "MISSION-AREA 2000 1000\n"
    "CONTROL MEASURES:\n"
    "PP Far 1900 100\n";

class SessionEdit : public ::testing::Test {
 protected:
  explicit SessionEdit(const std::function<void(SessionSettings&)>& change = {})
      : project_(),
        session_((write(), ""), 10.0,
                 [&](SessionSettings& s) {
                   if (change) change(s);
                   s.project_folder = project_.path("project").string();
                   s.state_folder = project_.path("state").string();
                   s.mission = project_.path("project/far.mdl").string();
                 }),
        anna_(session_, "Anna") {
    EXPECT_TRUE(wait_for(Status::READY));
  }
  void write() {
    project_.write("project/far.mdl", kEditedMission);
    project_.write("project/map.odl", kMap);
  }
  bool wait_for(Status::Mode mode) {
    return anna_.wait([&] { return anna_.status().mode() == mode; });
  }
  // Replaces the first `from` of the mission's text.
  std::string replace(const std::string& from, const std::string& to) {
    const Documents::Document& document = anna_.documents().documents(0);
    const auto at = document.text().find(from);
    ToServer message;
    EditText& edit = *message.mutable_edit_text();
    edit.set_document(document.path());
    edit.set_revision(document.revision());
    edit.set_begin(static_cast<std::uint32_t>(at));
    edit.set_end(static_cast<std::uint32_t>(at + from.size()));
    edit.set_text(to);
    const std::string error = Browser::error_of(anna_.ask(message));
    const std::uint64_t revision = document.revision();
    anna_.wait([&] { return anna_.documents().documents(0).revision() > revision; }, 10.0);
    return error;
  }
  double base_velocity(std::uint32_t robot) {
    ToServer watch;
    watch.mutable_watch()->add_details(robot);
    watch.mutable_watch()->set_with_ports(true);
    anna_.ask(watch);
    const auto& ports = anna_.roster().programs(0).ports();
    const auto port = std::ranges::find(ports, "base_velocity", &Port::path);
    const auto index = static_cast<int>(port - ports.begin());
    const std::uint64_t frames = anna_.frame_count();
    anna_.wait([&] { return anna_.frame_count() > frames && anna_.frame().details_size() == 1; });
    return std::stod(anna_.frame().details(0).ports(index));
  }

  ScratchProject project_;
  TestSession session_;
  Browser anna_;
};

TEST_F(SessionEdit, ARunFollowsItsMissionsFilesOnDisk) {
  ASSERT_EQ(anna_.control(Control::EXECUTE), "");
  ASSERT_TRUE(wait_for(Status::RUNNING));
  project_.write("project/map.odl", "MISSION-AREA 2000 1000\nCONTROL MEASURES:\nPP Far 130 100\n");
  ASSERT_TRUE(anna_.wait(
      [&] { return anna_.has_log("`map.odl` was changed on the disk: its new text is taken over"); }));
  ASSERT_LT(anna_.status().time(), 200.0);
  // The step that runs goes on as it was begun.
  ASSERT_EQ(anna_.control(Control::JUMP, 1), "");
  EXPECT_TRUE(wait_for(Status::ENDED));
  EXPECT_LT(anna_.status().time(), 420.0) << "the place is near by now; to where it was they need 450 s";
}

std::string standing_network(const std::string& procedure) {
  return "procedure Vector " + procedure +
         " with\n  double a = 1;\nheader\nbody\n  output = Vector{};\npend\nnode still is " + procedure +
         " with nend\nnode wheels is Drive with v = still; nend\n";
}

/// A session of `--listen` without `--allow-native`.
class SessionElsewhere : public SessionEdit {
 protected:
  SessionElsewhere()
      : SessionEdit([this](SessionSettings& s) {
          project_.write("project/known.cnl", standing_network("Known"));
          s.permission = cell::testing::permitted_elsewhere({standing_network("Known")});
        }) {}
  std::string use(const std::string& program) {
    return replace("UNIT <pair> ROBOT ROBOT", "NEW-ROBOT r \"" + program + "\"\nUNIT <pair> r r");
  }
};

TEST_F(SessionElsewhere, RunsCodeThatLayOnDiskWhenItBegan) {
  EXPECT_EQ(use("known.cnl"), "");
  EXPECT_TRUE(anna_.wait([&] {
    return anna_.roster().programs_size() == 1 && anna_.roster().programs(0).name() == "known.cnl";
  }));
  EXPECT_FALSE(anna_.has_log("--allow-native"));
}

TEST_F(SessionElsewhere, NeitherCompilesNorRunsWhatCameLaterAndSaysWhatWouldAllowIt) {
  project_.write("project/new.cnl", standing_network("New"));
  EXPECT_EQ(use("new.cnl"), "");
  EXPECT_TRUE(anna_.wait([&] {
    return anna_.has_log("code that was not on disk when mlab started is run only with --allow-native");
  }));
  project_.write("project/known.cnl", standing_network("Changed"));
  EXPECT_EQ(replace("new.cnl", "known.cnl"), "");
  anna_.watch_for(0.5);
  EXPECT_NE(anna_.status().mode(), Status::READY) << "it was changed since";
}

TEST_F(SessionEdit, AnEditBeforeTheFirstExecuteMakesTheRunAnew) {
  ASSERT_EQ(replace("ROBOT ROBOT", "ROBOT ROBOT ROBOT"), "");
  EXPECT_TRUE(anna_.wait([&] { return anna_.roster().robots_size() == 3; }));
  EXPECT_EQ(anna_.edits().is_dirty(), true);
  ToServer undo;
  undo.mutable_undo();
  ASSERT_TRUE(anna_.ask(undo).ok());
  EXPECT_TRUE(anna_.wait([&] { return anna_.roster().robots_size() == 2; }));
  EXPECT_TRUE(wait_for(Status::READY));
}

TEST_F(SessionEdit, AnEditOfARunningMissionChangesItsPlanAndTheRunGoesOn) {
  ASSERT_EQ(anna_.control(Control::EXECUTE), "");
  ASSERT_TRUE(anna_.wait([&] { return anna_.status().time() > 2.0; }));
  const double time = anna_.status().time();
  ASSERT_EQ(replace("1. UNIT pair MOVETO PP-Far\n", "1. UNIT pair MOVETO PP-Far\n2. UNIT pair STOP\n"), "");
  EXPECT_TRUE(anna_.wait([&] { return anna_.plan().steps_size() == 3; }));
  EXPECT_TRUE(anna_.wait([&] { return anna_.status().time() > time + 1.0; }));
  EXPECT_EQ(anna_.status().mode(), Status::RUNNING);
  EXPECT_EQ(anna_.status().current_step(), 1U);
}

TEST_F(SessionEdit, ATextWithErrorsLeavesTheRunAsItIs) {
  ASSERT_EQ(anna_.control(Control::EXECUTE), "");
  ASSERT_EQ(replace("PP-Far", "PP-Nowhere"), "");
  EXPECT_TRUE(anna_.wait([&] { return anna_.documents().runs_older_text(); }));
  EXPECT_GT(anna_.documents().documents(0).diagnostics_size(), 0);
  EXPECT_EQ(anna_.plan().steps_size(), 2);
  EXPECT_TRUE(wait_for(Status::RUNNING));
}

TEST_F(SessionEdit, AParameterIsSetLiveAndUndone) {
  ASSERT_EQ(anna_.control(Control::EXECUTE), "");
  ASSERT_TRUE(anna_.wait([&] { return anna_.status().time() > 1.0; }));
  ToServer message;
  SetParameter& set = *message.mutable_set_parameter();
  set.add_robots(1);
  set.add_robots(2);
  set.set_port("base_velocity");
  set.set_value("quick");
  EXPECT_FALSE(anna_.ask(message).ok());
  set.set_value("1.5");
  ASSERT_TRUE(anna_.ask(message).ok());
  EXPECT_EQ(base_velocity(1), 1.5);
  ASSERT_TRUE(anna_.wait([&] { return !anna_.edits().undo().empty(); }));
  EXPECT_EQ(anna_.edits().undo(), "base_velocity of 2 robots");
  ToServer undo;
  undo.mutable_undo();
  ASSERT_TRUE(anna_.ask(undo).ok());
  EXPECT_EQ(base_velocity(1), 5.0);
  ToServer redo;
  redo.mutable_redo();
  ASSERT_TRUE(anna_.ask(redo).ok());
  EXPECT_EQ(base_velocity(2), 1.5);
  EXPECT_FALSE(anna_.ask(redo).ok());
}

TEST_F(SessionEdit, TypedCommandsMoveUnitsAndAreShownBefore) {
  ASSERT_EQ(anna_.control(Control::EXECUTE), "");
  ASSERT_TRUE(anna_.wait([&] { return anna_.status().time() > 2.0; }));
  ToServer preview;
  preview.mutable_typed()->set_line("UNIT pair MOVETO 100 900 Column");
  preview.mutable_typed()->set_preview(true);
  const Reply reply = anna_.ask(preview);
  ASSERT_TRUE(reply.ok());
  ASSERT_EQ(reply.targets().units_size(), 1);
  EXPECT_EQ(reply.targets().units(0).robots_size(), 2);
  EXPECT_NE(reply.targets().units(0).replaces(), "");
  EXPECT_EQ(anna_.status().steps_size(), 2);
  EXPECT_EQ(anna_.type("UNIT pair MOVETO 100 900 Column"), "");
  EXPECT_TRUE(anna_.wait([&] { return anna_.status().steps_size() == 3; }));
  ToServer wrong;
  wrong.mutable_typed()->set_line("UNIT pear MOVETO 100 900");
  const Reply refused = anna_.ask(wrong);
  EXPECT_FALSE(refused.ok());
  EXPECT_GT(refused.diagnostics_size(), 0);
}

TEST_F(SessionEdit, AUnitThatWasTypedOutlivesAnEditOfTheText) {
  ASSERT_EQ(anna_.control(Control::EXECUTE), "");
  ASSERT_EQ(anna_.type("UNIT <extra> ROBOT AND UNIT extra START 500 500"), "");
  ASSERT_TRUE(anna_.wait([&] { return anna_.roster().robots_size() == 3; }));
  ASSERT_EQ(replace("1. UNIT pair MOVETO PP-Far\n", "1. UNIT pair MOVETO PP-Far\n2. UNIT pair STOP\n"), "");
  ASSERT_TRUE(anna_.wait([&] { return anna_.plan().steps_size() == 3; }));
  EXPECT_EQ(anna_.roster().robots_size(), 3);
  EXPECT_EQ(anna_.roster().units_size(), 2);
}

TEST_F(SessionEdit, AnObstacleThatWasTypedIsOnTheMap) {
  ASSERT_EQ(anna_.control(Control::EXECUTE), "");
  ASSERT_EQ(anna_.type("OBSTACLE 700 700 5"), "");
  EXPECT_TRUE(anna_.wait([&] { return anna_.scene().obstacles_size() == 1; }));
  EXPECT_EQ(anna_.scene().obstacles(0).document(), "");
}

TEST_F(SessionEdit, OptionsAreSwitchedWithoutEnteringTheText) {
  ToServer message;
  message.mutable_set_option()->set_option("SHOW-TRAILS");
  message.mutable_set_option()->set_value("ON");
  ASSERT_EQ(Browser::error_of(anna_.ask(message)), "");
  EXPECT_TRUE(anna_.wait([&] { return std::ranges::count(anna_.status().options(), "SHOW-TRAILS") == 1; }));
  message.mutable_set_option()->set_value("ON AND UNIT pair STOP");
  EXPECT_FALSE(anna_.ask(message).ok());
  EXPECT_FALSE(anna_.edits().is_dirty());
  EXPECT_EQ(anna_.status().mode(), Status::READY);
}

TEST_F(SessionEdit, SeriesAreRecordedWhileTheyAreWatchedAndCanBeReadAgain) {
  ToServer watch;
  Series& series = *watch.mutable_watch()->add_series();
  series.set_id(7);
  series.set_quantity(Series::SPEED);
  series.set_robot(1);
  Series& wrong = *watch.mutable_watch()->add_series();
  wrong.set_id(8);
  wrong.set_robot(99);
  ASSERT_TRUE(anna_.ask(watch).ok());
  ASSERT_EQ(anna_.control(Control::EXECUTE), "");
  std::size_t bytes = 0;
  ASSERT_TRUE(anna_.wait([&] {
    for (const SeriesData::Samples& samples : anna_.frame().series().samples()) {
      if (samples.id() == 7) bytes = std::max(bytes, samples.samples().size());
    }
    return bytes > 0 && anna_.status().time() > 3.0;
  }));
  ToServer read;
  *read.mutable_read_series()->add_series() = series;
  *read.mutable_read_series()->add_series() = wrong;
  const Reply reply = anna_.ask(read);
  ASSERT_EQ(reply.series().samples_size(), 2);
  EXPECT_GE(reply.series().samples(0).samples().size(), 16U * 20U);
  EXPECT_NE(reply.series().samples(1).error(), "");
}

TEST_F(SessionEdit, AnotherMissionIsOpenedInItsPlace) {
  project_.write("project/other.mdl", "UNIT <one> ROBOT\nCOMMAND LIST:\n0. UNIT one START 5 5\n");
  ASSERT_EQ(anna_.control(Control::EXECUTE), "");
  ToServer open;
  open.mutable_open_mission()->set_path("other.mdl");
  ASSERT_EQ(Browser::error_of(anna_.ask(open)), "");
  EXPECT_TRUE(anna_.wait([&] { return anna_.roster().robots_size() == 1; }));
  EXPECT_TRUE(wait_for(Status::READY));
  open.mutable_open_mission()->set_path("../../etc/passwd");
  EXPECT_FALSE(anna_.ask(open).ok());
  ToServer list;
  list.mutable_list_files();
  EXPECT_EQ(anna_.ask(list).files().entries_size(), 3);
}

TEST_F(SessionEdit, LinesAreCompletedAndCheckedForAnybody) {
  Browser ben(session_, "Ben");
  ToServer complete;
  complete.mutable_complete()->set_text("UNIT pair MOVETO f");
  complete.mutable_complete()->set_cursor(18);
  const Reply reply = ben.ask(complete);
  ASSERT_TRUE(reply.ok()) << reply.error();
  ASSERT_EQ(reply.completions().items_size(), 1);
  EXPECT_EQ(reply.completions().items(0).text(), "PP-Far");
  EXPECT_EQ(reply.completions().begin(), 17U);
  complete.mutable_complete()->set_language(Complete::MISSION);
  complete.mutable_complete()->set_text("OVERLAY ");
  complete.mutable_complete()->set_cursor(8);
  EXPECT_EQ(ben.ask(complete).completions().items(0).text(), "\"map.odl\"");
  ToServer check;
  check.mutable_check()->set_text("UNIT pair MOVETO Fra");
  const Reply checked = ben.ask(check);
  ASSERT_EQ(checked.diagnostics_size(), 1);
  EXPECT_EQ(checked.diagnostics(0).kind(), "unknown-control-measure");
  EXPECT_EQ(checked.diagnostics(0).begin(), 17U);
}

}  // namespace
}  // namespace mlab::console
