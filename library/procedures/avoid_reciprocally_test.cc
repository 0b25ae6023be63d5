#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "../testing/library_probe.h"

namespace mlab::library_test {
namespace {

using geom::Point;
using geom::Vector;

TEST(AvoidReciprocally, LeavesAMovementThatMeetsNobody) {
  flow::BehaviorProbe p = probe("AvoidReciprocally");
  p.set("v", Vector{0.8, 0.2, 0.3}).set("base_velocity", 5.0).set("max_velocity", 7.0);
  p.step();
  expect_near(p.output<Vector>(), {0.8, 0.2, 0.3});
}

TEST(AvoidReciprocally, KeepsOffWhatIsSolid) {
  flow::BehaviorProbe p = probe("AvoidReciprocally");
  p.set("v", Vector{1.0, 0.0, 0.0}).set("base_velocity", 5.0).set("max_velocity", 7.0);
  const double radius = 0.2;
  const double gap = 0.2;
  double nearest = 1e9;
  for (int i = 0; i < 100; ++i) {
    const Vector rock = p.percepts.pose.to_robot(Point{10.0, 0.01});
    const std::vector<percept::Obstacle> rocks{{rock, 2.0}};
    p.percepts.obstacles = rocks;
    p.set("obstacles", all<flow::Obstacles>(1));
    p.step();
    p.percepts.pose.position = p.percepts.pose.position + p.percepts.pose.to_world(p.output<Vector>()) *
                                                              (5.0 * p.percepts.cycle_duration);
    nearest = std::min(nearest, distance(p.percepts.pose.position, {10.0, 0.01}));
  }
  EXPECT_GT(nearest, 2.0 + radius + gap - 0.05);
}

TEST(AvoidReciprocally, KeepsClearOfWhatMovesByItself) {
  for (const double speed : {1.0, 2.0, 3.0}) {
    for (int start = 0; start < 12; ++start) {
      flow::BehaviorProbe p = probe("AvoidReciprocally");
      p.set("v", Vector{1.0, 0.0, 0.0}).set("base_velocity", 3.0).set("max_velocity", 5.0);
      Point rock{20.0, 30.0 - 2.0 * start};
      double nearest = 1e9;
      for (int i = 0; i < 200; ++i) {
        const auto& pose = p.percepts.pose;
        const std::vector<percept::Obstacle> rocks{
            {pose.to_robot(rock), 2.0, pose.to_robot(geom::Offset{0.0, -speed})}};
        p.percepts.obstacles = rocks;
        p.set("obstacles", all<flow::Obstacles>(1));
        p.step();
        p.percepts.pose.position =
            pose.position + pose.to_world(p.output<Vector>()) * (3.0 * p.percepts.cycle_duration);
        rock.y -= speed * p.percepts.cycle_duration;
        nearest = std::min(nearest, distance(p.percepts.pose.position, rock));
      }
      EXPECT_GT(nearest, 2.0 + 0.2) << speed << " " << start;
      EXPECT_GT(p.percepts.pose.position.x, 25.0) << speed << " " << start;
    }
  }
}

TEST(AvoidReciprocally, PassesTheEndOfAWallWithoutTouchingIt) {
  const double radius = 0.2;
  const std::vector<geom::Segment> walls{{{0.0, -20.0}, {0.0, -0.05}}, {{0.0, 1.2}, {0.0, 20.0}}};
  for (int start = 0; start < 33; ++start) {
    flow::BehaviorProbe p = probe("AvoidReciprocally");
    const double angle = 0.06 * start - 0.96;
    p.percepts.pose = {{-3.0 * std::cos(angle), 0.5 - 3.0 * std::sin(angle)}, angle};
    p.percepts.ground.walls = walls;
    p.percepts.ground.revision = 1;
    p.set("v", Vector{1.0, 0.0, 0.0}).set("base_velocity", 5.0).set("max_velocity", 7.0);
    for (int i = 0; i < 15; ++i) {
      p.step();
      const Point before = p.percepts.pose.position;
      const geom::Offset motion =
          p.percepts.pose.to_world(p.output<Vector>()) * (5.0 * p.percepts.cycle_duration);
      for (int part = 0; part <= 50; ++part) {
        const Point here = before + motion * (part / 50.0);
        for (const geom::Segment& wall : walls)
          ASSERT_GT(distance(nearest_point(wall, here), here), radius) << start << " " << i;
      }
      p.percepts.pose.position = before + motion;
    }
    EXPECT_GT(p.percepts.pose.position.x, 0.0) << "through the door from " << angle;
  }
}

// In a corner of the area, where the edge holds them, too.
TEST(AvoidReciprocally, ACrowdThatIsSentToOnePlaceDoesNotTouch) {
  constexpr std::size_t kCount = 9;
  const double radius = 0.2;
  std::vector<flow::BehaviorProbe> crowd;
  for (std::size_t i = 0; i < kCount; ++i) {
    crowd.push_back(probe("AvoidReciprocally"));
    const std::size_t row = i / 3;
    crowd.back().percepts.pose.position = {1.5 * static_cast<double>(i % 3), 1.5 * static_cast<double>(row)};
    crowd.back().percepts.ground.bounds = {-10.0, -10.0, 3.5, 3.5};
  }
  for (int cycle = 0; cycle < 200; ++cycle) {
    std::vector<geom::Offset> motions;
    for (std::size_t i = 0; i < kCount; ++i) {
      flow::BehaviorProbe& p = crowd[i];
      const geom::Pose& pose = p.percepts.pose;
      std::vector<percept::RobotReading> seen;
      for (std::size_t j = 0; j < kCount; ++j) {
        if (j == i) continue;
        seen.push_back({.id = {static_cast<std::uint32_t>(j + 1)},
                        .center = pose.to_robot(crowd[j].percepts.pose.position),
                        .radius = radius});
      }
      std::ranges::sort(seen, {}, [](const percept::RobotReading& r) { return length(r.center); });
      p.percepts.robots = seen;
      const Vector wish = pose.to_robot(Point{4.0, 4.0}) * 0.5;
      p.set("v", length(wish) > 1.0 ? wish * (1.0 / length(wish)) : wish)
          .set("robots", all<flow::Robots>(kCount - 1));
      p.set("base_velocity", 5.0).set("max_velocity", 7.0);
      p.step();
      motions.push_back(pose.to_world(p.output<Vector>()) * (5.0 * p.percepts.cycle_duration));
    }
    for (std::size_t i = 0; i < kCount; ++i) {
      const Point here = crowd[i].percepts.pose.position;
      EXPECT_LE((here + motions[i]).x, 3.5 + 1e-9);
      EXPECT_LE((here + motions[i]).y, 3.5 + 1e-9);
      for (std::size_t j = 0; j < i; ++j) {
        for (int part = 0; part <= 20; ++part) {
          const geom::Offset between = crowd[j].percepts.pose.position + motions[j] * (part / 20.0) -
                                       (here + motions[i] * (part / 20.0));
          ASSERT_GT(length(between), 2.0 * radius) << "cycle " << cycle << ": " << i << " and " << j;
        }
      }
    }
    for (std::size_t i = 0; i < kCount; ++i)
      crowd[i].percepts.pose.position = crowd[i].percepts.pose.position + motions[i];
  }
  for (const flow::BehaviorProbe& p : crowd)
    EXPECT_LT(distance(p.percepts.pose.position, {3.5, 3.5}), 4.0) << "they come near";
}

TEST(AvoidReciprocally, TwoThatMeetHeadOnPassOnTheRight) {
  flow::BehaviorProbe a = probe("AvoidReciprocally");
  flow::BehaviorProbe b = probe("AvoidReciprocally");
  a.percepts.pose = {{0.0, 0.0}, 0.0};
  b.percepts.pose = {{30.0, 0.0}, 0.0};
  double nearest = 1e9;
  for (int i = 0; i < 80; ++i) {
    const auto sight = [](const flow::BehaviorProbe& of, const flow::BehaviorProbe& other, std::uint32_t id) {
      return percept::RobotReading{.id = {id},
                                   .center = of.percepts.pose.to_robot(other.percepts.pose.position)};
    };
    const std::vector<percept::RobotReading> of_a{sight(a, b, 2)};
    const std::vector<percept::RobotReading> of_b{sight(b, a, 1)};
    const auto step = [](flow::BehaviorProbe& p, const std::vector<percept::RobotReading>& seen,
                         double ahead) {
      p.percepts.robots = seen;
      p.set("robots", all<flow::Robots>(1)).set("v", Vector{ahead, 0.0, 0.0});
      p.set("base_velocity", 5.0).set("max_velocity", 7.0);
      p.step();
    };
    step(a, of_a, 0.8);
    step(b, of_b, -0.8);
    for (flow::BehaviorProbe* p : {&a, &b})
      p->percepts.pose.position =
          p->percepts.pose.position + p->percepts.pose.to_world(p->output<Vector>()) * (5.0 * 0.1);
    nearest = std::min(nearest, distance(a.percepts.pose.position, b.percepts.pose.position));
  }
  EXPECT_GT(nearest, 0.9);
  EXPECT_GT(a.percepts.pose.position.x, 28.0);
  EXPECT_LT(b.percepts.pose.position.x, 2.0);
  EXPECT_LT(a.percepts.pose.position.y, 0.0);
}

TEST(AvoidReciprocally, ComesNoNearerToWhoIsNearerThanTheGapAndDoesNotFlee) {
  for (const double forward : {0.0, 0.5, 1.0}) {
    flow::BehaviorProbe p = probe("AvoidReciprocally");
    const std::vector<percept::RobotReading> beside{{.id = {2}, .center = {0.8, 0.0, 0.0}}};
    p.percepts.robots = beside;
    p.set("robots", all<flow::Robots>(1)).set("v", Vector{forward, 0.0, 0.0});
    p.set("base_velocity", 5.0).set("max_velocity", 7.0).set("gap", 0.6);
    p.step();
    EXPECT_NEAR(p.output<Vector>().x, 0.0, 1e-6) << forward;
  }
}

}  // namespace
}  // namespace mlab::library_test
