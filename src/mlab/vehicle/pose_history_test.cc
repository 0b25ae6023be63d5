#include "mlab/vehicle/pose_history.h"

#include <chrono>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace mlab::vehicle {
namespace {

Clock::time_point moment(double seconds) {
  return Clock::time_point(
      std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds)));
}

// On a circle of 1 m round the origin, counter-clockwise, at 2 rad/s.
Motion on_circle(double seconds) {
  const double angle = 2.0 * seconds;
  return {{{std::cos(angle), std::sin(angle)},
           std::remainder(angle + std::numbers::pi / 2.0, 2.0 * std::numbers::pi)},
          2.0,
          2.0,
          moment(seconds)};
}

void expect_on_circle(const PoseHistory& history, double seconds, double error) {
  const auto pose = history.at(moment(seconds));
  ASSERT_TRUE(pose);
  const Motion truth = on_circle(seconds);
  EXPECT_LE(geom::distance(pose->position, truth.pose.position), error) << seconds;
  EXPECT_NEAR(std::remainder(pose->heading - truth.pose.heading, 2.0 * std::numbers::pi), 0.0, error)
      << seconds;
}

TEST(PoseHistory, TellsWhereAVehicleWasBetweenWhatItSaid) {
  PoseHistory history;
  EXPECT_FALSE(history.at(moment(10.0)));
  for (int i = 0; i <= 20; ++i) history.add(on_circle(10.0 + 0.1 * i));
  for (double t = 10.0; t <= 12.0; t += 0.013) expect_on_circle(history, t, 0.006);
}

TEST(PoseHistory, GoesOnForAMomentAsTheVehicleMoved) {
  PoseHistory history;
  history.add(on_circle(10.0));
  expect_on_circle(history, 10.2, 0.03);
  expect_on_circle(history, 9.8, 0.03);
  EXPECT_FALSE(history.at(moment(10.6)));
  EXPECT_FALSE(history.at(moment(9.4)));
}

TEST(PoseHistory, KnowsNothingOfGapsAndOfWhatIsLongPast) {
  PoseHistory history;
  history.add(on_circle(10.0));
  history.add(on_circle(12.0));
  EXPECT_FALSE(history.at(moment(11.0)));
  history.add(on_circle(13.5));
  EXPECT_FALSE(history.at(moment(10.0)));
}

TEST(PoseHistory, LeavesOutWhatRunsBackwards) {
  PoseHistory history;
  history.add(on_circle(10.0));
  Motion late = on_circle(9.9);
  late.pose.position = {50.0, 0.0};
  history.add(late);
  expect_on_circle(history, 9.9, 0.03);
}

}  // namespace
}  // namespace mlab::vehicle
