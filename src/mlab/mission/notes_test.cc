#include "mlab/mission/notes.h"

#include <gtest/gtest.h>

namespace mlab::mission {
namespace {

TEST(Notes, TellThatARobotTypeRunsHereWhateverItsHost) {
  Mission mission;
  mission.types.resize(2);
  mission.types[0].name = "ROBOT";
  EXPECT_TRUE(notes_of(mission).empty());
  mission.types[1].name = "far";
  mission.types[1].host = "shaft.example.org";
  ASSERT_EQ(notes_of(mission).size(), 1U);
  EXPECT_EQ(notes_of(mission)[0],
            "note: robots of the type `far` run on this machine, not on `shaft.example.org`: hosts have no "
            "meaning yet");
}

}  // namespace
}  // namespace mlab::mission
