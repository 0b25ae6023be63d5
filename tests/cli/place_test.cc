// `mlab place`: one place in all notations.

#include <gtest/gtest.h>

#include "command.h"

namespace mlab {
namespace {

using Places = Command;

TEST_F(Places, AreToldInAllNotations) {
  write("map.odl", "ORIGIN GEO \"48.2 N 16.37 E\"\nCONTROL MEASURES:\n");
  const Outcome told = mlab("place map.odl '33N 602065.21 5340353.59'");
  EXPECT_EQ(told.status, 0) << told.err;
  EXPECT_EQ(told.out,
            "metres of the map         282.44 911.80\n"
            "degrees                   48.2082000 N 16.3738000 E\n"
            "degrees, minutes, seconds 48°12'29.5199'' N 16°22'25.6801'' E\n"
            "UTM                       33N 602065.21 5340353.59\n"
            "MGRS                      33UXP0206540353\n");
}

TEST_F(Places, AreRefusedWhereTheyAreNone) {
  write("map.odl", "ORIGIN GEO \"48.2 N 16.37 E\"\nCONTROL MEASURES:\n");
  write("plain.odl", "CONTROL MEASURES:\n");
  const Outcome nowhere = mlab("place map.odl somewhere");
  EXPECT_EQ(nowhere.status, 2);
  EXPECT_TRUE(nowhere.err.find("`somewhere` is no place on the Earth") != std::string::npos) << nowhere.err;
  const Outcome plain = mlab("place plain.odl '48.2 16.4'");
  EXPECT_EQ(plain.status, 2);
  EXPECT_TRUE(plain.err.find("does not say where it lies on the Earth") != std::string::npos) << plain.err;
  const Outcome far = mlab("place map.odl '40 N 16 E'");
  EXPECT_EQ(far.status, 2);
  EXPECT_TRUE(far.err.find("km from the map's origin") != std::string::npos) << far.err;
}

TEST_F(Places, NeedAMapInTilesThatIsOne) {
  write("map.mbtiles", "this is none\n");
  const Outcome run = mlab("run --no-browser --port 0 --tiles map.mbtiles");
  EXPECT_EQ(run.status, 2);
  EXPECT_TRUE(run.err.find("`map.mbtiles` is no map in tiles: ") != std::string::npos) << run.err;
}

}  // namespace
}  // namespace mlab
