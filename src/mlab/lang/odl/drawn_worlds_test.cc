#include "mlab/lang/odl/drawn_worlds.h"

#include <cstddef>
#include <memory>
#include <set>

#include <gtest/gtest.h>

#include "mlab/lang/odl/odl.h"
#include "mlab/overlay/barriers.h"
#include "mlab/text/diagnostic.h"

namespace mlab::odl {
namespace {

overlay::Overlay read(WorldKind kind, std::uint64_t seed) {
  text::Diagnostics sink;
  const auto source =
      std::make_shared<text::Source>("world.odl", text_of(drawn_world(kind, seed), kind, seed));
  overlay::Overlay out;
  apply(parse(source, sink), out, sink, Companions::kIgnore);
  EXPECT_TRUE(sink.items().empty()) << text::render(sink);
  return out;
}

TEST(DrawnWorlds, AreOverlaysWithAFreeStartAndGoal) {
  for (std::size_t i = 0; i < kWorldKinds.size(); ++i) {
    std::set<std::string> texts;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      SCOPED_TRACE(std::string(kWorldKinds.at(i).name) + " " + std::to_string(seed));
      const auto kind = static_cast<WorldKind>(i);
      texts.insert(text_of(drawn_world(kind, seed), kind, 0));
      const overlay::Overlay map = read(kind, seed);
      ASSERT_TRUE(map.area);
      for (const char* name : {"Start", "Goal"}) {
        const overlay::ControlMeasure* place = find_measure(map, name);
        ASSERT_NE(place, nullptr);
        const geom::Point at = place->points[0];
        EXPECT_TRUE(at.x > 0 && at.y > 0 && at.x < map.area->width && at.y < map.area->height);
        for (const overlay::Barrier& wall : overlay::barriers(map))
          EXPECT_GT(distance(nearest_point(wall.segment, at), at), 3.0);
        for (const overlay::ObstacleDisc& disc : map.obstacles) {
          EXPECT_GT(disc.radius, 0.0);
          EXPECT_TRUE(disc.is_moving() || distance(disc.center, at) > disc.radius + 3.0);
        }
      }
    }
    EXPECT_EQ(texts.size(), 20U) << "each seed another one";
  }
}

TEST(DrawnWorlds, AreTheSameForTheSameSeed) {
  const auto text = [] { return text_of(drawn_world(WorldKind::kMaze, 7), WorldKind::kMaze, 7); };
  EXPECT_EQ(text(), text());
}

}  // namespace
}  // namespace mlab::odl
