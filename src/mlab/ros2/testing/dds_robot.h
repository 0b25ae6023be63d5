#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mlab/ros2/link.h"
#include "mlab/ros2/participant.h"

namespace mlab::ros2::testing {

/// A domain that tests of other processes use seldom.
int domain_of_this_process();
/// A namespace that they never do.
std::string namespace_of_this_process();

/// The topics of a robot, on a participant of its own, as if it were another process: whoever speaks to it
/// does so over the network of this machine.
class DdsRobot {
 public:
  enum class Listens { kNot, kTwist, kTwistStamped };
  struct Told {
    double speed = 0.0;
    double turn_rate = 0.0;
    Stamp stamp;
    std::string frame;
  };

  /// kUnknown: it is neither on Fast DDS nor says that it is rmw_cyclonedds's.
  using Navigator = Services;

  DdsRobot(Listens listens, Navigator navigator = Navigator::kNone);

  void say(const Odometry& odometry);
  void say(const LaserScan& scan);
  void say_battery(float share);
  void say_mount(const std::string& parent, const std::string& child, double x);
  /// What it was told since this was called last.
  std::vector<Told> take_told();
  /// As it came over the network, with the header that says how it is encoded; of the next message.
  std::optional<std::string> take_bytes(const Endpoint& reader);
  /// The nodes that participants list: `/veh1/missionlab`.
  std::vector<std::string> take_nodes();
  /// Goals that were asked for; and goals to be taken back, of which one of zeros means all.
  std::vector<Goal> take_goals();
  std::vector<GoalId> take_cancels();
  void say_goal_state(const GoalId& id, GoalState state);
  void say_feedback(const GoalId& id, int recoveries);

  RosParticipant& participant() { return *participant_; }
  Endpoint& velocities() { return velocities_; }

 private:
  Endpoint reader(const std::string& topic, const dds_topic_descriptor_t& descriptor, const char* type,
                  const TopicQos& qos);
  Endpoint writer(const std::string& topic, const dds_topic_descriptor_t& descriptor, const char* type,
                  const TopicQos& qos);

  Listens listens_;
  std::unique_ptr<RosParticipant> participant_;
  Endpoint velocities_, nodes_, goals_, cancels_;
  Endpoint odometry_, scan_, battery_, tf_static_, goal_states_, feedback_;
};

}  // namespace mlab::ros2::testing
