#include "mlab/mission/clock.h"

#include <gtest/gtest.h>

namespace mlab::mission {
namespace {

// The clock starts on 1995-01-17 at 07:00:00, five hours west of Greenwich.
const ExecutiveOptions kClock{.epoch_seconds = 790344000.0, .zone_offset = -5.0 * 3600.0};

TEST(Clock, CountsSinceTheUnitCameOrSinceTheStart) {
  EXPECT_EQ(run_time_of({MissionTime::Kind::kSinceReached, 30.0}, kClock, 100.0), 130.0);
  EXPECT_EQ(run_time_of({MissionTime::Kind::kSinceStart, 30.0}, kClock, 100.0), 30.0);
}

TEST(Clock, ReadsTimesOfTheDayOfTheStartInItsOwnZone) {
  EXPECT_EQ(run_time_of({MissionTime::Kind::kOfDay, 7.5 * 3600}, kClock, 0.0), 1800.0);
  EXPECT_EQ(run_time_of({MissionTime::Kind::kOfDay, 6.0 * 3600}, kClock, 0.0), -3600.0);
}

TEST(Clock, ReadsDatesInItsOwnZone) {
  EXPECT_EQ(run_time_of({MissionTime::Kind::kAbsolute, 790344000.0 - 5 * 3600 + 90.0}, kClock, 0.0), 90.0);
}

TEST(Clock, ShowsHoursMinutesAndSeconds) {
  EXPECT_EQ(clock_text(0.0, kClock), "07:00:00");
  EXPECT_EQ(clock_text(3661.4, kClock), "08:01:01");
  EXPECT_EQ(clock_text(-7.0 * 3600 - 1.0, kClock), "23:59:59");
}

}  // namespace
}  // namespace mlab::mission
