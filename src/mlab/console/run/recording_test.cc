#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/cell/testing/permission.h"
#include "mlab/console/testing/browser.h"
#include "mlab/documents/testing/scratch_project.h"
#include "mlab/history/recording_file.h"
#include "mlab/history/replay.h"
#include "mlab/history/shelf.h"

namespace mlab::console {
namespace {

using documents::testing::ScratchProject;
using testing::Browser;
using testing::TestSession;

// What people did in a session, computed again: the same run.
TEST(ConsoleRecording, HoldsAllThatPeopleDid) {
  const ScratchProject project;
  project.write("project/far.mdl",
                "OVERLAY \"map.odl\"\nUNIT <pair> ROBOT ROBOT\nCOMMAND LIST:\n"
                "0. UNIT pair START 100 100 0 40\n1. UNIT pair MOVETO PP-Far\n");
  project.write("project/map.odl", "MISSION-AREA 2000 1000\nCONTROL MEASURES:\nPP Far 1900 100\n");
  const history::Shelf shelf(project.path("runs").string());
  {
    TestSession session("", 50.0, [&](SessionSettings& s) {
      s.project_folder = project.path("project").string();
      s.mission = project.path("project/far.mdl").string();
      s.record = {true, shelf.folder(), ""};
    });
    Browser anna(session, "Anna");
    ASSERT_TRUE(anna.wait([&] { return anna.status().mode() == Status::READY; }));
    EXPECT_TRUE(shelf.runs().empty()) << "nothing has started";
    ASSERT_EQ(anna.control(Control::EXECUTE), "");
    const auto reach = [&](double time) {
      ASSERT_TRUE(anna.wait([&] { return anna.status().time() >= time; })) << time;
    };
    reach(5.0);
    EXPECT_TRUE(anna.wait([&] { return anna.has_log("this run is recorded in"); }));
    EXPECT_EQ(anna.type("ROBOT 2 MOVETO 400 300"), "");
    reach(10.0);
    EXPECT_EQ(anna.type("OBSTACLE 300 100 8"), "");
    EXPECT_EQ(anna.control(Control::PAUSE), "");
    EXPECT_EQ(anna.control(Control::SINGLE_CYCLE), "");
    EXPECT_EQ(anna.control(Control::EXECUTE), "");
    reach(15.0);
    ToServer set;
    set.mutable_set_parameter()->add_robots(1);
    set.mutable_set_parameter()->set_port("base_velocity");
    set.mutable_set_parameter()->set_value("4");
    EXPECT_EQ(Browser::error_of(anna.ask(set)), "");
    ToServer steer;
    steer.mutable_start_teleoperation()->set_robot(2);
    EXPECT_EQ(Browser::error_of(anna.ask(steer)), "");
    reach(18.0);
    session->emergency_stop();
    ASSERT_TRUE(anna.wait([&] { return anna.has_log("emergency stop"); }));
  }
  const std::vector<history::ShelvedRun> runs = shelf.runs();
  ASSERT_EQ(runs.size(), 1U);
  const auto recording = history::read_recording(runs.front().path);
  ASSERT_TRUE(recording) << recording.error().message;
  EXPECT_EQ(recording->cut, "");
  EXPECT_GE(recording->history->inputs().size(), 8U);
  text::Diagnostics sink;
  const auto replay = history::Replay::make(recording->history, {cell::testing::code_permitted()}, sink);
  ASSERT_NE(replay, nullptr) << text::render(sink);
  while (replay->step()) {
  }
  ASSERT_FALSE(replay->divergence()) << replay->divergence()->cycle << ": " << replay->divergence()->why;
  EXPECT_TRUE(replay->is_at_end());
  EXPECT_GT(replay->equal_marks(), 1U);
  EXPECT_GT(replay->run().time(), 18.0);
}

TEST(ConsoleRecording, ThatCanNotBeWrittenIsAnAlertAndTheRunGoesOn) {
  TestSession session("demo_c/demo_c.mdl", 100.0,
                      [&](SessionSettings& s) { s.record = {true, "/proc/nowhere", ""}; });
  Browser anna(session, "Anna");
  ASSERT_TRUE(anna.wait([&] { return anna.status().mode() == Status::READY; }));
  ASSERT_EQ(anna.control(Control::EXECUTE), "");
  EXPECT_TRUE(anna.wait([&] { return anna.has_log("the recording of this run does not go on"); }));
  EXPECT_TRUE(anna.wait([&] { return anna.status().cycle() > 5; }));
}

}  // namespace
}  // namespace mlab::console
