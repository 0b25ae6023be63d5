#include "mlab/ros2/dds_link.h"

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "mlab/ros2/action_client.h"
#include "mlab/ros2/discovery.h"
#include "mlab/ros2/take_all.h"
#include "mlab/ros2/type_hash.h"
#include "mlab/ros2/wire_messages.h"

namespace mlab::ros2 {
namespace {

constexpr TopicQos kSensor{.is_reliable = false, .is_for_latecomers = false, .depth = 10};
constexpr TopicQos kTransforms{.is_reliable = false, .is_for_latecomers = false, .depth = 100};
constexpr TopicQos kStaticTransforms{.is_reliable = true, .is_for_latecomers = true, .depth = 100};
/// What was lost is sent again only while nothing newer was said: no old command comes late.
constexpr TopicQos kCommand{.is_reliable = true, .is_for_latecomers = false, .depth = 1};
constexpr TopicQos kService{.is_reliable = true, .is_for_latecomers = false, .depth = 10};
constexpr TopicQos kKept{.is_reliable = true, .is_for_latecomers = true, .depth = 1};

constexpr std::string_view kTwist = "geometry_msgs/msg/Twist";
constexpr std::string_view kTwistStamped = "geometry_msgs/msg/TwistStamped";
constexpr std::string_view kNode = "missionlab";
/// What is said last is to get out before its writer goes.
constexpr dds_duration_t kParting = DDS_MSECS(100);

template <class Sequence, class Element>
void point_at(Sequence& sequence, std::vector<Element>& elements) {
  sequence._buffer = elements.data();
  sequence._length = sequence._maximum = static_cast<std::uint32_t>(elements.size());
  sequence._release = false;
}

rmw_dds_common_msg_dds__Gid_ wire_of(const Gid& gid) {
  rmw_dds_common_msg_dds__Gid_ out{};
  std::ranges::copy(gid, std::begin(out.data));
  return out;
}

char* chars_of(std::string_view text) {
  return const_cast<char*>(text.data());
}

class DdsLink final : public Link {
 public:
  explicit DdsLink(const LinkSettings& settings)
      : settings_(settings), name_(fmt::format("domain {}", settings.network.domain)) {}
  ~DdsLink() override;

  std::expected<void, std::string> begin();

  const std::string& name() const override { return name_; }
  void hear(Heard& heard) override;
  Listeners listeners() const override;
  void say(const Velocity& velocity) override;
  void say(const State& state) override;
  void send(const Goal& goal) override;
  void cancel(const GoalId& id) override;
  void cancel_all_goals() override;
  std::vector<std::string> take_news() override;

 private:
  using Made = std::expected<Endpoint, std::string>;
  std::expected<void, std::string> begin_readers();
  bool keep(Made made, Endpoint& to);
  std::string own_topic(std::string_view name) const {
    return fmt::format("rt{}/{}", settings_.robot_namespace, name);
  }
  void add_transforms(const Endpoint& reader, bool is_static, bool is_own, Heard& heard);
  /// Makes what is needed to be heard by those who have come to listen.
  void meet_listeners();
  Made velocity_writer(const dds_topic_descriptor_t& descriptor, std::string_view type);
  void announce();

