#include "mlab/console/past/recorded_past.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "mlab/console/published/frame_encoder.h"
#include "mlab/console/testing/browser.h"
#include "mlab/history/testing/written_run.h"

namespace mlab::console {
namespace {

using testing::Browser;
using testing::TestSession;
using Entries = std::vector<wire::HistoryEntry>;

// A minute of Demo C.
Entries minute_of_demo_c() {
  history::testing::WrittenRun written("demo_c/demo_c.mdl", 3, true);
  written.run().post(mission::event::Execute{});
  for (int i = 0; i < 600; ++i) written.step();
  written.end();
  return written.entries();
}

std::shared_ptr<history::History> history_of(const Entries& entries) {
  auto out = std::make_shared<history::History>();
  for (const wire::HistoryEntry& entry : entries) EXPECT_EQ(out->add(entry), std::nullopt);
  return out;
}

// As another version of the program has written it, whose settings mean something else.
Entries of_another_format(Entries entries) {
  for (wire::HistoryEntry& entry : entries) {
    if (entry.has_beginning()) entry.mutable_beginning()->set_format(2);
  }
  return entries;
}

const ToBrowser* found(const PastPicture& picture, ToBrowser::BodyCase what) {
  for (const ToBrowser& one : picture.messages) {
    if (one.body_case() == what) return &one;
  }
  return nullptr;
}

std::vector<RobotRows::Row> rows_of(const Frame& frame) {
  std::vector<RobotRows::Row> out(frame.robots().size() / sizeof(RobotRows::Row));
  if (!out.empty()) std::memcpy(out.data(), frame.robots().data(), out.size() * sizeof(RobotRows::Row));
  return out;
}

PastWish at(double time) {
  PastWish out;
  out.time = time;
  out.with_trails = true;
  return out;
}

TEST(RecordedPast, ShowsWhereRobotsWereAndWhatWasTold) {
  const auto history = history_of(of_another_format(minute_of_demo_c()));
  RecordedPast past(history, {});
  const PastPicture picture = past.picture(at(30.05));
  EXPECT_EQ(picture.problem, "");
  EXPECT_NEAR(picture.time, 30.05, 1e-9);
  EXPECT_EQ(picture.cycle, 300U);
  const history::PosesEntry* last = nullptr;
  for (const history::PosesEntry& one : history->poses()) {
    if (one.cycle <= picture.cycle) last = &one;
  }
  ASSERT_NE(last, nullptr);
  EXPECT_GT(last->time, 28.0) << "about once a second";
  const std::vector<RobotRows::Row> rows = rows_of(picture.frame);
  ASSERT_EQ(rows.size(), static_cast<std::size_t>(last->poses.robots_size()));
  EXPECT_EQ(rows[0].id, last->poses.robots(0));
  EXPECT_EQ(rows[0].x, last->poses.x(0));
  EXPECT_EQ(rows[0].y, last->poses.y(0));
  EXPECT_EQ(past.log().last(), history->events().size());
  ASSERT_NE(found(picture, ToBrowser::kTrails), nullptr);
  EXPECT_GT(found(picture, ToBrowser::kTrails)->trails().trails(0).points().size(), 10U * 12U);
}

TEST(RecordedPast, ShowsTheMapAndThePlanAsFarAsTheirTextsAreThere) {
  RecordedPast past(history_of(of_another_format(minute_of_demo_c())), {});
  const PastPicture picture = past.picture(at(10.0));
  ASSERT_NE(found(picture, ToBrowser::kScene), nullptr);
  EXPECT_GT(found(picture, ToBrowser::kScene)->scene().measures_size(), 0);
  EXPECT_GT(found(picture, ToBrowser::kPlan)->plan().steps_size(), 0);
  EXPECT_GT(found(picture, ToBrowser::kDocuments)->documents().documents_size(), 0);
  const Roster& roster = found(picture, ToBrowser::kRoster)->roster();
  ASSERT_GT(roster.robots_size(), 0);
  EXPECT_NE(roster.robots(0).unit(), "");
  EXPECT_EQ(roster.programs_size(), 0);
  // Who knows it is not told again.
  PastWish next = at(11.0);
  next.told = picture.told;
  EXPECT_EQ(found(past.picture(next), ToBrowser::kScene), nullptr);
}

TEST(RecordedPast, WithoutTheMissionsTextTheMapAloneIsShown) {
  Entries entries = of_another_format(minute_of_demo_c());
  for (wire::HistoryEntry& entry : entries) {
    if (entry.has_text() && entry.text().path().ends_with(".mdl"))
      entry.mutable_text()->set_content("of a later version; nothing that is known here");
  }
  RecordedPast past(history_of(entries), {});
  const PastPicture picture = past.picture(at(10.0));
  EXPECT_GT(found(picture, ToBrowser::kScene)->scene().measures_size(), 0);
  EXPECT_EQ(found(picture, ToBrowser::kPlan)->plan().steps_size(), 0);
  EXPECT_EQ(rows_of(picture.frame).size(),
            static_cast<std::size_t>(found(picture, ToBrowser::kRoster)->roster().robots_size()));
}

TEST(RecordedPast, AStrangersIsShownAsFarAsItIsAnything) {
  Entries entries;
  wire::HistoryEntry beginning;
  beginning.mutable_beginning()->set_format(9);
  beginning.mutable_beginning()->mutable_mission()->set_path("nowhere.mdl");
  beginning.mutable_beginning()->mutable_mission()->add_texts(4711);
  entries.push_back(beginning);
  wire::HistoryEntry poses;
  poses.set_cycle(5);
  poses.set_time(1e300);
  for (const float x : {1.0F, std::numeric_limits<float>::quiet_NaN(), 1e30F}) {
    poses.mutable_poses()->add_robots(static_cast<std::uint32_t>(poses.poses().robots_size()));
    poses.mutable_poses()->add_x(x);
    poses.mutable_poses()->add_y(0.0F);
    poses.mutable_poses()->add_heading(x);
  }
  entries.push_back(poses);
  wire::HistoryEntry last;
  last.set_cycle(std::numeric_limits<std::uint64_t>::max());
  last.set_time(1e300);
  last.mutable_event()->set_text("\xff\x1b[2J");
  entries.push_back(last);
  RecordedPast past(history_of(entries), {});
  for (const double time : {0.0, 1.0, 1e299, 1e300, 2e300}) {
    const PastPicture picture = past.picture(at(time));
    EXPECT_EQ(picture.problem, "");
    EXPECT_LE(rows_of(picture.frame).size(), 1U);
  }
  PastWish cycle;
  cycle.cycle = std::numeric_limits<std::uint64_t>::max();
  EXPECT_EQ(rows_of(past.picture(cycle).frame).size(), 1U);
}

TEST(RecordedPast, IsWhatASessionShowsOfARecordingThatItCannotCompute) {
  const auto history = history_of(of_another_format(minute_of_demo_c()));
  TestSession session("", 50.0, [&](SessionSettings& settings) { settings.recording = {"demo", history}; });
  Browser anna(session, "Anna");
  ASSERT_TRUE(anna.wait([&] { return anna.roster().robots_size() > 0 && !anna.moment().is_coming(); }));
  ASSERT_TRUE(anna.wait([&] { return !anna.time_line().only_recorded().empty(); }));
  EXPECT_NE(anna.time_line().only_recorded().find("it is of format 2"), std::string::npos);
  EXPECT_EQ(anna.time_line().why_not(), "");
  ToServer look;
  look.mutable_look_back()->set_time(45.0);
  ASSERT_EQ(Browser::error_of(anna.ask(look)), "");
  ASSERT_TRUE(anna.wait([&] { return anna.frame().cycle() == 450; }));
  EXPECT_FALSE(anna.frame().robots().empty());
  EXPECT_TRUE(anna.wait([&] { return !anna.log().empty(); }));
  look.mutable_look_back()->set_speed(20.0);
  ASSERT_EQ(Browser::error_of(anna.ask(look)), "");
  EXPECT_TRUE(anna.wait([&] { return anna.frame().cycle() == 600 && anna.moment().speed() == 0.0; }));
  ToServer read;
  read.mutable_read_past()->add_states_of(1);
  EXPECT_NE(Browser::error_of(anna.ask(read)).find("can't be computed again"), std::string::npos);
  ToServer find;
  find.mutable_find_moments()->set_condition("any robot in contact");
  EXPECT_NE(Browser::error_of(anna.ask(find)).find("can't be computed again"), std::string::npos);
}

// Another version of the program may compute otherwise: from there on what was written is shown.
TEST(RecordedPast, IsShownFromWhereTheRunPartsFromWhatWasWritten) {
  Entries entries = minute_of_demo_c();
  bool has_parted = false;
  for (wire::HistoryEntry& entry : entries) {
    if (!entry.has_mark() || entry.cycle() < 300 || std::exchange(has_parted, true)) continue;
    entry.mutable_mark()->set_digest(entry.mark().digest() + 1);
  }
  ASSERT_TRUE(has_parted);
  const auto history = history_of(entries);
  TestSession session("", 50.0, [&](SessionSettings& settings) { settings.recording = {"demo", history}; });
  Browser anna(session, "Anna");
  ASSERT_TRUE(anna.wait([&] { return !anna.time_line().parted().empty(); }));
  ToServer look;
  look.mutable_look_back()->set_time(55.0);
  ASSERT_EQ(Browser::error_of(anna.ask(look)), "");
  ASSERT_TRUE(anna.wait([&] { return !anna.moment().is_coming() && anna.frame().cycle() == 550; }));
  EXPECT_EQ(anna.moment().problem(), "");
  EXPECT_EQ(anna.roster().programs_size(), 0);
  look.mutable_look_back()->set_time(5.0);
  ASSERT_EQ(Browser::error_of(anna.ask(look)), "");
  ASSERT_TRUE(anna.wait([&] { return !anna.moment().is_coming() && anna.frame().cycle() == 50; }));
  EXPECT_GT(anna.roster().programs_size(), 0) << "computed, with all that belongs to it";
}

}  // namespace
}  // namespace mlab::console
