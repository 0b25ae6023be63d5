#include <gtest/gtest.h>

#include "mlab/base/testing/processor_time.h"

#include <utility>

#include "mlab/base/testing/count_allocations.h"
#include "mlab/mission/executive.h"
#include "mlab/mission/testing/toy_fleet.h"

namespace mlab::mission {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace): the test's own vocabulary

constexpr int kRobots = 10000;

// A unit of 10,000 robots on its way.
class QuietCycle : public ::testing::Test {
 protected:
  QuietCycle() {
    MissionMaker m;
    const auto all = m.unit("all", kRobots);
    m.step({start(all, {0, 0}, {1, 0})}).step({move_to(all, "A", {0, 9000})});
    state_ = initial_state(m.make());
    for (const RobotState& robot : state_.robots) {
      RobotReport report;
      report.id = robot.id;
      report.is_running = true;
      cycle_.robots.push_back(report);
    }
    feed(event::Execute{});
    next_cycle();
  }
  void feed(const Event& event) {
    Advance next = advance(std::move(state_), event);
    state_ = std::move(next.state);
    effects_ = std::move(next.effects);
  }
  void next_cycle() {
    cycle_.time += 0.1;
    for (RobotReport& report : cycle_.robots) {
      report.pose.position.y += 0.5;
      report.sequence = state_.last_sequence;
      report.remaining = 9000.0 - report.pose.position.y;
    }
    feed(cycle_);
  }

  State state_;
  event::Cycle cycle_;
  std::vector<Effect> effects_;
};

TEST_F(QuietCycle, OrdersAUnitOfAnySizeWithOneEffect) {
  ASSERT_EQ(state_.step, 1U);
  int orders = 0;
  for (const Effect& effect : effects_) orders += std::holds_alternative<effect::Order>(effect) ? 1 : 0;
  EXPECT_EQ(orders, 1);
}

TEST_F(QuietCycle, TakesNoHeap) {
  const Event event = cycle_;
  const std::size_t before = base::allocation_count();
  const Advance next = advance(std::move(state_), event);
  EXPECT_EQ(base::allocation_count(), before);
  EXPECT_TRUE(next.effects.empty());
}

TEST_F(QuietCycle, IsCheap) {
  const Event event = cycle_;
  constexpr int kCycles = 100;
  const double seconds = base::processor_seconds([&] {
    for (int i = 0; i < kCycles; ++i) state_ = advance(std::move(state_), event).state;
  });
  RecordProperty("microseconds_per_cycle", static_cast<int>(seconds / kCycles * 1e6));
  EXPECT_LT(seconds / kCycles, 0.001 * base::kSlowness);
}

}  // namespace
}  // namespace mlab::mission
