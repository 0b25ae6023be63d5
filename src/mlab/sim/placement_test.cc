#include "mlab/sim/placement.h"

#include <gtest/gtest.h>

#include "mlab/base/testing/processor_time.h"

namespace mlab::sim {
namespace {

using geom::Point;

constexpr Box kArea{0.0, 0.0, 100.0, 100.0};
constexpr double kRadius = 0.2;

void put(Bodies& bodies, Point place) {
  bodies.x.push_back(place.x);
  bodies.y.push_back(place.y);
  bodies.radius.push_back(kRadius);
  bodies.present.push_back(1);
}

// One that has searched for the same place before, and one that has not, must agree.
TEST(Placer, FindsTheSamePlacesWhetherItSearchedForThemBeforeOrNot) {
  const Statics statics({{{50.5, 50.0}, 1.0}}, {});
  Bodies bodies;
  Placer placer;
  placer.rebuild(bodies);
  for (int i = 0; i < base::examples(300); ++i) {
    const Point wanted = i % 7 == 3 ? Point{52.0, 50.0} : Point{50.0, 50.0};
    const auto place = placer.nearest_free(bodies, statics, wanted, kRadius, kArea);
    Placer fresh;
    fresh.rebuild(bodies);
    ASSERT_EQ(place, fresh.nearest_free(bodies, statics, wanted, kRadius, kArea)) << i;
    ASSERT_TRUE(place);
    put(bodies, *place);
    placer.add(bodies, static_cast<std::uint32_t>(i));
  }
}

TEST(Placer, PutsNobodyWhereHeTouchesAnotherOneUnlessThatIsWanted) {
  const Statics statics({}, {});
  Bodies bodies;
  Placer placer;
  placer.rebuild(bodies);
  for (std::uint32_t i = 0; i < 50; ++i) {
    const auto place = placer.nearest_free(bodies, statics, {50.0, 50.0}, kRadius, kArea);
    ASSERT_TRUE(place);
    for (std::uint32_t other = 0; other < i; ++other)
      ASSERT_GE(distance(bodies.position(other), *place), 4.0 * kRadius) << i;
    put(bodies, *place);
    placer.add(bodies, i);
  }
  Bodies one;
  put(one, {50.0, 50.0});
  placer.rebuild(one);
  const Point beside{50.0 + 2.0 * kRadius, 50.0};
  EXPECT_EQ(placer.nearest_free(one, statics, beside, kRadius, kArea), beside);
}

TEST(Placer, PutsThemSoThatTheyTouchWhereThereIsNoOtherRoom) {
  const Statics statics({}, {});
  Bodies bodies;
  put(bodies, {50.0, 50.0});
  Placer placer;
  placer.rebuild(bodies);
  const Box narrow{50.0, 50.0, 50.41, 50.0};
  EXPECT_TRUE(placer.nearest_free(bodies, statics, {50.0, 50.0}, kRadius, narrow));
}

TEST(Placer, PutsNobodyBehindAWallWhereThereIsRoomBeforeIt) {
  const Statics statics({}, {{{{50.5, 0.0}, {50.5, 100.0}}, 0}, {{{49.5, 0.0}, {49.5, 100.0}}, 1}});
  Bodies bodies;
  Placer placer;
  placer.rebuild(bodies);
  for (std::uint32_t i = 0; i < 20; ++i) {
    const auto place = placer.nearest_free(bodies, statics, {50.0, 50.0}, kRadius, kArea);
    ASSERT_TRUE(place);
    EXPECT_NEAR(place->x, 50.0, 0.5) << i;
    put(bodies, *place);
    placer.add(bodies, i);
  }
}

TEST(Placer, SearchesFromTheMiddleAgainAfterARebuild) {
  const Statics statics({}, {});
  Bodies bodies;
  Placer placer;
  placer.rebuild(bodies);
  const Point wanted{50.0, 50.0};
  for (std::uint32_t i = 0; i < 50; ++i) {
    put(bodies, *placer.nearest_free(bodies, statics, wanted, kRadius, kArea));
    placer.add(bodies, i);
  }
  bodies.present[1] = 0;
  placer.rebuild(bodies);
  EXPECT_EQ(placer.nearest_free(bodies, statics, wanted, kRadius, kArea), bodies.position(1));
}

}  // namespace
}  // namespace mlab::sim
