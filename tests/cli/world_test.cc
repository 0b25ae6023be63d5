// `mlab world`: maps for studies, and batches whose runs each have their own.

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "command.h"

namespace mlab {
namespace {

using Worlds = Command;

TEST_F(Worlds, GoToTheTerminalAndIntoAFolder) {
  const Outcome shown = mlab("world maze --seed 3");
  EXPECT_EQ(shown.status, 0) << shown.err;
  EXPECT_TRUE(shown.out.starts_with("-- mlab world maze --seed 3\n")) << shown.out.substr(0, 80);
  const Outcome written = mlab("world maze --seed 2 --count 3 --folder maps");
  EXPECT_EQ(written.status, 0) << written.err;
  EXPECT_EQ(written.out, "3 maps: maps/maze_2.odl to maps/maze_4.odl\n");
  EXPECT_EQ(text_of(folder_ / "maps/maze_3.odl"), shown.out);
  EXPECT_EQ(mlab("check maps/maze_4.odl").status, 0);
  EXPECT_EQ(mlab("world maze --seed 2 --count 3 --folder maps").status, 0) << "the same again";
}

TEST_F(Worlds, LeaveOtherFilesAlone) {
  write("rooms_2.odl", "mine");
  const Outcome out = mlab("world rooms --count 3 --folder .");
  EXPECT_EQ(out.status, 2);
  EXPECT_TRUE(has(out.err, "rooms_2.odl is there already, and is another one; nothing was written"))
      << out.err;
  EXPECT_EQ(text_of(folder_ / "rooms_2.odl"), "mine");
  EXPECT_FALSE(fs::exists(folder_ / "rooms_1.odl"));
  EXPECT_EQ(mlab("world rooms --count 2").status, 2);
  EXPECT_EQ(mlab("world hills").status, 2);
}

TEST_F(Worlds, AreOneForEachRunOfABatch) {
  ASSERT_EQ(mlab("world bows --seed 5 --count 3 --folder maps").status, 0);
  write("m.mdl",
        "MISSION NAME M\nOVERLAY maps/bows_5.odl\nUNIT <u> ROBOT\nCOMMAND LIST:\n0. UNIT u START Start\n"
        "1. UNIT u MOVETO Goal\n");
  const Outcome out = mlab(
      "batch m.mdl --seed 5 --runs 3 --set 'OVERLAY=maps/bows_{seed}.odl' --table t.csv --recordings none");
  EXPECT_EQ(out.status, 0) << out.err;
  const std::string table = text_of(folder_ / "t.csv");
  for (const char* map : {"maps/bows_5.odl", "maps/bows_6.odl", "maps/bows_7.odl"})
    EXPECT_TRUE(has(table, map)) << table;
  for (const char* seed : {"6", "7"}) {
    const std::string name = std::string("r") + seed + ".json";
    EXPECT_EQ(mlab(std::string("run m.mdl --headless --quiet --proceed --seed ") + seed +
                   " --set OVERLAY=maps/bows_" + seed + ".odl --report " + name)
                  .status,
              0);
    const std::string report = text_of(folder_ / name);
    const std::size_t at = report.find("\"simulated_s\": ");
    ASSERT_NE(at, std::string::npos);
    const std::string seconds = report.substr(at + 15, report.find_first_of(",\n", at) - at - 15);
    EXPECT_TRUE(has(table, "," + seconds + ",")) << seconds << " is not in\n" << table;
  }
  // One that isn't there is the failure of its run, with the reason.
  const Outcome more =
      mlab("batch m.mdl --seed 5 --runs 4 --set 'OVERLAY=maps/bows_{seed}.odl' --table u.csv");
  EXPECT_TRUE(has(text_of(folder_ / "u.csv"), "there is no overlay `maps/bows_8.odl`"))
      << more.out << more.err;
}

}  // namespace
}  // namespace mlab
