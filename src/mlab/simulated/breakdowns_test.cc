#include "mlab/simulated/breakdowns.h"

#include <cmath>
#include <memory>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "mlab/run/mission_run.h"
#include "mlab/sim/simulated_binding.h"
#include "mlab/simulated/run.h"

// Robots that break down in simulation, by the seed.
namespace mlab::simulated {
namespace {

std::shared_ptr<mission::Mission> mission_of(std::uint32_t robots, double failing, double within) {
  auto out = std::make_shared<mission::Mission>();
  out->source = std::make_shared<const text::Source>("test.mdl", "");
  out->overlay.area = overlay::Area{1000.0, 1000.0};
  out->types.push_back({"ROBOT", "robot", "", "", {}, {out->source, {}}});
  mission::Unit unit;
  unit.name = "u";
  for (std::uint32_t i = 1; i <= robots; ++i) {
    mission::Robot robot;
    robot.id = {i};
    out->robots.push_back(robot);
    unit.members.push_back({i});
  }
  out->units.push_back(unit);
  out->options.failing_robots = failing;
  out->options.failures_within = within;
  return out;
}

std::set<std::uint32_t> ids_of(const std::vector<Breakdown>& all) {
  std::set<std::uint32_t> out;
  for (const Breakdown& one : all) out.insert(one.robot.value);
  return out;
}

TEST(Breakdowns, HangOnTheSeedAndOnThoseThatFailBefore) {
  std::set<std::set<std::uint32_t>> pairs;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const auto two = breakdowns_of(*mission_of(6, 2, 50), seed);
    const auto three = breakdowns_of(*mission_of(6, 3, 50), seed);
    ASSERT_EQ(two.size(), 2U);
    EXPECT_EQ(ids_of(two).size(), 2U);
    for (std::size_t i = 0; i < two.size(); ++i) {
      EXPECT_EQ(two[i].robot, three[i].robot);
      EXPECT_EQ(two[i].after, three[i].after);
      EXPECT_GE(two[i].after, 0.0);
      EXPECT_LT(two[i].after, 50.0);
    }
    pairs.insert(ids_of(two));
  }
  EXPECT_GT(pairs.size(), 8U);
  EXPECT_TRUE(breakdowns_of(*mission_of(6, 0, 50), 1).empty());
  EXPECT_EQ(breakdowns_of(*mission_of(3, 50, 50), 1).size(), 3U);
}

// Whose time has come is told once, and after a step back again.
TEST(Breakdowns, ComeOnceToABody) {
  sim::SimulatedBinding bodies(sim::World{}, {1, 1, {{{7}, 0.25}}});
  const auto embody = [&](std::uint32_t robot, double x) {
    return bodies.embody({binding::BodySpec{}, {{x, 0.0}, 0.0}, {robot}, 0})->body;
  };
  embody(3, 0.0);
  const binding::BodyIndex fragile = embody(7, 5.0);
  const auto ailing = [&] {
    std::vector<binding::Ailment> out;
    bodies.health(out);
    return out;
  };
  const auto before = bodies.save();
  ASSERT_TRUE(before);
  EXPECT_TRUE(ailing().empty());
  for (int round = 0; round < 2; ++round) {
    for (int i = 0; i < 2; ++i) bodies.carry_out({}, 0.1);
    EXPECT_TRUE(ailing().empty());
    bodies.carry_out({}, 0.1);
    const auto now = ailing();
    ASSERT_EQ(now.size(), 1U);
    EXPECT_EQ(now[0].body, fragile);
    EXPECT_TRUE(ailing().empty());
    ASSERT_TRUE(bodies.restore(**before));
  }
  for (int i = 0; i < 3; ++i) bodies.carry_out({}, 0.1);
  ASSERT_EQ(ailing().size(), 1U);
  bodies.release(fragile);
  embody(7, 9.0);  // who takes its place is well
  for (int i = 0; i < 10; ++i) bodies.carry_out({}, 0.1);
  EXPECT_TRUE(ailing().empty());
}

}  // namespace
}  // namespace mlab::simulated