  LinkSettings settings_;
  std::string name_;
  std::string problem_;
  std::unique_ptr<RosParticipant> participant_;
  dds::Entity second_;
  std::optional<Discovery> discovery_;
  Endpoint odometry_, battery_, tf_, tf_static_, own_tf_, own_tf_static_;
  std::vector<Endpoint> scans_;
  Endpoint twist_, stamped_twist_, diagnostics_, nodes_;
  std::optional<ActionClient> navigator_;
  bool is_announced_ = false;
  std::vector<std::string> news_;
};

DdsLink::~DdsLink() {
  for (const Endpoint* const one : {&twist_, &stamped_twist_}) {
    if (*one && one->readers() > 0) dds_wait_for_acks(one->handle(), kParting);
  }
  if (navigator_) navigator_->wait_for_acks(kParting);
}

bool DdsLink::keep(Made made, Endpoint& to) {
  if (made)
    to = std::move(*made);
  else
    problem_ = made.error();
  return problem_.empty();
}

std::expected<void, std::string> DdsLink::begin() {
  auto participant = RosParticipant::open(settings_.network);
  if (!participant) return std::unexpected(participant.error());
  participant_ = std::move(*participant);
  auto discovery = Discovery::begin(*participant_, own_topic("cmd_vel"));
  if (!discovery) return std::unexpected(discovery.error());
  discovery_.emplace(std::move(*discovery));
  if (const auto begun = begin_readers(); !begun) return begun;
  if (settings_.has_goals) {
    auto navigator = ActionClient::begin(*participant_, settings_.robot_namespace);
    if (!navigator) return std::unexpected(navigator.error());
    navigator_.emplace(std::move(*navigator));
  }
  keep(participant_->writer("rt/diagnostics", diagnostic_msgs_msg_dds__DiagnosticArray__desc,
                            "diagnostic_msgs/msg/DiagnosticArray", kService),
       diagnostics_);
  return problem_.empty() ? std::expected<void, std::string>{} : std::unexpected(problem_);
}

std::expected<void, std::string> DdsLink::begin_readers() {
  const auto read = [&](const std::string& topic, const dds_topic_descriptor_t& descriptor,
                        std::string_view type, const TopicQos& qos, Endpoint& to) {
    return problem_.empty() && keep(participant_->reader(topic, descriptor, type, qos), to);
  };
  constexpr std::string_view kTf = "tf2_msgs/msg/TFMessage";
  const auto& tf = tf2_msgs_msg_dds__TFMessage__desc;
  read(own_topic("odom"), nav_msgs_msg_dds__Odometry__desc, "nav_msgs/msg/Odometry", kSensor, odometry_);
  read(own_topic("battery_state"), sensor_msgs_msg_dds__BatteryState__desc, "sensor_msgs/msg/BatteryState",
       kSensor, battery_);
  read("rt/tf", tf, kTf, kTransforms, tf_);
  read("rt/tf_static", tf, kTf, kStaticTransforms, tf_static_);
  if (!settings_.robot_namespace.empty()) {
    read(own_topic("tf"), tf, kTf, kTransforms, own_tf_);
    read(own_topic("tf_static"), tf, kTf, kStaticTransforms, own_tf_static_);
  }
  scans_.resize(settings_.scanners.size());
  for (std::size_t i = 0; i < scans_.size(); ++i) {
    read("rt" + settings_.scanners[i], sensor_msgs_msg_dds__LaserScan__desc, "sensor_msgs/msg/LaserScan",
         kSensor, scans_[i]);
  }
  return problem_.empty() ? std::expected<void, std::string>{} : std::unexpected(problem_);
}

void DdsLink::add_transforms(const Endpoint& reader, bool is_static, bool is_own, Heard& heard) {
  take_all<tf2_msgs_msg_dds__TFMessage_>(reader.handle(), [&](const auto& message, const auto&) {
    for (std::uint32_t i = 0; i < message.transforms._length; ++i) {
      Transform& one = heard.transforms.emplace_back(message_of(message.transforms._buffer[i]));
      one.is_static = is_static;
      one.is_own = is_own;
    }
  });
}

void DdsLink::hear(Heard& heard) {
  discovery_->look();
  meet_listeners();
  if (navigator_) navigator_->hear(heard);
  announce();
  add_transforms(tf_, false, false, heard);
  add_transforms(tf_static_, true, false, heard);
  add_transforms(own_tf_, false, true, heard);
  add_transforms(own_tf_static_, true, true, heard);
  take_all<nav_msgs_msg_dds__Odometry_>(odometry_.handle(), [&](const auto& message, const auto& info) {
    heard.odometry.push_back(message_of(message));
    heard.odometry.back().writer = info.publication_handle;
  });
  for (std::size_t i = 0; i < scans_.size(); ++i) {
    take_all<sensor_msgs_msg_dds__LaserScan_>(scans_[i].handle(), [&](const auto& message, const auto&) {
      heard.scans.push_back(message_of(message));
      heard.scans.back().topic = i;
    });
  }
  take_all<sensor_msgs_msg_dds__BatteryState_>(battery_.handle(), [&](const auto& message, const auto&) {
    heard.batteries.push_back(message_of(message));
  });
}

DdsLink::Made DdsLink::velocity_writer(const dds_topic_descriptor_t& descriptor, std::string_view type) {
  dds_entity_t in = 0;
  // A topic has one type within a participant.
  if (twist_ || stamped_twist_) {
    auto made = participant_->make_second();
    if (!made) return std::unexpected(made.error());
    second_ = std::move(*made);
    in = second_.handle();
  }
  return participant_->writer(own_topic("cmd_vel"), descriptor, type, kCommand, in);
}

void DdsLink::meet_listeners() {
  const auto meet = [&](Endpoint& writer, const dds_topic_descriptor_t& descriptor, std::string_view type) {
    if (writer || !discovery_->has_listener_of(dds_name_of(type))) return;
    auto made = velocity_writer(descriptor, type);
    if (!made) {
      if (news_.empty()) news_.push_back("can't be told velocities: " + made.error());
      return;
    }
    writer = std::move(*made);
    is_announced_ = false;
    news_.push_back(fmt::format("listens to {}/cmd_vel as {}", settings_.robot_namespace, type));
  };
  meet(twist_, geometry_msgs_msg_dds__Twist__desc, kTwist);
  meet(stamped_twist_, geometry_msgs_msg_dds__TwistStamped__desc, kTwistStamped);
}

// For `ros2 node list` and its like: which readers and writers are a node's.
void DdsLink::announce() {
  if (is_announced_ || !discovery_->has_type_hashes()) return;
  if (!nodes_) {
    auto made = participant_->writer("ros_discovery_info",
                                     rmw_dds_common_msg_dds__ParticipantEntitiesInfo__desc, "", kKept);
    is_announced_ = !made.has_value();
    if (!made) return;
    nodes_ = std::move(*made);
  }
  const auto gids = [](std::vector<const Endpoint*> endpoints, const std::vector<const Endpoint*>& more) {
    endpoints.insert(endpoints.end(), more.begin(), more.end());
    std::vector<rmw_dds_common_msg_dds__Gid_> out;
    for (const Endpoint* const one : endpoints) {
      if (*one) out.push_back(wire_of(one->gid));
    }
    return out;
  };
  using Endpoints = std::vector<const Endpoint*>;
  auto readers = gids({&odometry_, &battery_, &tf_, &tf_static_, &own_tf_, &own_tf_static_},
                      navigator_ ? navigator_->readers() : Endpoints{});
  for (const Endpoint& one : scans_) readers.push_back(wire_of(one.gid));
  auto writers =
      gids({&twist_, &stamped_twist_, &diagnostics_}, navigator_ ? navigator_->writers() : Endpoints{});
  const std::string in = settings_.robot_namespace.empty() ? "/" : settings_.robot_namespace;
  std::vector<rmw_dds_common_msg_dds__NodeEntitiesInfo_> nodes(1);
  nodes[0].node_namespace = chars_of(in);
  nodes[0].node_name = chars_of(kNode);
  point_at(nodes[0].reader_gid_seq, readers);
  point_at(nodes[0].writer_gid_seq, writers);
  rmw_dds_common_msg_dds__ParticipantEntitiesInfo_ message{};
  message.gid = wire_of(participant_->gid());
  point_at(message.node_entities_info_seq, nodes);
  is_announced_ = dds_write(nodes_.handle(), &message) == 0;
}

Listeners DdsLink::listeners() const {
  return {.twist = twist_ && twist_.readers() > 0,
          .twist_stamped = stamped_twist_ && stamped_twist_.readers() > 0,
          .navigator = navigator_ ? navigator_->services() : Services::kNone,
          .navigators_so_far = navigator_ ? navigator_->servers_so_far() : 0};
}

void DdsLink::say(const Velocity& velocity) {
  // What can't be written is followed by the next.
  if (twist_ && twist_.readers() > 0) {
    const auto message = twist_of(velocity);
    static_cast<void>(dds_write(twist_.handle(), &message));
  }
  if (stamped_twist_ && stamped_twist_.readers() > 0) {
    const auto message = stamped_twist_of(velocity);
    static_cast<void>(dds_write(stamped_twist_.handle(), &message));
  }
}

void DdsLink::say(const State& state) {
  std::vector<diagnostic_msgs_msg_dds__KeyValue_> values;
  for (const State::Value& one : state.values) values.push_back({chars_of(one.key), chars_of(one.value)});
  std::vector<diagnostic_msgs_msg_dds__DiagnosticStatus_> statuses(1);
  statuses[0].level = static_cast<std::uint8_t>(state.level);
  statuses[0].name = chars_of(state.name);
  statuses[0].message = chars_of(state.message);
  statuses[0].hardware_id = chars_of(state.hardware_id);
  point_at(statuses[0].values, values);
  diagnostic_msgs_msg_dds__DiagnosticArray_ message{};
  message.header.stamp = wire_of(state.stamp);
  message.header.frame_id = chars_of("");
  point_at(message.status, statuses);
  static_cast<void>(dds_write(diagnostics_.handle(), &message));
}

void DdsLink::send(const Goal& goal) {
  if (navigator_) navigator_->send(goal);
}

void DdsLink::cancel(const GoalId& id) {
  if (navigator_) navigator_->cancel(id);
}

void DdsLink::cancel_all_goals() {
  if (navigator_) navigator_->cancel({});
}

std::vector<std::string> DdsLink::take_news() {
  std::vector<std::string> out = std::exchange(news_, {});
  if (navigator_) {
    for (std::string& one : navigator_->take_news()) out.push_back(std::move(one));
  }
  for (std::string& one : participant_->complaints()) out.push_back("ROS's network: " + one);
  return out;
}

}  // namespace

std::expected<std::unique_ptr<Link>, std::string> open_link(const LinkSettings& settings) {
  auto link = std::make_unique<DdsLink>(settings);
  if (const auto begun = link->begin(); !begun) return std::unexpected(begun.error());
  return link;
}

}  // namespace mlab::ros2
