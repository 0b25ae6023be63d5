#include <gtest/gtest.h>

#include "mlab/flow/async_runner.h"
#include "mlab/flow/testing/behaviors.h"

namespace mlab::flow {
namespace {

using namespace mlab::flow::test;

Network slow_network() {
  Network network;
  network.nodes.push_back(node("c", "Count"));
  network.nodes.push_back(node("real", "Add", {{"a", name("c")}}));
  network.nodes.push_back(node("slow", "SlowSquare", {{"x", name("real")}}));
  network.nodes.push_back(node("sink", "Show", {{"value", name("slow")}}));
  return network;
}

std::vector<std::pair<double, bool>> run_for(int cycles, AsyncRunner* async) {
  Runner run(slow_network());
  std::vector<std::pair<double, bool>> seen;
  for (int i = 0; i < cycles; ++i) {
    run.step(async);
    seen.emplace_back(run.action.velocity.x, run.number("slow.fresh") == 1.0);
  }
  return seen;
}

TEST(Asynchronous, ItsValueComesAfterItsLatencyAndIsFreshOnce) {
  const auto seen = run_for(8, nullptr);
  // Started in cycle 1 with x = 1, due in cycle 4, which starts the next with x = 4, due in cycle 7.
  const std::vector<std::pair<double, bool>> expected = {{0, false},   {0, false},    {0, false},
                                                         {1001, true}, {1001, false}, {1001, false},
                                                         {2016, true}, {2016, false}};
  EXPECT_EQ(seen, expected);
}

TEST(Asynchronous, AWorkerGivesTheSameValuesAsComputingInPlace) {
  AsyncRunner async(2);
  EXPECT_EQ(run_for(50, &async), run_for(50, nullptr));
}

TEST(Asynchronous, ARestoredCheckpointNeedsNoWorkerThatKnowsTheJob) {
  AsyncRunner first(1);
  Runner run(slow_network());
  run.step(&first);
  run.step(&first);
  const Frame checkpoint = run.frame;
  AsyncRunner second(1);  // another process, say: has never heard of the job that runs
  run.frame = checkpoint;
  run.step(&second);
  run.step(&second);
  EXPECT_DOUBLE_EQ(run.action.velocity.x, 1001.0);
}

TEST(Asynchronous, ManyRobotsShareOneRunner) {
  AsyncRunner async(2);
  text::Diagnostics sink;
  const auto program = build_program(slow_network(), library(), sink);
  std::vector<Frame> frames(50, program->make_frame());
  for (int cycle = 1; cycle <= 10; ++cycle) {
    for (std::uint32_t robot = 0; robot < frames.size(); ++robot) {
      percept::Action action;
      program->step(frames[robot].data(), {}, action, 1, robot, &async);
      if (cycle >= 7 && cycle < 10) {
        EXPECT_DOUBLE_EQ(action.velocity.x, 2016.0);
      }
    }
  }
}

}  // namespace
}  // namespace mlab::flow
