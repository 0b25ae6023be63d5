#include "mlab/mission/executive.h"

#include <gtest/gtest.h>

#include "mlab/mission/toy_fleet.h"

namespace mlab::mission {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace): the test's own vocabulary

// The first steps of a small scouting mission: two robots start, move, split and stop.
std::shared_ptr<const Mission> scouting() {
  MissionMaker m;
  const auto first = m.unit("scouts-1", 1);
  const auto second = m.unit("scouts-2", 1);
  const auto scouts = m.unit("scouts", {first, second});
  m.step({start(scouts, {100, 100})});
  m.step({move_to(scouts, "ATK-AP1", {200, 110})});
  m.step({move_to(first, "ATK-BP1", {300, 150}), move_to(second, "ATK-BP2", {220, 60})});
  m.step({stop(scouts)});
  return m.make();
}

TEST(Executive, CarriesOutAMissionStepByStep) {
  ToyFleet fleet(scouting());
  fleet.send(event::Execute{});
  ASSERT_TRUE(fleet.run());
  EXPECT_EQ(fleet.state().outcome, Outcome::kDone);
  EXPECT_EQ(fleet.transcript(), R"(step 0
step 0: unit scouts START StartPlace
step 0: unit scouts START StartPlace done
step 0 done
step 1
step 1: unit scouts MOVETO ATK-AP1
step 1: unit scouts MOVETO ATK-AP1 done
step 1 done
step 2
step 2: unit scouts-1 MOVETO ATK-BP1
step 2: unit scouts-2 MOVETO ATK-BP2
step 2: unit scouts-2 MOVETO ATK-BP2 done
step 2: unit scouts-1 MOVETO ATK-BP1 done
step 2 done
step 3
step 3: unit scouts STOP
step 3: unit scouts STOP done
step 3 done
mission done
)");
}

}  // namespace
}  // namespace mlab::mission
