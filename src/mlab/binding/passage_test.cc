#include "mlab/binding/passage.h"

#include <gtest/gtest.h>

namespace mlab::binding {
namespace {

TEST(Passage, GoesStraightWhereNothingIsInTheWay) {
  const Passage::Way way = Passage{}.follow({1, 2}, {3, 4}, 0.2);
  EXPECT_EQ(way.corners().size(), 2U);
  EXPECT_EQ(way.end(), (geom::Point{4, 6}));
}

TEST(Passage, StopsBeforeADiscHeadOnAndSlidesPastOneAside) {
  Passage passage;
  passage.add(Disc{{5, 0}, 1.0});
  EXPECT_NEAR(passage.follow({0, 0}, {10, 0}, 0.5).end().x, 3.5, 1e-4);
  const Passage::Way aside = passage.follow({0, 0.9}, {10, 0}, 0.5);
  EXPECT_GT(aside.corners().size(), 2U);
  EXPECT_GT(aside.end().y, 1.2) << "led aside";
}

TEST(Passage, GoesAlongAWall) {
  Passage passage;
  passage.add(geom::Segment{{0, 1}, {10, 1}});
  const Passage::Way way = passage.follow({2, 0}, {4, 4}, 0.2);
  EXPECT_NEAR(way.end().y, 0.8, 1e-4);
  EXPECT_GT(way.end().x, 5.0) << "what goes against the wall is lost, the rest is not";
}

TEST(Passage, KeepsABodyInItsBox) {
  Passage passage;
  passage.keep_within({0.5, 0.5}, {9.5, 9.5});
  const Passage::Way way = passage.follow({9, 5}, {2, 1}, 0.2);
  EXPECT_DOUBLE_EQ(way.end().x, 9.5);
  EXPECT_DOUBLE_EQ(way.end().y, 6.0);
  EXPECT_TRUE(passage.is_near({9, 5}, 0.6));
  EXPECT_FALSE(passage.is_near({5, 5}, 0.6));
}

}  // namespace
}  // namespace mlab::binding
