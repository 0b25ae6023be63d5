// The command that a unit shares among its robots by area: SEARCH.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "mlab/base/testing/processor_time.h"
#include "shared_tasks.h"

namespace mlab {
namespace {

TEST_F(SharedTasks, ASearchLeavesOutTheCornerOnWhichAnotherRobotStands) {
  // Where the first lane begins, and another one ends.
  for (const char* place : {"65 65", "65 135", "135 65", "135 135"}) {
    SCOPED_TRACE(place);
    make(2, "UNIT <parked> ROBOT\n", fmt::format("SEARCH Field SWATH 10 AND UNIT parked START {}", place),
         "OBJ Field 60 60 140 60 140 140 60 140\n");
    Seen seen({60, 60}, {140, 140}, {}, 10.0);
    search(seen);
    EXPECT_TRUE(is_done()) << told_;
    EXPECT_GE(seen.share(), 0.99);
    EXPECT_LT(run_->time(), 450.0);
  }
}
TEST_F(SharedTasks, ASearchSeesAllInSharesOfEqualLength) {
  const double swath = 16.0;
  const std::vector<Seen::Rock> rocks = random_rocks(1, {60, 60}, {420, 340}, 12);
  make(4, written(rocks), fmt::format("SEARCH Field SWATH {}", swath),
       "OBJ Field 60 60 420 60 420 340 60 340\n");
  Seen seen({60, 60}, {420, 340}, rocks, swath);
  search(seen);
  EXPECT_TRUE(is_done()) << told_;
  EXPECT_EQ(contacts(), 0U);
  EXPECT_GE(seen.share(), 0.995);
  // The way there and to the next piece included.
  EXPECT_LE(driven(), 1.3 * seen.area() / swath);
  for (const fleet::FleetRobot& robot : run_->fleet().robots())
    EXPECT_LE(run_->world().body(robot.body).distance_driven, 1.25 * driven() / 4.0);
}

TEST_F(SharedTasks, LanesOfANarrowSwathAreKeptToo) {
  for (const double swath : {1.0, 2.0, 6.0}) {
    SCOPED_TRACE(fmt::format("a swath of {} m", swath));
    make(3, "", fmt::format("SEARCH Field SWATH {}", swath), "OBJ Field 100 100 140 100 140 140 100 140\n");
    Seen seen({100, 100}, {140, 140}, {}, swath, 0.25);
    search(seen);
    EXPECT_TRUE(is_done()) << told_;
    EXPECT_GE(seen.share(), 0.995);
  }
}

TEST_F(SharedTasks, WhatRocksThatNobodyKnewOfHideFromALaneIsLookedAtAfterwards) {
  for (const double swath : {10.0, 15.0}) {
    for (std::uint64_t seed = 1; seed <= (base::kIsSlowBuild ? 1U : 3U); ++seed) {
      SCOPED_TRACE(fmt::format("seed {}, a swath of {} m", seed, swath));
      const std::vector<Seen::Rock> rocks = random_rocks(seed, {80, 80}, {320, 320}, 30);
      make(4, "", fmt::format("SEARCH Field SWATH {}", swath), "OBJ Field 100 100 300 100 300 300 100 300\n",
           rocks);
      Seen seen({100, 100}, {300, 300}, rocks, swath);
      search(seen);
      EXPECT_TRUE(is_done()) << told_;
      EXPECT_EQ(contacts(), 0U);
      EXPECT_GE(seen.share(), 0.994);  // a rock on each 1,300 m^2
    }
  }
}

TEST_F(SharedTasks, WhatIsLeftUnseenOfALostRobotsPieceIsLookedAtByTheOthers) {
  const std::vector<Seen::Rock> rocks = random_rocks(4, {80, 80}, {320, 320}, 30);
  make(3, "SET FAILING-ROBOTS 1\nSET FAILURES-WITHIN 120\n", "SEARCH Field SWATH 15",
       "OBJ Field 100 100 300 100 300 300 100 300\n", rocks);
  Seen seen({100, 100}, {300, 300}, rocks, 15.0);
  search(seen);
  EXPECT_TRUE(is_done()) << told_;
  EXPECT_EQ(lost().size(), 1U);
  EXPECT_GE(seen.share(), 0.99);
}

TEST_F(SharedTasks, WhatNobodyKnewToBeOutOfReachEndsNoSearch) {
  // A ring of rocks round a part of the area: nobody sees its middle.
  std::vector<Seen::Rock> ring;
  for (int i = 0; i < 16; ++i) {
    const double angle = 2.0 * 3.14159265358979 * i / 16;
    ring.push_back({{200 + 30 * std::cos(angle), 200 + 30 * std::sin(angle)}, 8.0});
  }
  make(2, "", "SEARCH Field SWATH 10", "OBJ Field 140 140 260 140 260 260 140 260\n", ring);
  Seen seen({140, 140}, {260, 260}, ring, 10.0);
  search(seen);
  EXPECT_TRUE(is_done()) << told_;
  EXPECT_EQ(contacts(), 0U);
  EXPECT_GE(seen.share(), 0.84);  // all outside of it
  EXPECT_LT(run_->time(), 1000.0);
}

TEST_F(SharedTasks, WhatLiesUnderSomethingWideIsNotSearchedForLong) {
  // Five of eight pieces lie under a rock that nobody knew of.
  make(2, "", "SEARCH Field SWATH 20", "OBJ Field 150 100 350 100 350 200 150 200\n", {{{270, 150}, 80.0}});
  Seen seen({150, 100}, {350, 200}, {{{270, 150}, 80.0}}, 20.0);
  search(seen);
  EXPECT_TRUE(is_done()) << told_;
  EXPECT_GE(seen.share(), 0.99);
  EXPECT_NE(told_.find("leaves out part"), std::string::npos) << told_;
  EXPECT_NE(told_.find("something stands on all of it"), std::string::npos) << told_;
  EXPECT_EQ(contacts(), 0U);
}

TEST_F(SharedTasks, ASearchUnderSomethingThatLeavesNothingOfItFreeFailsSoon) {
  make(2, "", "SEARCH Field SWATH 20", "OBJ Field 150 100 250 100 250 200 150 200\n", {{{200, 150}, 85.0}});
  go(200.0);
  EXPECT_EQ(run_->state().outcome, mission::Outcome::kFailed) << told_;
  EXPECT_NE(told_.find("its robots can do no more of it"), std::string::npos) << told_;
  EXPECT_LT(run_->time(), 120.0);
}

TEST_F(SharedTasks, WhatIsBehindADoorIsSearched) {
  for (const double door : {2.0, 9.0}) {
    SCOPED_TRACE(fmt::format("a door of {} m", door));
    make(
        3, "", "SEARCH Field",
        "OBJ Field 60 60 200 60 200 180 60 180\n" +
            fmt::format("WALL low 130 0 130 {}\nWALL high 130 {} 130 400\n", 120 - door / 2, 120 + door / 2));
    Seen seen({60, 60}, {200, 180}, {}, 10.0);
    seen.add_wall({{130, 0}, {130, 120 - door / 2}});
    seen.add_wall({{130, 120 + door / 2}, {130, 400}});
    search(seen);
    EXPECT_TRUE(is_done()) << told_;
    EXPECT_EQ(told_.find("will see"), std::string::npos) << told_;
    EXPECT_EQ(contacts(), 0U);
    EXPECT_GE(seen.share(), 0.995);
  }
}

TEST_F(SharedTasks, WhatIsBehindAWallIsLookedAtFromItsOtherSide) {
  // Half a swath from the wall, lanes on its one side are near enough to what is behind it.
  make(2, "", "SEARCH Field SWATH 20", "OBJ Field 60 60 200 60 200 100 60 100\nWALL fence 66 92 194 92\n");
  Seen seen({60, 60}, {200, 100}, {}, 20.0);
  seen.add_wall({{66, 92}, {194, 92}});
  search(seen);
  EXPECT_TRUE(is_done()) << told_;
  EXPECT_EQ(contacts(), 0U);
  EXPECT_GE(seen.share(), 0.995);
}

TEST_F(SharedTasks, WhatALostRobotHadIsSearchedByTheOthers) {
  const std::vector<Seen::Rock> rocks = random_rocks(2, {60, 60}, {260, 220}, 4);
  make(3, "SET FAILING-ROBOTS 1\nSET FAILURES-WITHIN 90\n" + written(rocks), "SEARCH Field",
       "OBJ Field 60 60 260 60 260 220 60 220\n");
  Seen seen({60, 60}, {260, 220}, rocks, 10.0);
  search(seen);
  EXPECT_TRUE(is_done()) << told_;
  EXPECT_EQ(lost().size(), 1U);
  EXPECT_GE(seen.share(), 0.99);  // 5.2 m are kept from rocks, 5 m are seen
}

TEST_F(SharedTasks, ASwathWiderThanTheAreaSeesAllOfIt) {
  make(1, "", "SEARCH U SWATH 10000", "OBJ U 60 40 160 40 160 160 130 160 130 80 90 80 90 160 60 160\n");
  go(600);
  EXPECT_TRUE(is_done()) << told_;
  EXPECT_EQ(told_.find("can be searched"), std::string::npos) << told_;
}

TEST_F(SharedTasks, AnOutlineWithoutAreaIsToldAsSuch) {
  for (const char* corners : {"60 60 70 70 100 100", "60 60 60 60 60 60"}) {
    told_.clear();
    make(1, "", "SEARCH Line", fmt::format("OBJ Line {}\n", corners));
    go(600);
    EXPECT_EQ(run_->state().outcome, mission::Outcome::kFailed) << told_;
    EXPECT_NE(told_.find("Line has no area"), std::string::npos) << told_;
    EXPECT_LT(run_->time(), 20.0);
  }
}

TEST_F(SharedTasks, AnAreaThatCanNotBeSeenIsToldBeforehand) {
  make(1, "", "SEARCH Far", "OBJ Far 700 500 800 500 800 600\n");
  go(600);
  EXPECT_EQ(run_->state().outcome, mission::Outcome::kFailed) << told_;
  EXPECT_NE(told_.find("nothing of Far can be searched"), std::string::npos) << told_;
}

}  // namespace
}  // namespace mlab
