#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace mlab::ros2_robot {

/// Messages as ROS 2 has them, member by member, for this robot alone: nothing here is shared with the
/// binding that is tried with it. Metres, seconds, radians. `kType` is the name on the wire, `kHash` the
/// type's hash (RIHS01), empty where it is not told. Each struct has a `pass`, which hands its members to
/// what reads or writes them, in the order of the wire.

struct Time {
  std::int32_t sec = 0;
  std::uint32_t nanosec = 0;
};
template <class Io>
void pass(Io& io, Time& m) {
  io(m.sec, m.nanosec);
}

struct Header {
  Time stamp;
  std::string frame_id = {};
};
template <class Io>
void pass(Io& io, Header& m) {
  io(m.stamp, m.frame_id);
}

struct Vector3 {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
};
template <class Io>
void pass(Io& io, Vector3& m) {
  io(m.x, m.y, m.z);
}

struct Quaternion {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  double w = 1.0;
};
template <class Io>
void pass(Io& io, Quaternion& m) {
  io(m.x, m.y, m.z, m.w);
}

/// geometry_msgs/Pose, and geometry_msgs/Transform, whose members are the same.
struct PoseMessage {
  Vector3 position;
  Quaternion orientation;
};
template <class Io>
void pass(Io& io, PoseMessage& m) {
  io(m.position, m.orientation);
}

struct PoseStamped {
  Header header;
  PoseMessage pose;
};
template <class Io>
void pass(Io& io, PoseStamped& m) {
  io(m.header, m.pose);
}

struct Twist {
  static constexpr const char* kType = "geometry_msgs::msg::dds_::Twist_";
  static constexpr const char* kHash = "9c45bf16fe0983d80e3cfe750d6835843d265a9a6c46bd2e609fcddde6fb8d2a";
  Vector3 linear;
  Vector3 angular;
};
template <class Io>
void pass(Io& io, Twist& m) {
  io(m.linear, m.angular);
}

struct TwistStamped {
  static constexpr const char* kType = "geometry_msgs::msg::dds_::TwistStamped_";
  static constexpr const char* kHash = "5f0fcd4f81d5d06ad9b4c4c63e3ea51b82d6ae4d0558f1d475229b1121db6f64";
  Header header;
  Twist twist;
};
template <class Io>
void pass(Io& io, TwistStamped& m) {
  io(m.header, m.twist);
}

using Covariance = std::array<double, 36>;

struct Odometry {
  static constexpr const char* kType = "nav_msgs::msg::dds_::Odometry_";
  static constexpr const char* kHash = "3cc97dc7fb7502f8714462c526d369e35b603cfc34d946e3f2eda2766dfec6e0";
  Header header;
  std::string child_frame_id = {};
  PoseMessage pose;
  Covariance pose_covariance{};
  Twist twist;
  Covariance twist_covariance{};
};
template <class Io>
void pass(Io& io, Odometry& m) {
  io(m.header, m.child_frame_id, m.pose, m.pose_covariance, m.twist, m.twist_covariance);
}

struct LaserScan {
  static constexpr const char* kType = "sensor_msgs::msg::dds_::LaserScan_";
  static constexpr const char* kHash = "64c191398013af96509d518dac71d5164f9382553fce5c1f8cca5be7924bd828";
  Header header;
  float angle_min = 0.0F;
  float angle_max = 0.0F;
  float angle_increment = 0.0F;
  float time_increment = 0.0F;
  float scan_time = 0.0F;
  float range_min = 0.0F;
  float range_max = 0.0F;
  std::vector<float> ranges = {};
  std::vector<float> intensities = {};
};
template <class Io>
void pass(Io& io, LaserScan& m) {
  io(m.header, m.angle_min, m.angle_max, m.angle_increment, m.time_increment, m.scan_time, m.range_min,
     m.range_max, m.ranges, m.intensities);
}

struct BatteryState {
  static constexpr const char* kType = "sensor_msgs::msg::dds_::BatteryState_";
  static constexpr const char* kHash = "4bee5dfce981c98faa6828b868307a0a73f992ed0789f374ee96c8f840e69741";
  Header header;
  float voltage = 0.0F;
  float temperature = 0.0F;
  float current = 0.0F;
  float charge = 0.0F;
  float capacity = 0.0F;
  float design_capacity = 0.0F;
  float percentage = 0.0F;  ///< 0 .. 1, whatever its name says
  std::uint8_t power_supply_status = 0;
  std::uint8_t power_supply_health = 0;
  std::uint8_t power_supply_technology = 0;
  bool present = false;
  std::vector<float> cell_voltage = {};
  std::vector<float> cell_temperature = {};
  std::string location = {};
  std::string serial_number = {};
};
template <class Io>
void pass(Io& io, BatteryState& m) {
  io(m.header, m.voltage, m.temperature, m.current, m.charge, m.capacity, m.design_capacity, m.percentage,
     m.power_supply_status, m.power_supply_health, m.power_supply_technology, m.present, m.cell_voltage,
     m.cell_temperature, m.location, m.serial_number);
}

struct TransformStamped {
  Header header;
  std::string child_frame_id = {};
  PoseMessage transform;
};
template <class Io>
void pass(Io& io, TransformStamped& m) {
  io(m.header, m.child_frame_id, m.transform);
}

struct Transforms {
  static constexpr const char* kType = "tf2_msgs::msg::dds_::TFMessage_";
  static constexpr const char* kHash = "";
  std::vector<TransformStamped> transforms = {};
};
template <class Io>
void pass(Io& io, Transforms& m) {
  io(m.transforms);
}

/// Of an endpoint, or of a participant.
using Gid = std::array<std::uint8_t, 16>;
struct GidMessage {
  Gid data{};
};
template <class Io>
void pass(Io& io, GidMessage& m) {
  io(m.data);
}

struct NodeEntities {
  std::string node_namespace = {};
  std::string node_name = {};
  std::vector<GidMessage> readers = {};
  std::vector<GidMessage> writers = {};
};
template <class Io>
void pass(Io& io, NodeEntities& m) {
  io(m.node_namespace, m.node_name, m.readers, m.writers);
}

/// What `ros2 node list` is told by.
struct ParticipantEntities {
  static constexpr const char* kType = "rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_";
  static constexpr const char* kHash = "";
  GidMessage gid;
  std::vector<NodeEntities> nodes = {};
};
template <class Io>
void pass(Io& io, ParticipantEntities& m) {
  io(m.gid, m.nodes);
}

}  // namespace mlab::ros2_robot
