#include "mlab/schema/narrow.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace mlab::schema {
namespace {

using geom::Offset;

constexpr double kRadius = 0.2;
constexpr double kGap = 0.6;

// Someone ahead who comes, somewhat to the left.
Neighbour coming() {
  return {.place = {8.0, 0.2}, .velocity = {-3.0, 0.0}};
}
// A mate who goes the same way.
Neighbour beside(Offset place) {
  return {.place = place, .velocity = {3.0, 0.0}, .is_mate = true};
}

WayMade made(SideRoom room, const std::vector<Neighbour>& others) {
  return make_way({4.0, 0.0}, kRadius, kGap, room, others);
}

TEST(SideRoom, IsUpToWhatStandsOnEitherSide) {
  const std::vector<geom::Segment> walls{{{-5, 1}, {5, 1}}, {{-5, -2}, {5, -2}}, {{3, -1}, {3, 1}}};
  const std::vector<RoundThing> rocks{{{0.0, -1.5}, 0.25}};
  const SideRoom ahead = side_room({1.0, 0.0}, walls, {});
  EXPECT_DOUBLE_EQ(ahead.left, 1.0);
  EXPECT_DOUBLE_EQ(ahead.right, 2.0);
  EXPECT_TRUE(ahead.is_narrow(kRadius, kGap));
  EXPECT_DOUBLE_EQ(side_room({1.0, 0.0}, walls, rocks).right, 1.25);
  EXPECT_TRUE(std::isinf(side_room({0.0, 1.0}, walls, {}).left));
  EXPECT_FALSE(side_room({0.0, 1.0}, walls, {}).is_narrow(kRadius, kGap));
}

TEST(MakeWay, ChangesNothingWhereNobodyComes) {
  const WayMade out = made({1.0, 1.0}, {beside({0.2, -0.8}), beside({3.0, 0.0})});
  EXPECT_EQ(out.wanted, (Offset{4.0, 0.0}));
  EXPECT_EQ(out.gap, kGap);
}

TEST(MakeWay, ChangesNothingForWhoStandsOrIsFarAside) {
  Neighbour other = coming();
  other.goes_first = true;
  other.velocity = {};
  EXPECT_EQ(made({0.4, 0.4}, {other}).wanted, (Offset{4.0, 0.0}));
  other = coming();
  other.goes_first = true;
  other.place.y = 2.0 * other.place.x;
  EXPECT_EQ(made({0.4, 0.4}, {other}).wanted, (Offset{4.0, 0.0}));
}

TEST(MakeWay, KeepsToTheRightOfWhoComes) {
  const WayMade out = made({0.7, 0.8}, {coming()});
  EXPECT_EQ(out.wanted.x, 4.0);
  EXPECT_LT(out.wanted.y, 0.0);
  EXPECT_LT(out.gap, kGap);
  EXPECT_GE(out.gap, 0.25 * kGap);
}

TEST(MakeWay, FallsBackBehindAMateOnItsRight) {
  EXPECT_LT(made({0.7, 0.8}, {coming(), beside({0.2, -0.5})}).wanted.x, 0.0);
  EXPECT_GT(made({0.7, 0.8}, {coming(), beside({0.2, 0.5})}).wanted.x, 0.0) << "on its left";
  EXPECT_GT(made({0.7, 0.8}, {coming(), beside({-0.8, -0.5})}).wanted.x, 0.0) << "behind it";
}

TEST(MakeWay, WhereOnlyOnePassesSomebodyGoesBack) {
  Neighbour other = coming();
  EXPECT_GT(made({0.4, 0.4}, {other}).wanted.x, 0.0);
  other.goes_first = true;
  EXPECT_LT(made({0.4, 0.4}, {other}).wanted.x, 0.0);
  EXPECT_GT(made({0.8, 0.8}, {other}).wanted.x, 0.0) << "there is room for two";
}

}  // namespace
}  // namespace mlab::schema
