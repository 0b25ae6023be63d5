#include "mlab/sim/clear_place.h"

#include <vector>

#include <gtest/gtest.h>

#include "mlab/base/random.h"

namespace mlab::sim {
namespace {

using geom::Point;

std::vector<Disc> discs() {
  return {{{10.0, 0.0}, 2.0}, {{0.0, 30.0}, 5.0}, {{-200.0, 0.0}, 150.0}};
}
std::vector<Wall> walls() {
  return {{{{20.0, -20.0}, {20.0, 20.0}}, 1}};
}

TEST(ClearPlace, CoversWhatLiesBeforeTheNearestThing) {
  const Statics statics(discs(), walls());
  const ClearPlace place = ClearPlace::look(statics, {0.0, 0.0}, 100.0);
  EXPECT_TRUE(place.covers(statics, {0.0, 0.0}, 7.9)) << "the edge of the first disc is 8 m away";
  EXPECT_FALSE(place.covers(statics, {0.0, 0.0}, 8.1));
  EXPECT_TRUE(place.covers(statics, {-3.0, 0.0}, 4.9));
  EXPECT_FALSE(place.covers(statics, {-3.0, 0.0}, 5.1)) << "though it has gone away from it";
  const ClearPlace beside = ClearPlace::look(statics, {17.0, 15.0}, 100.0);
  EXPECT_FALSE(beside.covers(statics, {17.0, 15.0}, 3.1)) << "a wall";
  const ClearPlace short_sighted = ClearPlace::look(statics, {0.0, 0.0}, 3.0);
  EXPECT_TRUE(short_sighted.covers(statics, {0.0, 0.0}, 2.9));
  EXPECT_FALSE(short_sighted.covers(statics, {0.0, 0.0}, 3.1)) << "nobody has looked there";
}

TEST(ClearPlace, IsOfThoseStaticsAlone) {
  const Statics statics(discs(), walls());
  const Statics others(discs(), walls());
  EXPECT_FALSE(ClearPlace{}.covers(statics, {0.0, 0.0}, 0.0));
  const ClearPlace place = ClearPlace::look(statics, {0.0, 0.0}, 5.0);
  EXPECT_TRUE(place.covers(statics, {0.0, 0.0}, 1.0));
  EXPECT_FALSE(place.covers(others, {0.0, 0.0}, 1.0)) << "what stands there may be something else";
}

// Whatever it covers is as free as a look at everything says.
TEST(ClearPlace, NeverCoversWhatIsNear) {
  base::Random random = base::Random::of(1, 2, 3, 4);
  std::vector<Disc> many;
  for (int i = 0; i < 60; ++i)
    many.push_back({{200.0 * random.uniform(), 200.0 * random.uniform()}, 0.1 + 8.0 * random.uniform()});
  const Statics statics(many, {});
  int covered = 0;
  for (int i = 0; i < 2000; ++i) {
    const Point from{200.0 * random.uniform(), 200.0 * random.uniform()};
    const ClearPlace place = ClearPlace::look(statics, from, 20.0);
    const Point to{from.x + 4.0 * random.uniform(), from.y + 4.0 * random.uniform()};
    const double reach = 8.0 * random.uniform();
    if (!place.covers(statics, to, reach)) continue;
    ++covered;
    for (const Disc& disc : many) ASSERT_GT(distance(disc.center, to) - disc.radius, reach);
  }
  EXPECT_GT(covered, 100);
}

}  // namespace
}  // namespace mlab::sim
