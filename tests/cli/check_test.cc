// What `mlab check` says of missions and what they name, and what `mlab import` says last.

#include <string>

#include <gtest/gtest.h>

#include "command.h"

namespace mlab {
namespace {

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

}  // namespace
}  // namespace mlab
