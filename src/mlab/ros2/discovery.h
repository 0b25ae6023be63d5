#pragma once

#include <expected>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mlab/ros2/participant.h"

namespace mlab::ros2 {

/// Who else is in the domain, as far as it matters.
class Discovery {
 public:
  /// @param velocity_topic  over DDS: `rt/veh1/cmd_vel`
  /// @errors  a sentence
  static std::expected<Discovery, std::string> begin(const RosParticipant& participant,
                                                     std::string velocity_topic);
  /// Takes what has been found since.
  void look();

  /// Whether somebody has listened to velocities as that type, of those there were first.
  /// @param type  over DDS: `geometry_msgs::msg::dds_::Twist_`
  bool has_listener_of(std::string_view type) const;
  /// Whether nodes are of Iron or later: endpoints tell hashes of their types. For those before, lists of
  /// nodes had another form, and one of this form ends their discovery.
  bool has_type_hashes() const { return has_type_hashes_; }

 private:
  explicit Discovery(std::string velocity_topic) : velocity_topic_(std::move(velocity_topic)) {}
  void take(const dds_builtintopic_endpoint_t& endpoint);

  std::string velocity_topic_;
  dds::Entity subscriptions_;
  Gid own_{};
  std::vector<std::string> velocity_types_;
  bool has_type_hashes_ = false;
};

}  // namespace mlab::ros2
