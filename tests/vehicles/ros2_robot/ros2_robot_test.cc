// The ROS 2 robot of the tests, as Cyclone DDS sees it: what it says arrives, and it obeys and stands as
// stated.

#include <signal.h>

#include <cmath>
#include <cstring>
#include <map>

#include <gtest/gtest.h>

#include "cyclone_side.h"
#include "mlab/base/testing/source_folder.h"
#include "robot_process.h"

namespace mlab::ros2_robot {
namespace {

using TwistSample = geometry_msgs_msg_dds__Twist_;
using OdometrySample = nav_msgs_msg_dds__Odometry_;
using ScanSample = sensor_msgs_msg_dds__LaserScan_;
using BatterySample = sensor_msgs_msg_dds__BatteryState_;
using TransformsSample = tf2_msgs_msg_dds__TFMessage_;
using EntitiesSample = rmw_dds_common_msg_dds__ParticipantEntitiesInfo_;

/// Its time runs so many times as fast as the machine's.
constexpr double kSpeedUp = 4.0;
/// A step of its time, and its last digit [s].
constexpr double kStep = 0.012;
/// Of a machine that has other work, in the robot's time [s].
constexpr double kLate = 2.0;
constexpr double kPatience = 0.5;  // of the robot's, as it states [s]
constexpr double kBraking = 2.0;   // [m/s^2]

class Ros2Robot : public ::testing::Test {
 protected:
  std::vector<std::string> options(const std::vector<std::string>& more) const {
    std::vector<std::string> out = {"--domain",    std::to_string(domain_),
                                    "--namespace", "/veh1",
                                    "--speed-up",  std::to_string(kSpeedUp),
                                    "--drift",     "0",
                                    "--seconds",   "300"};
    out.insert(out.end(), more.begin(), more.end());
    return out;
  }
  /// Writes until the robot goes as fast, then leaves it alone.
  void drive(RobotProcess& robot, dds_entity_t writer, const void* command) {
    ASSERT_TRUE(becomes([&] { return has_partner(writer); }));
    ASSERT_TRUE(
        becomes([&] { return robot.last(" 0.500 at ").has_value(); }, [&] { dds_write(writer, command); }))
        << robot.said();
    left_at_ = robot.last(" 0.500 at ").value_or(0.0);
  }
  void stands_as_stated(RobotProcess& robot) {
    ASSERT_TRUE(becomes([&] { return robot.last("stands at ").value_or(0.0) > left_at_; })) << robot.said();
    const double heard = robot.last("nobody has told it anything since ").value_or(0.0);
    const double braked = robot.last("brakes at ").value_or(0.0);
    const double stood = robot.last("stands at ").value_or(0.0);
    EXPECT_NEAR(heard, left_at_, kLate) << robot.said();
    EXPECT_NEAR(braked - heard, kPatience, kStep) << robot.said();
    EXPECT_NEAR(stood - braked, 0.5 / kBraking, kStep) << robot.said();
  }

