#include "mlab/console/published/machines_encoder.h"

#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/console/testing/browser.h"
#include "mlab/console/testing/run_of.h"
#include "mlab/history/testing/losing_runner.h"

namespace mlab::console {
namespace {

/// A fleet of which all is known that the test says.
class Known final : public MachineWatch {
 public:
  std::string fleet() const override { return "alpha"; }
  std::string hint() const override { return "start an agent"; }
  std::vector<WatchedMachine> look() override {
    ++looks;
    return machines;
  }

  std::vector<WatchedMachine> machines;
  int looks = 0;
};

WatchedMachine north() {
  WatchedMachine out;
  out.name = "north";
  out.host = "n\x1b[1m";
  out.link = {.round_trip = 0.002, .clock_offset = 3.0, .lost = 0.25, .is_clock_known = true};
  out.robots = 3;
  out.free_memory = 1U << 30U;
  out.version = "0.1.0";
  return out;
}

TEST(MachineBoard, WhereNoFleetCarriesRobotsThereIsNothingToTell) {
  MachineBoard board(nullptr);
  EXPECT_FALSE(board.is_there());
  EXPECT_EQ(board.look(1.0, nullptr), board.look(100.0, nullptr));
}

TEST(MachineBoard, LooksOnceASecondAndTellsWhatHasChanged) {
  const auto known = std::make_shared<Known>();
  known->machines = {north()};
  MachineBoard board(known);
  const auto first = board.look(10.0, nullptr);
  EXPECT_EQ(board.look(10.9, nullptr), first);
  EXPECT_EQ(known->looks, 1);
  EXPECT_EQ(board.look(11.1, nullptr), first) << "nothing is different";
  EXPECT_EQ(known->looks, 2);
  known->machines[0].state = WatchedMachine::State::kSilent;
  known->machines[0].heard = 1.5;
  EXPECT_NE(board.look(12.2, nullptr), first);
  ASSERT_EQ(board.told().machines_size(), 1);
  EXPECT_EQ(board.told().machines(0).state(), Machines::SILENT);
  EXPECT_EQ(board.told().machines(0).heard(), 1.5);
}

TEST(MachineBoard, TellsAllThatIsKnownOfAMachineInTextThatIsFitForPeople) {
  const auto known = std::make_shared<Known>();
  known->machines = {north(), WatchedMachine()};
  known->machines[1].vehicle = "rover";
  MachineBoard board(known);
  board.look(1.0, nullptr);
  const Machines& told = board.told();
  EXPECT_EQ(told.fleet(), "alpha");
  EXPECT_EQ(told.hint(), "start an agent");
  ASSERT_EQ(told.machines_size(), 2);
  const Machines::Machine& first = told.machines(0);
  EXPECT_EQ(first.host().find('\x1b'), std::string::npos);
  EXPECT_EQ(first.link().round_trip(), 0.002);
  EXPECT_EQ(first.link().clock_offset(), 3.0);
  EXPECT_TRUE(first.link().is_clock_known());
  EXPECT_EQ(first.carried(), 3U);
  EXPECT_EQ(first.free_memory(), 1U << 30U);
  EXPECT_FALSE(told.machines(1).has_link());
  EXPECT_EQ(told.machines(1).vehicle(), "rover");
}

TEST(MachineBoard, WhoIsThereAnewCarriesNoneOfTheRobotsThatWereLostWithWhoWasThereBefore) {
  // The two that travel are lost in their first cycle, the two that were never started are not.
  const auto run = testing::run_of(testing::kTravel, 1, [](run::RunSettings& settings) {
    settings.robots_elsewhere = [](std::uint64_t, double) {
      return std::make_unique<history::testing::LosingRunner>(
          1, history::testing::LosingRunner::Odds{.start = 0, .cycle = 1, .most = 2});
    };
  });
  ASSERT_NE(run, nullptr);
  const auto known = std::make_shared<Known>();
  known->machines = {north()};
  known->machines[0].name = "south";
  MachineBoard board(known);
  const auto carried = [&](double wall) {
    board.look(wall, run.get());
    return board.told().machines(0).robots_size();
  };
  EXPECT_EQ(carried(1.0), 4);
  run->post(mission::event::Execute{});
  testing::step(*run, 3);
  known->machines[0].state = WatchedMachine::State::kGone;
  EXPECT_EQ(carried(3.0), 4) << "it had them last";
  known->machines[0].state = WatchedMachine::State::kThere;
  EXPECT_EQ(carried(5.0), 2);
}

TEST(MachineBoard, WhoComesToTheConsoleIsToldOfTheFleetAndOfNoneWhereThereIsNone) {
  const auto known = std::make_shared<Known>();
  known->machines = {north()};
  testing::TestSession of_fleet("demo_c/demo_c.mdl", 100.0,
                                [&](SessionSettings& settings) { settings.machines = known; });
  testing::Browser anna(of_fleet, "Anna");
  EXPECT_TRUE(anna.wait([&] { return anna.machines().has_value(); }));
  ASSERT_EQ(anna.machines()->machines_size(), 1);
  EXPECT_EQ(anna.machines()->machines(0).name(), "north");
  testing::TestSession embedded("demo_c/demo_c.mdl");
  testing::Browser ben(embedded, "Ben");
  EXPECT_TRUE(ben.wait([&] { return ben.status().mode() == Status::READY; }));
  EXPECT_FALSE(ben.machines().has_value());
}

}  // namespace
}  // namespace mlab::console
