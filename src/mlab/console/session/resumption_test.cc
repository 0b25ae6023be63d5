#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <future>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/console/testing/browser.h"
#include "mlab/console/testing/journalled_test.h"
#include "mlab/history/recording_file.h"
#include "mlab/history/shelf.h"
#include "mlab/history/testing/losing_runner.h"

namespace mlab::console {
namespace {

namespace fs = std::filesystem;
using testing::Browser;
using testing::TestSession;

class ResumptionTest : public testing::JournalledTest {
 protected:
  static bool is_back(Browser& anna) {
    return anna.wait([&] { return anna.status().mode() == Status::PAUSED; }) &&
           anna.wait([&] { return anna.has_log("the run goes on as it stood at"); });
  }
  // Replaces the first `from` of the mission's text.
  static std::string replace(Browser& anna, const std::string& from, const std::string& to) {
    if (!anna.wait([&] { return anna.documents().documents_size() > 0; })) return "no document";
    const Documents::Document& document = anna.documents().documents(0);
    const std::size_t at = document.text().find(from);
    if (at == std::string::npos) return "not in the text";
    ToServer message;
    EditText& edit = *message.mutable_edit_text();
    edit.set_document(document.path());
    edit.set_revision(document.revision());
    edit.set_begin(static_cast<std::uint32_t>(at));
    edit.set_end(static_cast<std::uint32_t>(at + from.size()));
    edit.set_text(to);
    const std::uint64_t revision = document.revision();
    const std::string error = Browser::error_of(anna.ask(message));
    anna.wait([&] { return anna.documents().documents(0).revision() > revision; }, 10.0);
    return error;
  }
};

TEST_F(ResumptionTest, BringsBackTheRunWithAllThatPeopleDid) {
  double time = 0.0;
  {
    TestSession session("", 20.0, [&](SessionSettings& s) { begin(s); });
    Browser anna(session, "Anna");
    EXPECT_TRUE(folder_.look().runs.empty());
    start(anna);
    EXPECT_EQ(anna.type("OBSTACLE 300 400 8"), "");
    ToServer set;
    set.mutable_set_parameter()->add_robots(1);
    set.mutable_set_parameter()->set_port("base_velocity");
    set.mutable_set_parameter()->set_value("4");
    EXPECT_EQ(Browser::error_of(anna.ask(set)), "");
    ToServer steer;
    steer.mutable_start_teleoperation()->set_robot(2);
    EXPECT_EQ(Browser::error_of(anna.ask(steer)), "");
    ToServer stick;
    ASSERT_TRUE(anna.wait([&] { return anna.status().teleoperations_size() == 1; }));
    stick.mutable_stick()->set_unit(anna.status().teleoperations(0).unit());
    stick.mutable_stick()->set_x(1.0);
    const Reply reply = anna.ask(stick);
    EXPECT_EQ(Browser::error_of(reply), "");
    EXPECT_EQ(reply.not_saved(), "");
    time = anna.status().time();
  }
  TestSession session("", 1.0, [&](SessionSettings& s) { resume(s); });
  Browser anna(session, "Anna");
  ASSERT_TRUE(is_back(anna));
  EXPECT_TRUE(anna.wait([&] { return anna.has_log("this run goes on being recorded in"); }));
  EXPECT_EQ(history::Shelf(project_.path("runs").string()).runs().size(), 1U) << "one run, one recording";
  EXPECT_GE(anna.status().time(), time);
  EXPECT_DOUBLE_EQ(anna.status().speed(), 20.0);
  for (const char* said : {"Anna: execute", "Anna typed: OBSTACLE 300 400 8", "base_velocity", "teleoperate"})
    EXPECT_TRUE(anna.has_log(said)) << said;
  ASSERT_EQ(anna.status().teleoperations_size(), 1);
  EXPECT_TRUE(anna.journal().unfinished().empty()) << "this one is being gone on with";
  session->look_at_run([](const run::MissionRun* run) {
    ASSERT_NE(run, nullptr);
    EXPECT_FALSE(run->fleet().find({2})->is_stick_held) << "nobody's hand is on it";
    EXPECT_EQ(run->mission().typed.size(), 1U);
  });
  time = anna.status().time();
  EXPECT_EQ(anna.control(Control::RESUME), "");
  EXPECT_TRUE(anna.wait([&] { return anna.status().time() > time + 2.0; }));
}

TEST_F(ResumptionTest, GoesOnWithTheLastTextWithoutErrors) {
  const auto keep_drafts = [&](SessionSettings& s) { s.state_folder = project_.path("state").string(); };
  {
    TestSession session("", 20.0, [&](SessionSettings& s) {
      begin(s);
      keep_drafts(s);
    });
    Browser anna(session, "Anna");
    start(anna);
    ASSERT_EQ(
        replace(anna, "1. UNIT pair MOVETO PP-Far\n", "1. UNIT pair MOVETO PP-Far\n2. UNIT pair STOP\n"), "");
    ASSERT_TRUE(anna.wait([&] { return anna.plan().steps_size() == 3; }));
    ASSERT_EQ(replace(anna, "PP-Far", "PP-Nowhere"), "");
    ASSERT_TRUE(anna.wait([&] { return anna.documents().runs_older_text(); }));
  }
  TestSession session("", 1.0, [&](SessionSettings& s) {
    resume(s);
    keep_drafts(s);
  });
  Browser anna(session, "Anna");
  ASSERT_TRUE(is_back(anna));
  EXPECT_TRUE(anna.wait([&] { return anna.documents().runs_older_text(); }));
  anna.watch_for(0.5);
  EXPECT_FALSE(anna.has_log("the mission was changed meanwhile"));
  const auto restored = std::ranges::find_if(anna.log(), [](const Log::Entry& entry) {
    return entry.text().find("restored the unsaved text of `far.mdl`") != std::string::npos;
  });
  ASSERT_NE(restored, anna.log().end());
  EXPECT_GT(restored->time(), 3.0) << "it stands where the run does";
  EXPECT_EQ(anna.plan().steps_size(), 3) << "not what is on the disk";
  ASSERT_EQ(replace(anna, "PP-Nowhere\n2. UNIT pair STOP\n",
                    "PP-Far\n2. UNIT pair STOP\n3. UNIT pair MOVETO PP-Far\n"),
            "");
  EXPECT_TRUE(anna.wait([&] { return anna.plan().steps_size() == 4; })) << "what is mended is followed";
  EXPECT_FALSE(anna.documents().runs_older_text());
}

TEST_F(ResumptionTest, KnowsWhichRobotsWereLost) {
  const auto lives = [](TestSession& session) {
    std::promise<std::vector<fleet::RobotLife>> out;
    session->look_at_run([&](const run::MissionRun* run) {
      std::vector<fleet::RobotLife> all;
      for (const fleet::FleetRobot& robot : run->fleet().robots()) all.push_back(robot.life);
      out.set_value(std::move(all));
    });
    return out.get_future().get();
  };
  std::vector<fleet::RobotLife> before;
  {
    TestSession session("", 20.0, [&](SessionSettings& s) {
      begin(s);
      s.run.robots_elsewhere = [](std::uint64_t seed, double) {
        return std::make_unique<history::testing::LosingRunner>(
            static_cast<std::uint32_t>(seed), history::testing::LosingRunner::Odds{0, 10, 1});
      };
    });
    Browser anna(session, "Anna");
    start(anna);
    ASSERT_TRUE(anna.wait([&] { return anna.has_log("can't be reached: the agent on `south`"); }));
    EXPECT_EQ(anna.control(Control::PAUSE), "");
    before = lives(session);
  }
  ASSERT_EQ(std::ranges::count(before, fleet::RobotLife::kFaulted), 1);
  TestSession session("", 1.0, [&](SessionSettings& s) { resume(s); });
  Browser anna(session, "Anna");
  ASSERT_TRUE(is_back(anna));
  EXPECT_TRUE(anna.wait([&] { return anna.has_log("this run goes on being recorded in"); }));
  EXPECT_EQ(lives(session), before);
}

TEST_F(ResumptionTest, IsOfferedToWhoComesWithoutAMission) {
  {
    TestSession session("", 20.0, [&](SessionSettings& s) { begin(s); });
    Browser anna(session, "Anna");
    start(anna);
  }
  TestSession session("", 20.0, [&](SessionSettings& s) { change(s); });
  Browser bert(session, "Bert");
  ASSERT_TRUE(bert.wait([&] { return bert.journal().unfinished_size() == 1; }));
  const Journal::Unfinished offered = bert.journal().unfinished(0);
  EXPECT_EQ(offered.mission(), "far.mdl");
  EXPECT_GT(offered.time(), 2.0);
  ToServer wanted;
  wanted.mutable_continue_run()->set_name("../" + offered.name());
  EXPECT_EQ(Browser::error_of(bert.ask(wanted)), "there is no such run");
  wanted.mutable_continue_run()->set_name(offered.name());
  EXPECT_EQ(Browser::error_of(bert.ask(wanted)), "");
  ASSERT_TRUE(is_back(bert));
  EXPECT_TRUE(bert.has_log("Anna: execute"));
  EXPECT_TRUE(bert.wait([&] { return bert.journal().unfinished_size() == 0; }));
}

TEST_F(ResumptionTest, SaysThatTheMissionIsGone) {
  {
    TestSession session("", 20.0, [&](SessionSettings& s) { begin(s); });
    Browser anna(session, "Anna");
    start(anna);
  }
  const fs::path mission = project_.path("project/far.mdl");
  const fs::path elsewhere = project_.path("elsewhere/far.mdl");
  fs::rename(mission, elsewhere);
  TestSession session("", 20.0, [&](SessionSettings& s) { resume(s); });
  Browser anna(session, "Anna");
  EXPECT_TRUE(anna.wait([&] { return anna.has_log("the run can't be gone on with: "); }));
  ASSERT_TRUE(anna.wait([&] { return anna.journal().unfinished_size() == 1; })) << "it is kept";
  EXPECT_EQ(anna.journal().unfinished(0).why_not(), "`far.mdl` is not there");
  EXPECT_TRUE(anna.journal().unfinished(0).mission_is_gone());
  fs::rename(elsewhere, mission);
  ToServer wanted;
  wanted.mutable_continue_run()->set_name(anna.journal().unfinished(0).name());
  EXPECT_EQ(Browser::error_of(anna.ask(wanted)), "");
  EXPECT_TRUE(is_back(anna));
}

TEST_F(ResumptionTest, KeepsNothingOfARunThatIsBegunAnew) {
  TestSession session("", 20.0, [&](SessionSettings& s) { begin(s); });
  Browser anna(session, "Anna");
  start(anna);
  ASSERT_EQ(anna.control(Control::RESTART), "");
  ASSERT_TRUE(anna.wait([&] { return anna.status().mode() == Status::READY; }));
  session->end();
  EXPECT_TRUE(folder_.look().runs.empty());
}

TEST_F(ResumptionTest, EngagedStopStaysEngaged) {
  {
    TestSession session("", 20.0, [&](SessionSettings& s) { begin(s); });
    Browser anna(session, "Anna");
    start(anna);
    session->emergency_stop();
    ASSERT_TRUE(anna.wait([&] { return anna.status().mode() == Status::STOPPED; }));
  }
  TestSession session("", 20.0, [&](SessionSettings& s) { resume(s); });
  Browser anna(session, "Anna");
  ASSERT_TRUE(anna.wait([&] { return anna.has_log("the run goes on as it stood at"); }));
  ASSERT_TRUE(anna.wait([&] { return anna.status().mode() == Status::STOPPED; }));
  EXPECT_EQ(anna.control(Control::RELEASE_STOP), "");
  EXPECT_TRUE(anna.wait([&] { return anna.status().mode() == Status::PAUSED; }));
}

TEST_F(ResumptionTest, WithoutRoomSaysThatNothingIsSavedAndTheRunGoesOn) {
  TestSession session("", 20.0, [&](SessionSettings& s) {
    begin(s);
    s.journal_folder = "/proc/nowhere/journals";
  });
  Browser anna(session, "Anna");
  start(anna);
  ToServer message;
  message.mutable_control()->set_action(Control::PAUSE);
  const Reply reply = anna.ask(message);
  EXPECT_TRUE(reply.ok());
  EXPECT_NE(reply.not_saved().find("can't be made"), std::string::npos) << reply.not_saved();
  EXPECT_TRUE(anna.wait([&] { return !anna.journal().not_saved().empty(); }));
  EXPECT_TRUE(anna.has_log("what is done from now on is not saved"));
}

TEST_F(ResumptionTest, SetsAsideWhatIsNoJournal) {
  fs::create_directories(folder_.folder());
  std::ofstream(folder_.folder() + "/x.journal") << "of somebody";
  TestSession session("", 20.0, [&](SessionSettings& s) {
    begin(s);
    s.resume = folder_.folder() + "/x.journal";
  });
  Browser anna(session, "Anna");
  EXPECT_TRUE(anna.wait([&] { return anna.status().mode() == Status::READY; })) << "the mission is open";
  EXPECT_TRUE(anna.wait([&] { return anna.has_log("can't be read, and lies in"); }));
  EXPECT_TRUE(fs::exists(folder_.folder() + "/x.journal.unreadable"));
}

}  // namespace
}  // namespace mlab::console
