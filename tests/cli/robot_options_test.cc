// What `mlab robot` refuses before it begins.

#include <string>

#include "command.h"

namespace mlab {
namespace {

TEST_F(Command, ARobotUnderRosIsRefusedWhereItCanNotBeReached) {
  const auto refused = [&](const std::string& options, const std::string& before = "timeout 30") {
    const Outcome o = mlab("robot --binding ros2 " + options, before);
    EXPECT_EQ(o.status, 2) << options << o.out;
    return o.err;
  };
  EXPECT_EQ(refused("--namespace veh-1"),
            "mlab robot: --namespace: the namespace `veh-1` has `veh-1` in it: words of letters, digits and "
            "single `_`, with no digit before, and `/` between them\n");
  EXPECT_EQ(refused("--scan 'front scan'").substr(0, 43), "mlab robot: --scan: the name `front scan` h");
  EXPECT_EQ(refused("", "ROS_DOMAIN_ID=ours timeout 30"),
            "mlab robot: ROS_DOMAIN_ID is `ours`: expected a number from 0 to 232\n");
  EXPECT_EQ(
      refused("--ros-peer 10.0.0.7"),
      "mlab robot: ROS's network: `10.0.0.7` can't be reached: without a network interface nothing leaves "
      "this machine\n");
  // The number that the fleet of that name has.
  EXPECT_EQ(refused("--fleet alpha --domain 50 --ros-network no-such-one"),
            "mlab robot: --domain 50: the fleet `alpha` has the same number of DDS, and is on this machine "
            "alone: another fleet's name, or --network, mends that\n");
  EXPECT_EQ(refused("--device udp:14550").substr(0, 62),
            "mlab robot: --device: --binding ros2 does not take it, but --n");
}

TEST_F(Command, OnlyARobotUnderRosHasADomain) {
  const Outcome o = mlab("robot --binding mavlink --device udp:14550 --domain 3", "timeout 30");
  EXPECT_EQ(o.status, 2) << o.out;
  EXPECT_EQ(o.err.substr(0, 56), "mlab robot: --domain: --binding mavlink does not take it");
}

}  // namespace
}  // namespace mlab
