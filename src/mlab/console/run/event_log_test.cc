#include "mlab/console/run/event_log.h"

#include <gtest/gtest.h>

namespace mlab::console {
namespace {

TEST(EventLog, TellsWhichAlertsAreOfAnEarlierRun) {
  EventLog log;
  log.add(1.0, {Log::STUCK, "robot 1 is stuck", 1, "", {}, true});
  log.begin_run();
  log.add(0.0, {Log::STUCK, "robot 2 is stuck", 2, "", {}, true});
  Log out;
  log.encode_since(0, out);
  EXPECT_EQ(out.alerts_after(), 1U);
  EXPECT_EQ(out.entries_size(), 2) << "they stay in the log";
}

TEST(EventLog, GivesWhatCameSince) {
  EventLog log;
  for (int i = 1; i <= 5; ++i) log.add(i, {Log::MESSAGE, std::to_string(i), 0, "", {}, false});
  Log out;
  log.encode_since(3, out);
  ASSERT_EQ(out.entries_size(), 2);
  EXPECT_EQ(out.entries(0).number(), 4U);
  EXPECT_EQ(out.entries(1).text(), "5");
  EXPECT_FALSE(out.is_whole());
  Log none;
  log.encode_since(5, none);
  EXPECT_EQ(none.entries_size(), 0);
}

TEST(EventLog, KeepsTheLastTenThousand) {
  EventLog log;
  for (int i = 0; i < 10500; ++i) log.add(i, {Log::STATE, "x", 1, "", geom::Point{1.0, 2.0}, true});
  Log out;
  log.encode_since(0, out);
  EXPECT_EQ(out.entries_size(), 10000);
  EXPECT_EQ(out.entries(0).number(), 501U);
  EXPECT_TRUE(out.is_whole());
  EXPECT_EQ(out.entries(0).place().y(), 2.0);
}

TEST(EventLog, ShowsNoControlCharacters) {
  EventLog log;
  log.add(0.0, {Log::WARNING, "a\x1b[2Jb", 0, "", {}, false});
  Log out;
  log.encode_since(0, out);
  EXPECT_EQ(out.entries(0).text().find('\x1b'), std::string::npos);
}

}  // namespace
}  // namespace mlab::console
