#include "mlab/ros2/type_hash.h"

#include <gtest/gtest.h>

namespace mlab::ros2 {
namespace {

// As ROS 2 publishes them: the values stand in the JSON files that its packages install.
TEST(TypeHash, IsTheOneThatRosHasForTheMessage) {
  const auto expect = [](std::string_view type, std::string_view digits) {
    EXPECT_EQ(type_hash(type), "RIHS01_" + std::string(digits)) << type;
  };
  expect("builtin_interfaces/msg/Time", "b106235e25a4c5ed35098aa0a61a3ee9c9b18d197f398b0e4206cea9acf9c197");
  expect("std_msgs/msg/Header", "f49fb3ae2cf070f793645ff749683ac6b06203e41c891e17701b1cb597ce6a01");
  expect("geometry_msgs/msg/Twist", "9c45bf16fe0983d80e3cfe750d6835843d265a9a6c46bd2e609fcddde6fb8d2a");
  expect("geometry_msgs/msg/TwistStamped",
         "5f0fcd4f81d5d06ad9b4c4c63e3ea51b82d6ae4d0558f1d475229b1121db6f64");
  expect("nav_msgs/msg/Odometry", "3cc97dc7fb7502f8714462c526d369e35b603cfc34d946e3f2eda2766dfec6e0");
  expect("sensor_msgs/msg/LaserScan", "64c191398013af96509d518dac71d5164f9382553fce5c1f8cca5be7924bd828");
  expect("std_msgs/msg/String", "df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18");
  expect("sensor_msgs/msg/BatteryState", "4bee5dfce981c98faa6828b868307a0a73f992ed0789f374ee96c8f840e69741");
  expect("geometry_msgs/msg/PoseStamped", "10f3786d7d40fd2b54367835614bff85d4ad3b5dab62bf8bca0cc232d73b4cd8");
}

TEST(TypeHash, IsKnownOfAllThatIsSpoken) {
  for (const char* const type :
       {"tf2_msgs/msg/TFMessage", "diagnostic_msgs/msg/DiagnosticArray", "action_msgs/msg/GoalStatusArray"}) {
    const auto hash = type_hash(type);
    ASSERT_TRUE(hash) << type;
    EXPECT_EQ(hash->size(), 7U + 64U);
  }
  EXPECT_FALSE(type_hash("sensor_msgs/msg/Image"));
  EXPECT_FALSE(type_hash(""));
}

TEST(TypeHash, BelongsToANameThatDdsHasOtherwise) {
  EXPECT_EQ(dds_name_of("geometry_msgs/msg/Twist"), "geometry_msgs::msg::dds_::Twist_");
  EXPECT_EQ(dds_name_of("Twist"), "");
}

}  // namespace
}  // namespace mlab::ros2
