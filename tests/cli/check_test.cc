// What `mlab check` says of missions and what they name, and what `mlab import` says last.

#include <string>

#include <gtest/gtest.h>

#include "command.h"

namespace mlab {
namespace {

TEST_F(Command, CheckSaysThatANetworkNeverReports) {
  write("map.odl", kMap);
  write("mute.cnl",
        "node drift is Noise with persistence = 10; nend\nnode wheels is Drive with v = drift; nend\n");
  write("mission.mdl",
        "OVERLAY map.odl\nNEW-ROBOT m \"mute.cnl\"\nUNIT <u> m\nCOMMAND LIST:\n0. UNIT u START Here\n"
        "1. UNIT u MOVETO There\n");
  const Outcome o = mlab("check mission.mdl");
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_TRUE(has(o.err, "mission.mdl:6:9: warning: robots of the type `m` never say how far")) << o.err;
  EXPECT_TRUE(has(o.err, "[never-reports]")) << o.err;
}

TEST_F(Command, CheckAndBuildGoWithoutCellsWhereTheyAreToldTo) {
  fs::create_directory(folder_ / "project");
  write("body.h", "output = Vector{};\n");
  write("project/mine.cnl",
        "procedure Vector Still with\n  double a = 1;\nheader\nbody\n#include \"../body.h\"\npend\n"
        "node s is Still with nend\nnode wheels is Drive with v = s; nend\n");
  const Outcome walled = mlab("check project/mine.cnl");
  EXPECT_EQ(walled.status, 2) << "nothing outside of the project is read in a cell: " << walled.out;
  const Outcome free = mlab("check project/mine.cnl --no-cell");
  EXPECT_EQ(free.status, 0) << free.err;
  EXPECT_EQ(mlab("build project/mine.cnl -o still --no-cell").status, 0);
  EXPECT_TRUE(fs::exists(folder_ / "still"));
}

TEST_F(Command, TheLastLineOfAnImportTellsTheRobotsThatStand) {
  write("old.cdl",
        "bindArch AuRA;\ninstBP <1,1>|R| $R1 from vehicle( bound_to = one:SPIDER( $W ) );\n"
        "instBP $W from movement( v = RAMBLE() );\n");
  const Outcome o = mlab("import old.cdl -o new.cdl");
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_TRUE(
      o.err.ends_with("mlab import: a robot stands still, for nothing here moves it: one (no RAMBLE)\n"))
      << o.err;
  EXPECT_EQ(mlab("import --strict old.cdl -o new.cdl").status, 1);
}

}  // namespace
}  // namespace mlab
