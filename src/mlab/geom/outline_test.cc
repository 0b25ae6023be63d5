#include "mlab/geom/outline.h"

#include <vector>

#include <gtest/gtest.h>

namespace mlab::geom {
namespace {

TEST(Outline, HasWithinWhatItGoesRound) {
  // As a horseshoe that is open to the north.
  const std::vector<Point> shoe = {{0, 0}, {9, 0}, {9, 9}, {6, 9}, {6, 3}, {3, 3}, {3, 9}, {0, 9}};
  const std::vector<Point> turned(shoe.rbegin(), shoe.rend());
  for (const auto& outline : {shoe, turned}) {
    for (const Point p : {Point{1, 8}, Point{8, 8}, Point{4, 1}}) EXPECT_TRUE(is_within(outline, p)) << p.x;
    for (const Point p : {Point{4, 8}, Point{-1, 3}, Point{10, 3}, Point{4, -1}})
      EXPECT_FALSE(is_within(outline, p)) << p.x;
  }
  EXPECT_FALSE(is_within({}, {0, 0}));
}

}  // namespace
}  // namespace mlab::geom
