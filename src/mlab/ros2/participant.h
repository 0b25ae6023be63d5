#pragma once

#include <array>
#include <cstdint>
#include <expected>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/dds/complaints.h"
#include "mlab/dds/domain_number.h"
#include "mlab/dds/entity.h"

namespace mlab::ros2 {

/// The highest number of a domain, whose ports are below 65,536.
inline constexpr int kLastDomain = 232;

/// How robots are reached.
struct RosNetwork {
  int domain = 0;  ///< ROS_DOMAIN_ID, 0 .. kLastDomain
  /// The name of an interface of this machine, or its IPv4 address. Empty: nothing leaves this machine.
  std::string interface_name;
  /// IPv4 addresses of machines to look for robots at, where the network carries no multicast.
  std::vector<std::string> peers;
};

/// Cyclone's whole configuration; nothing is taken from the environment.
/// @errors  a sentence: a number, a name or an address that can't be used
std::expected<std::string, std::string> configuration_of(const RosNetwork& network);

/// How a topic is read or written.
struct TopicQos {
  bool is_reliable = false;
  bool is_for_latecomers = false;
  std::int32_t depth = 10;
  std::string_view more = {};  ///< of what it says of itself (USER_DATA), besides its type's hash
};

using Gid = std::array<std::uint8_t, 16>;

/// A reader of somebody else.
struct Reader {
  std::string words;  ///< what it says of itself (USER_DATA)
  Gid participant{};  ///< whose it is: the first two bytes tell who made that DDS
};

/// A reader or writer with its topic.
struct Endpoint {
  dds::Entity topic;
  dds::Entity entity;
  Gid gid{};
  explicit operator bool() const { return entity.handle() > 0; }
  dds_entity_t handle() const { return entity.handle(); }
  /// How many others are at its other end, as what it is and in a way that goes together.
  int writers() const;
  int readers() const;
  /// How many readers have ever been there; it tells that others are there though they are as many.
  int readers_so_far() const;
  /// The readers that are at its other end, some dozen at most.
  std::vector<Reader> matched_readers() const;
  /// Handles of the writers that are, likewise: those that samples come from.
  std::vector<dds_instance_handle_t> matched_writers() const;
};

/// Takes part in a domain of ROS, as a participant that Cyclone takes for one of a domain of its own: nothing
/// is shared with others of this process, whatever their numbers. Within one, a topic has one type.
class RosParticipant {
 public:
  /// @errors  a sentence, with what Cyclone has to say
  static std::expected<std::unique_ptr<RosParticipant>, std::string> open(const RosNetwork& network);

  /// Another one in the same domain.
  std::expected<dds::Entity, std::string> make_second() const;

  /// @param name  over DDS: `rt/veh1/odom`
  /// @param type  as ROS calls it, for its hash; empty: it has none
  /// @errors  a sentence
  std::expected<Endpoint, std::string> reader(const std::string& name,
                                              const dds_topic_descriptor_t& descriptor, std::string_view type,
                                              const TopicQos& qos) const;
  /// The same.
  /// @param in  the participant; 0: this one
  std::expected<Endpoint, std::string> writer(const std::string& name,
                                              const dds_topic_descriptor_t& descriptor, std::string_view type,
                                              const TopicQos& qos, dds_entity_t in = 0) const;

  dds_entity_t handle() const { return participant_.handle(); }
  Gid gid() const;
  /// What Cyclone has warned of since the last call.
  std::vector<std::string> complaints() { return complaints_.take(); }

 private:
  RosParticipant() : number_(false), complaints_(number_.value()) {}
  std::expected<void, std::string> begin(const RosNetwork& network);

  dds::DomainNumber number_;
  dds::Complaints complaints_;
  dds::Entity domain_;
  dds::Entity participant_;
};

Gid gid_of(dds_entity_t entity);
/// What an endpoint says of itself: `key=value;` as often as needed.
std::string user_data_of(const dds_qos_t* qos);

}  // namespace mlab::ros2
