#include "mlab/console/run/speed_meter.h"

#include <gtest/gtest.h>

namespace mlab::console {
namespace {

TEST(SpeedMeter, TellsTheSpeedOfTheLastSecond) {
  SpeedMeter meter;
  for (int i = 0; i <= 300; ++i) meter.note(i * 0.01, i <= 150 ? i * 0.1 : 15.0 + (i - 150) * 0.05);
  EXPECT_NEAR(meter.speed(3.0), 5.0, 0.1);
}

TEST(SpeedMeter, IsZeroWhenTimeStands) {
  SpeedMeter meter;
  for (int i = 0; i <= 100; ++i) meter.note(i * 0.01, i * 0.1);
  EXPECT_EQ(meter.speed(2.0), 0.0);
}

TEST(SpeedMeter, BeginsAnewWithTheRun) {
  SpeedMeter meter;
  meter.note(0.0, 100.0);
  meter.note(0.1, 0.0);
  EXPECT_GE(meter.speed(0.1), 0.0);
}

}  // namespace
}  // namespace mlab::console
