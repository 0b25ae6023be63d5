#include "mlab/ros2/testing/dds_robot.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include <dds/ddsi/ddsi_serdata.h>

#include "mlab/ros2/take_all.h"
#include "mlab/ros2/wire_messages.h"

namespace mlab::ros2::testing {
namespace {

constexpr TopicQos kReliable{.is_reliable = true, .is_for_latecomers = false, .depth = 10};
constexpr TopicQos kLatched{.is_reliable = true, .is_for_latecomers = true, .depth = 1};

char* chars_in(const std::string& text) {
  return const_cast<char*>(text.c_str());
}

/// Types of requests are called the same, whether something stands before them or not.
dds_topic_descriptor_t called_as(const dds_topic_descriptor_t& headed, const dds_topic_descriptor_t& plain) {
  dds_topic_descriptor_t out = headed;
  out.m_typename = plain.m_typename;
  return out;
}

std_msgs_msg_dds__Header_ header_of(const Stamp& stamp, const std::string& frame) {
  return {wire_of(stamp), chars_in(frame)};
}

}  // namespace

// Below those ports that Linux hands out by itself.
int domain_of_this_process() {
  return 1 + static_cast<int>(::getpid() % 100);
}

std::string namespace_of_this_process() {
  return "/test" + std::to_string(::getpid());
}

Endpoint DdsRobot::reader(const std::string& topic, const dds_topic_descriptor_t& descriptor,
                          const char* type, const TopicQos& qos) {
  auto made = participant_->reader(topic, descriptor, type, qos);
  if (!made) throw std::runtime_error(made.error());
  return std::move(*made);
}

Endpoint DdsRobot::writer(const std::string& topic, const dds_topic_descriptor_t& descriptor,
                          const char* type, const TopicQos& qos) {
  auto made = participant_->writer(topic, descriptor, type, qos);
  if (!made) throw std::runtime_error(made.error());
  return std::move(*made);
}

DdsRobot::DdsRobot(Listens listens, Navigator navigator) : listens_(listens) {
  RosNetwork network;
  network.domain = domain_of_this_process();
  auto opened = RosParticipant::open(network);
  if (!opened) throw std::runtime_error(opened.error());
  participant_ = std::move(*opened);
  const std::string in = "rt" + namespace_of_this_process();
  if (listens == Listens::kTwist)
    velocities_ =
        reader(in + "/cmd_vel", geometry_msgs_msg_dds__Twist__desc, "geometry_msgs/msg/Twist", kReliable);
  if (listens == Listens::kTwistStamped)
    velocities_ = reader(in + "/cmd_vel", geometry_msgs_msg_dds__TwistStamped__desc,
                         "geometry_msgs/msg/TwistStamped", kReliable);
  nodes_ = reader("ros_discovery_info", rmw_dds_common_msg_dds__ParticipantEntitiesInfo__desc, "", kLatched);
  odometry_ = writer(in + "/odom", nav_msgs_msg_dds__Odometry__desc, "nav_msgs/msg/Odometry", kReliable);
  scan_ = writer(in + "/scan", sensor_msgs_msg_dds__LaserScan__desc, "sensor_msgs/msg/LaserScan", kReliable);
  battery_ = writer(in + "/battery_state", sensor_msgs_msg_dds__BatteryState__desc,
                    "sensor_msgs/msg/BatteryState", kReliable);
  tf_static_ = writer("rt/tf_static", tf2_msgs_msg_dds__TFMessage__desc, "tf2_msgs/msg/TFMessage", kLatched);
  if (navigator == Navigator::kNone) return;
  TopicQos server = kReliable;
  if (navigator == Navigator::kHeaded) server.more = "serviceid=01.02.03;";
  const std::string action = namespace_of_this_process() + "/navigate_to_pose/_action/";
  goals_ = reader(
      "rq" + action + "send_goalRequest",
      called_as(headed_SendGoal_Request__desc, nav2_msgs_action_dds__NavigateToPose_SendGoal_Request__desc),
      "", server);
  cancels_ = reader("rq" + action + "cancel_goalRequest",
                    called_as(headed_CancelGoal_Request__desc, action_msgs_srv_dds__CancelGoal_Request__desc),
                    "", server);
  goal_states_ = writer("rt" + action + "status", action_msgs_msg_dds__GoalStatusArray__desc, "", kLatched);
  feedback_ = writer("rt" + action + "feedback", nav2_msgs_action_dds__NavigateToPose_FeedbackMessage__desc,
                     "", kReliable);
}

void DdsRobot::say(const Odometry& odometry) {
  nav_msgs_msg_dds__Odometry_ message{};
  message.header = header_of(odometry.stamp, odometry.frame);
  message.child_frame_id = chars_in(odometry.child_frame);
  message.pose.pose.position = {odometry.position.x, odometry.position.y, odometry.position.z};
  const Quaternion& q = odometry.orientation;
  message.pose.pose.orientation = {q.x, q.y, q.z, q.w};
  message.twist.twist.linear.x = odometry.speed;
  message.twist.twist.angular.z = odometry.turn_rate;
  dds_write(odometry_.handle(), &message);
}

void DdsRobot::say(const LaserScan& scan) {
  sensor_msgs_msg_dds__LaserScan_ message{};
  message.header = header_of(scan.stamp, scan.frame);
  message.angle_min = scan.angle_min;
  message.angle_increment = scan.angle_increment;
  message.range_min = scan.range_min;
  message.range_max = scan.range_max;
  message.ranges._buffer = const_cast<float*>(scan.ranges.data());
  message.ranges._length = message.ranges._maximum = static_cast<std::uint32_t>(scan.ranges.size());
  dds_write(scan_.handle(), &message);
}

void DdsRobot::say_battery(float share) {
  sensor_msgs_msg_dds__BatteryState_ message{};
  const std::string none;
  message.header = header_of({}, none);
  message.location = message.serial_number = chars_in(none);
  message.percentage = share;
  message.voltage = 12.0F;
  dds_write(battery_.handle(), &message);
}

void DdsRobot::say_mount(const std::string& parent, const std::string& child, double x) {
  geometry_msgs_msg_dds__TransformStamped_ one{};
  one.header = header_of({1, 0}, parent);
  one.child_frame_id = chars_in(child);
  one.transform.translation.x = x;
  one.transform.rotation.w = 1.0;
  tf2_msgs_msg_dds__TFMessage_ message{};
  message.transforms._buffer = &one;
  message.transforms._length = message.transforms._maximum = 1;
  dds_write(tf_static_.handle(), &message);
}

std::vector<DdsRobot::Told> DdsRobot::take_told() {
  std::vector<Told> out;
  if (listens_ == Listens::kTwist)
    take_all<geometry_msgs_msg_dds__Twist_>(velocities_.handle(), [&](const auto& message, const auto&) {
      out.push_back({message.linear.x, message.angular.z, {}, {}});
    });
  if (listens_ == Listens::kTwistStamped)
    take_all<geometry_msgs_msg_dds__TwistStamped_>(
        velocities_.handle(), [&](const auto& message, const auto&) {
          out.push_back({message.twist.linear.x,
                         message.twist.angular.z,
                         {message.header.stamp.sec, message.header.stamp.nanosec},
                         message.header.frame_id});
        });
  return out;
}

std::optional<std::string> DdsRobot::take_bytes(const Endpoint& reader) {
  ddsi_serdata* data = nullptr;
  dds_sample_info_t info{};
  if (dds_takecdr(reader.handle(), &data, 1, &info, DDS_ANY_STATE) != 1) return std::nullopt;
  std::string out(ddsi_serdata_size(data), '\0');
  ddsi_serdata_to_ser(data, 0, out.size(), out.data());
  ddsi_serdata_unref(data);
  return out;
}

std::vector<std::string> DdsRobot::take_nodes() {
  std::vector<std::string> out;
  take_all<rmw_dds_common_msg_dds__ParticipantEntitiesInfo_>(
      nodes_.handle(), [&](const auto& message, const auto&) {
        for (std::uint32_t i = 0; i < message.node_entities_info_seq._length; ++i) {
          const auto& node = message.node_entities_info_seq._buffer[i];
          out.push_back(std::string(node.node_namespace) + "/" + node.node_name);
        }
      });
  return out;
}

std::vector<Goal> DdsRobot::take_goals() {
  std::vector<Goal> out;
  take_all<headed_SendGoal_Request_>(goals_.handle(), [&](const auto& message, const auto&) {
    const auto& asked = message.body.goal.pose;
    Goal& goal = out.emplace_back();
    std::ranges::copy(message.body.goal_id.uuid, std::begin(goal.id.bytes));
    goal.frame = asked.header.frame_id;
    goal.x = asked.pose.position.x;
    goal.y = asked.pose.position.y;
    goal.heading = 2.0 * std::atan2(asked.pose.orientation.z, asked.pose.orientation.w);
  });
  return out;
}

std::vector<GoalId> DdsRobot::take_cancels() {
  std::vector<GoalId> out;
  take_all<headed_CancelGoal_Request_>(cancels_.handle(), [&](const auto& message, const auto&) {
    std::ranges::copy(message.body.goal_info.goal_id.uuid, std::begin(out.emplace_back().bytes));
  });
  return out;
}

void DdsRobot::say_goal_state(const GoalId& id, GoalState state) {
  action_msgs_msg_dds__GoalStatus_ one{};
  std::ranges::copy(id.bytes, std::begin(one.goal_info.goal_id.uuid));
  one.status = static_cast<std::int8_t>(state);
  action_msgs_msg_dds__GoalStatusArray_ message{};
  message.status_list._buffer = &one;
  message.status_list._length = message.status_list._maximum = 1;
  dds_write(goal_states_.handle(), &message);
}

void DdsRobot::say_feedback(const GoalId& id, int recoveries) {
  nav2_msgs_action_dds__NavigateToPose_FeedbackMessage_ message{};
  const std::string frame = "map";
  std::ranges::copy(id.bytes, std::begin(message.goal_id.uuid));
  message.current_pose.header = header_of({}, frame);
  message.number_of_recoveries = static_cast<std::int16_t>(recoveries);
  dds_write(feedback_.handle(), &message);
}

}  // namespace mlab::ros2::testing
