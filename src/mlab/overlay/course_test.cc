#include "mlab/overlay/course.h"

#include <gtest/gtest.h>

namespace mlab::overlay {
namespace {

using geom::Offset;
using geom::Point;

void expect_at(const Course& course, double time, Point place, Offset velocity) {
  const auto [is_place, is_velocity] = course.at(time);
  EXPECT_NEAR(is_place.x, place.x, 1e-12) << time;
  EXPECT_NEAR(is_place.y, place.y, 1e-12) << time;
  EXPECT_NEAR(is_velocity.x, velocity.x, 1e-12) << time;
  EXPECT_NEAR(is_velocity.y, velocity.y, 1e-12) << time;
}

TEST(Course, GoesThereAndBack) {
  const Course course({{0, 0}, {10, 0}, {10, 4}}, 2.0);
  expect_at(course, 0.0, {0, 0}, {2, 0});
  expect_at(course, 2.5, {5, 0}, {2, 0});
  expect_at(course, 6.0, {10, 2}, {0, 2});
  expect_at(course, 7.0, {10, 4}, {0, -2});
  expect_at(course, 8.0, {10, 2}, {0, -2});
  expect_at(course, 10.0, {8, 0}, {-2, 0});
  expect_at(course, 14.0, {0, 0}, {2, 0});
  expect_at(course, 14.0 * 1000 + 2.5, {5, 0}, {2, 0});
}

TEST(Course, GoesRoundAndRoundWhereItEndsWhereItBegins) {
  const Course course({{0, 0}, {3, 0}, {3, 4}, {0, 0}}, 1.0);
  expect_at(course, 3.0, {3, 0}, {0, 1});
  expect_at(course, 9.5, {1.5, 2}, {-0.6, -0.8});
  expect_at(course, 12.0, {0, 0}, {1, 0});
  expect_at(course, 13.0, {1, 0}, {1, 0});
}

TEST(Course, PassesOverPointsThatAreGivenTwice) {
  const Course course({{0, 0}, {0, 0}, {2, 0}, {2, 0}, {4, 0}, {4, 0}}, 1.0);
  expect_at(course, 0.0, {0, 0}, {1, 0});
  expect_at(course, 2.0, {2, 0}, {1, 0});
  expect_at(course, 4.0, {4, 0}, {-1, 0});
  expect_at(course, 6.0, {2, 0}, {-1, 0});
  expect_at(course, 7.5, {0.5, 0}, {-1, 0});
}

TEST(Course, IsAtItsBeginningBeforeTheRun) {
  expect_at(Course({{1, 2}, {5, 2}}, 1.0), -3.0, {1, 2}, {1, 0});
}

TEST(Course, OfAnObstacleBeginsAtItsCenter) {
  const Course course =
      course_of({.center = {1, 1}, .radius = 1, .height = 0, .place = {}, .route = {{1, 5}}, .speed = 0.5});
  expect_at(course, 4.0, {1, 3}, {0, 0.5});
}

TEST(Course, NeverJumps) {
  const Course course({{0, 0}, {10, 0}, {10, 7.3}, {-4, 2}}, 3.0);
  for (int i = 0; i < 2000; ++i) {
    const double step = distance(course.at(i * 0.05).place, course.at((i + 1) * 0.05).place);
    EXPECT_LE(step, 3.0 * 0.05 + 1e-9) << i;
  }
}

}  // namespace
}  // namespace mlab::overlay
