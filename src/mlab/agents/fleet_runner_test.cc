#include "mlab/agents/fleet_runner.h"

#include <chrono>
#include <string>
#include <vector>

#include <unistd.h>

#include <gtest/gtest.h>

#include "mlab/robot/program/robot_program.h"

namespace mlab::agents {
namespace {

using std::chrono::seconds;

// A mission names ten machines, none of which is there.
TEST(FleetRunner, WaitsForAllThatAreMissingTogether) {
  const auto roster =
      Roster::join({.fleet = "runner-" + std::to_string(::getpid()), .interface_name = {}, .peers = {}});
  ASSERT_TRUE(roster) << roster.error();
  constexpr seconds kPatience(1);
  const auto runner = make_fleet_runner(*roster, 1, "test", 0.0, {}, kPatience);
  std::vector<robot::RobotProgram> programs(10);
  const Clock::time_point begin = Clock::now();
  for (std::uint32_t i = 0; i < programs.size(); ++i) {
    programs[i].name = "robot";
    programs[i].host = "w" + std::to_string(i);
    const auto member = runner->add({i + 1}, programs[i]);
    if (i > 0) continue;
    EXPECT_GE(Clock::now() - begin, kPatience);
    EXPECT_EQ(runner->start(member).value_or("").substr(0, 50),
              "has no agent: none of the name `w0` has joined the");
  }
  EXPECT_LT(Clock::now() - begin, 5 * kPatience) << "not one after the other";
}

}  // namespace
}  // namespace mlab::agents
