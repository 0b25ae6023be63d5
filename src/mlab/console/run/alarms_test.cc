#include "mlab/console/run/alarms.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "mlab/console/testing/run_of.h"

namespace mlab::console {
namespace {

int count(const EventLog& log, Log::Kind kind) {
  Log all;
  log.encode_since(0, all);
  int out = 0;
  for (const Log::Entry& entry : all.entries()) out += entry.kind() == kind ? 1 : 0;
  return out;
}

TEST(Alarms, ARobotThatGetsNoNearerIsStuckOnceAndNoLongerWhenItIsDone) {
  std::string text = "MISSION-AREA 400 400\nUNIT <a> ROBOT\n";
  for (int i = 0; i < 24; ++i) {  // a ring of obstacles without a gap
    const double angle = i * 2.0 * 3.14159265 / 24.0;
    text += "OBSTACLE " + std::to_string(200.0 + 40.0 * std::cos(angle)) + " " +
            std::to_string(200.0 + 40.0 * std::sin(angle)) + " 6\n";
  }
  text += "COMMAND LIST:\n0. UNIT a START 200 200 0 0\n1. UNIT a MOVETO 380 200\n";
  const auto run = testing::run_of(text);
  run->post(mission::event::Execute{});
  Alarms alarms;
  EventLog log;
  for (int i = 0; i < 600; ++i) {
    run->step();
    alarms.look(*run, log);
  }
  ASSERT_EQ(alarms.robots().size(), 1U);
  EXPECT_TRUE(alarms.robots()[0].is_stuck);
  EXPECT_EQ(count(log, Log::STUCK), 1);
  run->post(mission::event::Abort{});
  run->step();
  alarms.look(*run, log);
  EXPECT_FALSE(alarms.robots()[0].is_stuck);
}

TEST(Alarms, RobotsThatTravelFreelyGiveNone) {
  const auto run = testing::run_of(testing::kTravel);
  run->post(mission::event::Execute{});
  Alarms alarms;
  EventLog log;
  for (int i = 0; i < 600; ++i) {
    run->step();
    alarms.look(*run, log);
  }
  EXPECT_EQ(count(log, Log::STUCK), 0);
  EXPECT_EQ(count(log, Log::LOST), 0);
}

}  // namespace
}  // namespace mlab::console
