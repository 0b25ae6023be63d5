// Three robots in one formation: a ROS 2 robot and a MAVLink rover, both played by implementations that are
// not ours, and one that is simulated. Headless; tests/browser/vehicle_patrol.test.ts does it from the
// console.

#include "vehicle_peers.h"

namespace mlab::testing {
namespace {

using network::Process;

/// From where START puts it, in the frame that the peer tells its place in [m].
double driven(VehiclePeer& peer, const VehiclePeer::Moment& began) {
  const VehiclePeer::Moment now = peer.now();
  return std::hypot(now.x - began.x, now.y - began.y);
}

class VehiclePatrol : public Fleets {
 protected:
  void SetUp() override {
    Fleets::SetUp();
    MLAB_NEEDS_PEERS();
  }
};

TEST_F(VehiclePatrol, OfARos2RobotAMavlinkRoverAndASimulatedRobotIsDoneRecordedAndReplayed) {
  make_network(76);
  const std::string folder = base::source_folder() + "/tests/fleets/vehicles/";
  const auto scout = start_ros2_robot(net().host("north"), folder + "yard.odl", "8,19,0");
  const auto rover = start_mavlink_rover(net().host("south"));
  const Process scout_robot = start_robot(net().host("north"), "veh-1", *scout);
  const Process rover_robot = start_robot(net().host("south"), "veh-2", *rover);
  const Process agent = this->agent("south");
  ASSERT_TRUE(scout->is_known_to(scout_robot)) << scout_robot.output();
  ASSERT_TRUE(rover->is_known_to(rover_robot)) << rover_robot.output();
  const VehiclePeer::Moment scout_began = scout->now();
  const VehiclePeer::Moment rover_began = rover->now();

  std::vector<std::string> options = kMovingVehicles;
  options.insert(options.end(), {"--record", "/tmp/patrol.mcap"});
  Process far = run(folder + "patrol.mdl", options);
  ASSERT_TRUE(far.prints("step 1: unit watch MOVETO Shed (Line) done", kFleetPatience))
      << far.output() << far.errors() << scout_robot.output() << rover_robot.output();
  // What the mission says of them is what they did.
  EXPECT_GT(driven(*scout, scout_began), 2.5);
  EXPECT_GT(driven(*rover, rover_began), 2.5);
  const auto ending = far.wait(kFleetPatience);
  ASSERT_TRUE(ending) << far.output();
  EXPECT_EQ(ending->words(), "exit status 0") << far.output() << far.errors();
  const Json told = report();
  EXPECT_EQ(told["outcome"], "done");
  for (const Json& robot : told["robots"]) {
    EXPECT_GT(robot["distance_m"].get<double>(), 4.0) << robot;
    EXPECT_EQ(robot["collisions"], 0) << robot;
  }
  EXPECT_LT(told["units"][0]["formation_error"]["mean_m"].get<double>(), 1.5) << told["units"];
  EXPECT_TRUE(scout_robot.prints("no run drives it any more", kFleetPatience)) << scout_robot.output();
  EXPECT_TRUE(rover_robot.prints("no run drives it any more", kFleetPatience)) << rover_robot.output();
  EXPECT_LT(driven(*scout, scout_began), 2.5);
  EXPECT_LT(driven(*rover, rover_began), 2.5);

  Process again = base().start({MLAB_COMMAND, "replay", "/tmp/patrol.mcap", "--headless"});
  const auto replayed = again.wait(kFleetPatience);
  ASSERT_TRUE(replayed) << again.output();
  EXPECT_EQ(replayed->words(), "exit status 0") << again.output() << again.errors();
}

}  // namespace
}  // namespace mlab::testing
