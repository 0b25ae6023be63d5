#pragma once

#include <array>
#include <cstdint>
#include <expected>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mlab/ros2/link.h"
#include "mlab/ros2/participant.h"

namespace mlab::ros2 {

/// The action `navigate_to_pose` of a navigator (Nav2), as one asks for it over DDS.
///
/// What becomes of a goal is heard from the action's topics `status` and `feedback`, by the goal's id.
/// Replies of its services are not read: Fast DDS says beside the message whose they are, where Cyclone does
/// not look.
class ActionClient {
 public:
  /// @errors  a sentence
  static std::expected<ActionClient, std::string> begin(const RosParticipant& participant,
                                                        const std::string& robot_namespace);

  /// Takes what has come, and looks who serves.
  void hear(Heard& heard);
  Services services() const { return services_; }
  std::uint32_t servers_so_far() const { return so_far_; }

  void send(const Goal& goal);
  /// @param id  nothing: all goals
  void cancel(const std::optional<GoalId>& id);
  /// Waits until what was said last has arrived, for so long at most.
  void wait_for_acks(dds_duration_t patience) const;

  std::vector<const Endpoint*> readers() const;
  std::vector<const Endpoint*> writers() const;
  /// What was noticed since this was called last.
  std::vector<std::string> take_news();

 private:
  /// The writers of requests, of one kind of services.
  struct Asks {
    Endpoint goals, cancels;
    bool are_heard() const { return goals.readers() > 0 && cancels.readers() > 0; }
  };

  ActionClient() = default;
  void look_at_servers();
  void hear_states(Heard& heard);
  template <class Message>
  void write(const Endpoint& to, Message& message);

  Asks plain_, headed_;
  Endpoint states_, feedback_;
  std::uint64_t client_ = 0;
  std::int64_t requests_ = 0;
  std::array<int, 4> servers_{};  // of goals and of taking them back, now and ever, when they were looked at
  std::uint32_t so_far_ = 0;
  Services services_ = Services::kNone;
  /// By who told them; those of who has gone count no more.
  std::map<dds_instance_handle_t, std::vector<GoalStatus>> told_;
  std::vector<std::string> news_;
};

}  // namespace mlab::ros2