  int domain_ = free_domain();
  CycloneSide cyclone_{domain_};
  double left_at_ = 0.0;  // the robot's time when it was left alone [s]
};

TEST_F(Ros2Robot, ObeysTwistsAndStandsHalfASecondAfterTheLastOne) {
  RobotProcess robot(options({"--log", "--at", "1,2,90"}));
  const dds_entity_t commands = cyclone_.writer(geometry_msgs_msg_dds__Twist__desc, "rt/veh1/cmd_vel");
  const dds_entity_t places = cyclone_.reader(nav_msgs_msg_dds__Odometry__desc, "rt/veh1/odom");
  TwistSample ahead{};
  ahead.linear.x = 0.5;
  drive(robot, commands, &ahead);
  stands_as_stated(robot);
  // It counts from where it was switched on, whatever way that was.
  double counted = 0.0;
  ASSERT_TRUE(becomes([&] {
    bool stands = false;
    take<OdometrySample>(places, [&](const OdometrySample& one) {
      EXPECT_STREQ(one.header.frame_id, "odom");
      EXPECT_STREQ(one.child_frame_id, "base_link");
      EXPECT_EQ(one.pose.covariance[35], 0.01);
      EXPECT_NEAR(one.pose.pose.position.y, 0.0, 1e-6);
      EXPECT_NEAR(one.pose.pose.orientation.w, 1.0, 1e-6);
      counted = one.pose.pose.position.x;
      stands = counted > 0.1 && one.twist.twist.linear.x == 0.0;
    });
    return stands;
  })) << robot.said();
  EXPECT_NEAR(robot.last("\nat 1.000 ").value_or(0.0), 2.0 + counted, 2e-3) << robot.said();
  EXPECT_EQ(robot.end(SIGTERM), 0);
}

TEST_F(Ros2Robot, ObeysTwistsWithAStampButNeitherOldOnesNorWhatIsNoNumber) {
  RobotProcess robot(options({"--log", "--stamped"}));
  const dds_entity_t commands = cyclone_.writer(geometry_msgs_msg_dds__TwistStamped__desc, "rt/veh1/cmd_vel");
  geometry_msgs_msg_dds__TwistStamped_ told{};
  std::string frame = "base_link";
  told.header.frame_id = frame.data();
  told.twist.angular.z = std::nan("");
  ASSERT_TRUE(becomes([&] { return has_partner(commands); }));
  dds_write(commands, &told);
  told.twist.linear.x = 0.5;
  dds_write(commands, &told);
  told.twist.angular.z = 0.0;
  told.header.stamp.sec = 1;
  dds_write(commands, &told);
  ASSERT_TRUE(becomes([&] { return robot.has_said("a command is too old"); })) << robot.said();
  EXPECT_FALSE(robot.has_said("goes at")) << robot.said();
  told.header.stamp.sec = 0;
  drive(robot, commands, &told);
  EXPECT_FALSE(robot.has_said("nan")) << robot.said();
  stands_as_stated(robot);
}

TEST_F(Ros2Robot, TellsWhatItSeesAndIs) {
  const std::string yard = base::source_folder() + "/tests/fleets/vehicles/yard.odl";
  const RobotProcess robot(options({"--world", yard, "--at", "10,11,0", "--range-noise", "0"}));
  const dds_entity_t scans = cyclone_.reader(sensor_msgs_msg_dds__LaserScan__desc, "rt/veh1/scan");
  const dds_entity_t batteries =
      cyclone_.reader(sensor_msgs_msg_dds__BatteryState__desc, "rt/veh1/battery_state");
  const dds_entity_t mounts = cyclone_.reader(tf2_msgs_msg_dds__TFMessage__desc, "rt/tf_static", true);
  const dds_entity_t moving = cyclone_.reader(tf2_msgs_msg_dds__TFMessage__desc, "rt/tf");
  const dds_entity_t nodes =
      cyclone_.reader(rmw_dds_common_msg_dds__ParticipantEntitiesInfo__desc, "ros_discovery_info", true);
  std::map<std::string, int> told;
  const auto has_all = [&] {
    told["scan"] += take<ScanSample>(scans, [](const ScanSample& one) {
      EXPECT_STREQ(one.header.frame_id, "laser");
      ASSERT_EQ(one.ranges._length, 360U);
      EXPECT_FLOAT_EQ(one.angle_min, -static_cast<float>(M_PI));
      // A rock of 0.8 m stands 4 m ahead of it, its scanner is 0.1 m ahead; behind it there is nothing.
      EXPECT_NEAR(one.ranges._buffer[180], 4.0 - 0.1 - 0.8, 1e-3);
      EXPECT_EQ(one.ranges._buffer[0], std::numeric_limits<float>::infinity());
      EXPECT_FLOAT_EQ(one.range_max, 10.0F);
    });
    told["battery"] += take<BatterySample>(batteries, [](const BatterySample& one) {
      EXPECT_NEAR(one.percentage, 0.9F, 0.01F);
      EXPECT_TRUE(one.present);
    });
    told["mount"] += take<TransformsSample>(mounts, [](const TransformsSample& one) {
      ASSERT_EQ(one.transforms._length, 1U);
      EXPECT_STREQ(one.transforms._buffer[0].child_frame_id, "laser");
      EXPECT_EQ(one.transforms._buffer[0].transform.position.x, 0.1);
    });
    told["tf"] += take<TransformsSample>(moving, [](const TransformsSample& one) {
      ASSERT_EQ(one.transforms._length, 1U);
      EXPECT_STREQ(one.transforms._buffer[0].header.frame_id, "odom");
      EXPECT_STREQ(one.transforms._buffer[0].child_frame_id, "base_link");
    });
    told["node"] += take<EntitiesSample>(nodes, [](const EntitiesSample& one) {
      ASSERT_EQ(one.node_entities_info_seq._length, 1U);
      const auto& node = one.node_entities_info_seq._buffer[0];
      EXPECT_STREQ(node.node_namespace, "/veh1");
      EXPECT_STREQ(node.node_name, "mlab_ros2_robot");
      EXPECT_EQ(node.reader_gid_seq._length, 1U);
      EXPECT_EQ(node.writer_gid_seq._length, 5U);
      // Its endpoints are the participant's own.
      EXPECT_EQ(std::memcmp(node.reader_gid_seq._buffer[0].data, one.gid.data, 12), 0);
    });
    return told["scan"] > 0 && told["battery"] > 0 && told["mount"] > 0 && told["tf"] > 0 && told["node"] > 0;
  };
  EXPECT_TRUE(becomes(has_all)) << told["scan"] << told["battery"] << told["mount"] << told["tf"]
                                << told["node"];
}

std::string user_data(const dds_qos_t* qos) {
  void* value = nullptr;
  std::size_t size = 0;
  dds_qget_userdata(qos, &value, &size);
  std::string out(static_cast<const char*>(value), size);
  dds_free(value);
  return out;
}

TEST_F(Ros2Robot, TellsTheHashesOfItsTypesToWhoeverDiscoversIt) {
  const RobotProcess robot(options({}));
  const dds_entity_t endpoints =
      dds_create_reader(cyclone_.participant(), DDS_BUILTIN_TOPIC_DCPSPUBLICATION, nullptr, nullptr);
  const dds_entity_t participants =
      dds_create_reader(cyclone_.participant(), DDS_BUILTIN_TOPIC_DCPSPARTICIPANT, nullptr, nullptr);
  std::map<std::string, std::string> told;
  const bool comes = becomes([&] {
    take<dds_builtintopic_endpoint_t>(endpoints, [&](const dds_builtintopic_endpoint_t& one) {
      told[one.topic_name] = std::string(one.type_name) + " " + user_data(one.qos);
    });
    take<dds_builtintopic_participant_t>(participants, [&](const dds_builtintopic_participant_t& one) {
      if (const std::string data = user_data(one.qos); !data.empty()) told["participant"] = data;
    });
    return told.contains("rt/veh1/odom") && told.contains("rt/veh1/scan") && told.contains("participant");
  });
  ASSERT_TRUE(comes);
  EXPECT_EQ(told["rt/veh1/odom"],
            "nav_msgs::msg::dds_::Odometry_ "
            "typehash=RIHS01_3cc97dc7fb7502f8714462c526d369e35b603cfc34d946e3f2eda2766dfec6e0;");
  EXPECT_EQ(told["rt/veh1/scan"],
            "sensor_msgs::msg::dds_::LaserScan_ "
            "typehash=RIHS01_64c191398013af96509d518dac71d5164f9382553fce5c1f8cca5be7924bd828;");
  EXPECT_EQ(told["participant"], std::string("enclave=/;") + '\0');
}

TEST_F(Ros2Robot, SaysByItsExitWhatWasWrong) {
  EXPECT_EQ(RobotProcess({"--help"}).end(0), 0);
  EXPECT_EQ(RobotProcess({"--namespace", "veh1"}).end(0), 2);
  EXPECT_EQ(RobotProcess({"--at", "1,2"}).end(0), 2);
  EXPECT_EQ(RobotProcess({"--beams", "7"}).end(0), 2);
  EXPECT_EQ(RobotProcess({"--world", "/nowhere.odl"}).end(0), 2);
}

}  // namespace
}  // namespace mlab::ros2_robot
