#include "mlab/console/past/told_apart.h"

#include <string>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace mlab::console {
namespace {

void tell(EventLog& log, double time, const std::string& text, Log::Kind kind = Log::MESSAGE,
          bool is_alert = false) {
  log.add(time, {kind, text, 0, "", {}, is_alert});
}

TEST(ToldApart, TheSameWordsAreTheSameEventWheneverTheyWereTold) {
  EventLog own;
  EventLog other;
  tell(own, 1.0, "step 1 begins");
  tell(own, 2.0, "robot 1 is stuck", Log::STUCK, true);
  tell(own, 9.0, "done");
  tell(other, 1.5, "step 1 begins");
  tell(other, 3.0, "typed: no such unit", Log::WARNING, true);
  tell(other, 4.0, "robot 1 is in Walk", Log::STATE);
  tell(other, 5.0, "done");
  tell(other, 6.0, "done");
  const ToldApart apart = told_apart(own, other);
  ASSERT_EQ(apart.alone[0].size(), 1U);
  EXPECT_EQ(apart.alone[0][0].text(), "robot 1 is stuck");
  ASSERT_EQ(apart.alone[1].size(), 2U);
  EXPECT_EQ(apart.alone[1][0].text(), "typed: no such unit");
  EXPECT_EQ(apart.alone[1][0].time(), 3.0);
  EXPECT_TRUE(apart.alone[1][0].is_alert());
  EXPECT_EQ(apart.alone[1][1].text(), "done");
  EXPECT_EQ(apart.left_out, 0U);
}

TEST(ToldApart, OfTooMuchAlertsAreKept) {
  EventLog own;
  EventLog other;
  for (int i = 0; i < 500; ++i) tell(other, i, fmt::format("message {}", i));
  tell(other, 600.0, "robot 3 no longer reports", Log::LOST, true);
  const ToldApart apart = told_apart(own, other);
  ASSERT_EQ(apart.alone[1].size(), ToldApart::kMost);
  EXPECT_EQ(apart.alone[1].front().text(), "message 0");
  EXPECT_EQ(apart.alone[1].back().text(), "robot 3 no longer reports");
  EXPECT_EQ(apart.left_out, 501 - ToldApart::kMost);
}

}  // namespace
}  // namespace mlab::console
