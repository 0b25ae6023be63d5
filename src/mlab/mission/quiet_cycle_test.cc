#include <map>
#include <utility>

#include <gtest/gtest.h>

#include "mlab/base/testing/count_allocations.h"
#include "mlab/base/testing/processor_time.h"
#include "mlab/mission/executive.h"
#include "mlab/mission/testing/toy_fleet.h"

namespace mlab::mission {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace): the test's own vocabulary

// A unit of robots on its way.
struct QuietUnit {
  explicit QuietUnit(int robots) {
    MissionMaker m;
    const auto all = m.unit("all", robots);
    m.step({start(all, {0, 0}, {1, 0})}).step({move_to(all, "A", {0, 9000})});
    state = initial_state(m.make());
    for (const RobotState& robot : state.robots) {
      RobotReport report;
      report.id = robot.id;
      report.is_running = true;
      cycle.robots.push_back(report);
    }
    feed(event::Execute{});
    next_cycle();
  }
  void feed(const Event& event) {
    Advance next = advance(std::move(state), event);
    state = std::move(next.state);
    effects = std::move(next.effects);
  }
  void next_cycle() {
    cycle.time += 0.1;
    for (RobotReport& report : cycle.robots) {
      report.pose.position.y += 0.5;
      report.sequence = state.last_sequence;
      report.remaining = 9000.0 - report.pose.position.y;
    }
    feed(cycle);
  }

  State state;
  event::Cycle cycle;
  std::vector<Effect> effects;
};

TEST(QuietCycle, OrdersAUnitOfAnySizeWithOneEffect) {
  const QuietUnit unit(10'000);
  ASSERT_EQ(unit.state.step, 1U);
  int orders = 0;
  for (const Effect& effect : unit.effects) orders += std::holds_alternative<effect::Order>(effect) ? 1 : 0;
  EXPECT_EQ(orders, 1);
}

TEST(QuietCycle, TakesNoHeap) {
  QuietUnit unit(10'000);
  const Event event = unit.cycle;
  const std::size_t before = base::allocation_count();
  const Advance next = advance(std::move(unit.state), event);
  EXPECT_EQ(base::allocation_count(), before);
  EXPECT_TRUE(next.effects.empty());
}

TEST(QuietCycle, CostsInProportionToTheRobots) {
  constexpr int kFew = 1'250;
  std::map<std::size_t, QuietUnit> units;
  units.emplace(kFew, kFew);
  units.emplace(8 * kFew, 8 * kFew);
  const auto go_on = [&](std::size_t robots) {
    QuietUnit& unit = units.at(robots);
    const Event event = unit.cycle;
    for (int i = 0; i < 100; ++i) unit.state = advance(std::move(unit.state), event).state;
  };
  EXPECT_LT(base::growth(go_on, kFew), base::kGrowthOfLine);
}

}  // namespace
}  // namespace mlab::mission
