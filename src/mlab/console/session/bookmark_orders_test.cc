#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "mlab/console/testing/browser.h"
#include "mlab/console/testing/journalled_test.h"
#include "mlab/history/bookmark_file.h"
#include "mlab/history/recording_file.h"
#include "mlab/history/shelf.h"

namespace mlab::console {
namespace {

namespace fs = std::filesystem;
using testing::Browser;
using testing::TestSession;

ToServer mark_now(const std::string& note) {
  ToServer out;
  out.mutable_set_bookmark()->set_now(true);
  out.mutable_set_bookmark()->set_note(note);
  return out;
}

ToServer mark(double time, std::uint64_t cycle, const std::string& note) {
  ToServer out;
  out.mutable_set_bookmark()->set_time(time);
  out.mutable_set_bookmark()->set_cycle(cycle);
  out.mutable_set_bookmark()->set_note(note);
  return out;
}

ToServer write_note(std::uint64_t id, const std::string& note) {
  ToServer out;
  out.mutable_set_bookmark()->set_id(id);
  out.mutable_set_bookmark()->set_note(note);
  return out;
}

ToServer remove(std::uint64_t id, bool take_back = false) {
  ToServer out;
  out.mutable_remove_bookmark()->set_id(id);
  out.mutable_remove_bookmark()->set_take_back(take_back);
  return out;
}

class BookmarkOrdersTest : public testing::JournalledTest {
 protected:
  std::string recording() const {
    const auto runs = history::Shelf(project_.path("runs").string()).runs();
    return runs.empty() ? "" : runs.front().path;
  }
  void open(SessionSettings& settings) const {
    settings.project_folder = project_.path("project").string();
    auto read = history::read_recording(recording());
    ASSERT_TRUE(read);
    settings.recording = {"far", read->history, recording()};
  }
  static bool has(Browser& browser, const std::vector<std::string>& notes) {
    return browser.wait(
        [&] {
          if (browser.bookmarks().bookmarks_size() != static_cast<int>(notes.size())) return false;
          for (std::size_t i = 0; i < notes.size(); ++i) {
            if (browser.bookmarks().bookmarks(static_cast<int>(i)).note() != notes[i]) return false;
          }
          return true;
        },
        20.0);
  }
};

TEST_F(BookmarkOrdersTest, AreSeenByAllAndStayWithTheRunAndItsRecording) {
  {
    TestSession session("", 20.0, [&](SessionSettings& s) { begin(s); });
    Browser anna(session, "Anna");
    Browser ben(session, "Ben");
    EXPECT_EQ(Browser::error_of(anna.ask(mark_now("too early"))), "nothing has run yet that could be marked");
    start(anna);
    const Reply made = anna.ask(mark_now("robot 2 hesitates"));
    EXPECT_EQ(Browser::error_of(made), "");
    EXPECT_EQ(made.not_saved(), "");
    EXPECT_EQ(made.bookmark(), 1U);
    EXPECT_EQ(Browser::error_of(anna.ask(mark(1.0, 10, "the beginning"))), "");
    ASSERT_TRUE(has(ben, {"the beginning", "robot 2 hesitates"}));
    EXPECT_EQ(ben.bookmarks().bookmarks(1).by(), "Anna");
    EXPECT_GE(ben.bookmarks().bookmarks(1).time(), 3.0);
    EXPECT_EQ(ben.bookmarks().kept_in(), recording());
    EXPECT_NE(Browser::error_of(ben.ask(mark_now("by one who only looks"))), "");
    EXPECT_NE(Browser::error_of(ben.ask(remove(1))), "");
    EXPECT_EQ(Browser::error_of(anna.ask(write_note(1, "robot 2\nstops"))), "");
    EXPECT_EQ(Browser::error_of(anna.ask(remove(2))), "");
    ASSERT_TRUE(has(ben, {"robot 2 stops"}));
    EXPECT_EQ(Browser::error_of(anna.ask(remove(2, true))), "");
    ASSERT_TRUE(has(ben, {"the beginning", "robot 2 stops"}));
    EXPECT_EQ(Browser::error_of(anna.ask(remove(77))), "there is no bookmark 77");
    // While somebody looks at another moment, too.
    ToServer look;
    look.mutable_look_back()->set_time(2.0);
    ASSERT_EQ(Browser::error_of(anna.ask(look)), "");
    EXPECT_EQ(Browser::error_of(anna.ask(mark(2.0, 20, "looked back"))), "");
  }
  EXPECT_EQ(history::read_bookmarks(recording()).bookmarks.all().size(), 3U);
  TestSession session("", 20.0, [&](SessionSettings& s) { resume(s); });
  Browser anna(session, "Anna");
  ASSERT_TRUE(has(anna, {"the beginning", "looked back", "robot 2 stops"}));
  EXPECT_EQ(Browser::error_of(anna.ask(mark_now("after it went on"))), "");
  ASSERT_TRUE(has(anna, {"the beginning", "looked back", "robot 2 stops", "after it went on"}));
  // Another run has none, and the recording of the one before keeps its own.
  const std::string before = recording();
  ASSERT_EQ(anna.control(Control::RESTART), "");
  ASSERT_TRUE(has(anna, {}));
  EXPECT_EQ(history::read_bookmarks(before).bookmarks.all().size(), 4U);
}

TEST_F(BookmarkOrdersTest, OfARecordingAreBesideIt) {
  {
    TestSession session("", 20.0, [&](SessionSettings& s) { begin(s); });
    Browser anna(session, "Anna");
    start(anna);
    EXPECT_EQ(Browser::error_of(anna.ask(mark_now("seen live"))), "");
  }
  const auto size = fs::file_size(recording());
  {
    TestSession session("", 20.0, [&](SessionSettings& s) { open(s); });
    Browser anna(session, "Anna");
    ASSERT_TRUE(has(anna, {"seen live"}));
    EXPECT_EQ(Browser::error_of(anna.ask(write_note(1, "seen live, and again"))), "");
    EXPECT_EQ(Browser::error_of(anna.ask(mark(1.0, 10, "later"))), "");
    const double end = anna.time_line().end();
    EXPECT_EQ(Browser::error_of(anna.ask(mark(end + 0.5, ~std::uint64_t{0}, "at the end"))), "");
    ASSERT_TRUE(has(anna, {"later", "seen live, and again", "at the end"}));
    EXPECT_EQ(anna.bookmarks().kept_in(), recording() + ".bookmarks");
    EXPECT_EQ(anna.bookmarks().bookmarks(2).cycle(), anna.time_line().last_cycle());
    EXPECT_LE(anna.bookmarks().bookmarks(2).time(), end + 1e-6);
    for (const double time :
         {1e300, end + 2.0, -1.0, std::nan(""), -std::numeric_limits<double>::infinity()}) {
      const std::string error = Browser::error_of(anna.ask(mark(time, 10, "nowhere")));
      EXPECT_NE(error.find("is no moment of the run, which ends at"), std::string::npos) << time << error;
    }
    EXPECT_EQ(anna.control(Control::EXECUTE), "this is a recording: it can't be told anything");
  }
  EXPECT_EQ(fs::file_size(recording()), size) << "its bytes are not touched";
  TestSession session("", 20.0, [&](SessionSettings& s) { open(s); });
  Browser anna(session, "Anna");
  EXPECT_TRUE(has(anna, {"later", "seen live, and again", "at the end"}));
}

TEST_F(BookmarkOrdersTest, AtMomentsThatARecordingDoesNotHaveAreMovedAndSaid) {
  {
    TestSession session("", 20.0, [&](SessionSettings& s) { begin(s); });
    Browser anna(session, "Anna");
    start(anna);
  }
  std::ofstream(history::bookmark_path(recording()))
      << R"({"format":1,"recorded_to":0,"bookmarks":[{"id":1,"cycle":4e9,"time":1e300,"note":"far"}]})";
  TestSession session("", 20.0, [&](SessionSettings& s) { open(s); });
  Browser anna(session, "Anna");
  ASSERT_TRUE(has(anna, {"far"}));
  EXPECT_LE(anna.bookmarks().bookmarks(0).time(), anna.time_line().end() + 1e-6);
  EXPECT_TRUE(anna.wait([&] { return anna.has_log("of the bookmarks one was written at moments"); }));
}

TEST_F(BookmarkOrdersTest, WhereTheyCannotBeKeptItIsSaid) {
  {
    TestSession session("", 20.0, [&](SessionSettings& s) { begin(s); });
    Browser anna(session, "Anna");
    start(anna);
  }
  TestSession session("", 20.0, [&](SessionSettings& s) {
    open(s);
    s.recording.path = project_.path("gone/far.mcap").string();
  });
  Browser anna(session, "Anna");
  ASSERT_EQ(Browser::error_of(anna.ask(mark(1.0, 10, "kept nowhere"))), "");
  ASSERT_TRUE(has(anna, {"kept nowhere"}));
  EXPECT_NE(anna.bookmarks().not_kept().find("can't be written"), std::string::npos);
  EXPECT_TRUE(anna.wait([&] { return anna.has_log("bookmarks are not kept"); }));
  // Once there is room nobody has to do anything.
  fs::create_directories(project_.path("gone"));
  EXPECT_TRUE(anna.wait([&] { return anna.bookmarks().not_kept().empty(); }));
  EXPECT_TRUE(fs::exists(project_.path("gone/far.mcap.bookmarks")));
}

TEST_F(BookmarkOrdersTest, OfARunWithoutARecordingAreInItsJournal) {
  {
    TestSession session("", 20.0, [&](SessionSettings& s) {
      begin(s);
      s.record.is_on = false;
    });
    Browser anna(session, "Anna");
    start(anna);
    const Reply made = anna.ask(mark_now("only here"));
    EXPECT_EQ(Browser::error_of(made), "");
    EXPECT_EQ(made.not_saved(), "");
    ASSERT_TRUE(has(anna, {"only here"}));
    EXPECT_NE(anna.bookmarks().not_kept().find("this run is not recorded"), std::string::npos);
  }
  TestSession session("", 20.0, [&](SessionSettings& s) {
    resume(s);
    s.record.is_on = false;
  });
  Browser anna(session, "Anna");
  EXPECT_TRUE(has(anna, {"only here"}));
}

}  // namespace
}  // namespace mlab::console
