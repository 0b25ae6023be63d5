#include "mlab/console/session/run_maker.h"

#include <cstdint>
#include <latch>
#include <memory>

#include <gtest/gtest.h>

#include "mlab/console/testing/browser.h"
#include "mlab/run/mission_run.h"

namespace mlab::console {
namespace {

using testing::Browser;
using testing::TestSession;

// As where machines of a fleet are waited for, or a compiler is.
TEST(RunMaker, SaysThatAMissionIsBeingMadeUntilItIsThere) {
  std::latch are_machines_there(1);
  TestSession session("patrol/patrol.mdl", 0.0, [&](SessionSettings& settings) {
    settings.run.robots_elsewhere = [&](std::uint64_t, double) -> std::unique_ptr<robot::ProgramRunner> {
      are_machines_there.wait();
      return nullptr;
    };
  });
  Browser anna(session, "Anna");
  EXPECT_TRUE(anna.wait([&] { return anna.status().is_being_made(); }));
  EXPECT_EQ(anna.status().mode(), Status::NO_MISSION);
  EXPECT_EQ(anna.control(Control::EXECUTE), "the mission is still being made ready");
  are_machines_there.count_down();
  EXPECT_TRUE(anna.wait([&] { return anna.status().mode() == Status::READY; }));
  EXPECT_FALSE(anna.status().is_being_made());
}

TEST(RunMaker, SaysSoAlsoWhileAnotherRunStillStands) {
  std::latch are_machines_there(1);
  int runs = 0;
  TestSession session("patrol/patrol.mdl", 0.0, [&](SessionSettings& settings) {
    settings.run.robots_elsewhere = [&](std::uint64_t, double) -> std::unique_ptr<robot::ProgramRunner> {
      if (++runs > 1) are_machines_there.wait();
      return nullptr;
    };
  });
  Browser anna(session, "Anna");
  ASSERT_TRUE(anna.wait([&] { return anna.status().mode() == Status::READY; }));
  EXPECT_EQ(anna.control(Control::RESTART), "");
  EXPECT_TRUE(anna.wait([&] { return anna.status().is_being_made(); }));
  EXPECT_EQ(anna.status().mode(), Status::READY) << "all else is of the run before";
  are_machines_there.count_down();
  EXPECT_TRUE(anna.wait([&] { return !anna.status().is_being_made(); }));
  EXPECT_EQ(anna.status().mode(), Status::READY);
}

}  // namespace
}  // namespace mlab::console
