#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mlab/base/random.h"
#include "mlab/geom/pose.h"
#include "mlab/ros2/link.h"
#include "mlab/vehicle/device.h"

namespace mlab::ros2::testing {

using Time = vehicle::Clock::time_point;

/// What a robot for unit tests is like. The numbers are those of many: half a second without a command and it
/// brakes.
struct ToySpec {
  bool is_stamped = false;               ///< listens to TwistStamped, and refuses what was said too long ago
  Services navigator = Services::kNone;  ///< goes to goals; else it obeys velocities only
  double watchdog = 0.5;                 ///< [s]
  double acceleration = 2.0;             ///< [m/s^2]
  double turn_acceleration = 6.0;        ///< [rad/s^2]
  double cruise = 0.4;                   ///< of the navigator [m/s]
};

/// What lies between: messages, of which some get lost, all later by the same delay.
class ToyNetwork {
 public:
  explicit ToyNetwork(std::uint64_t seed) : random_(seed) {}
  using Delivery = std::function<void()>;
  void to_robot(Delivery delivery, Time now) { put(to_robot_, std::move(delivery), now); }
  void to_device(Delivery delivery, Time now) { put(to_device_, std::move(delivery), now); }
  void deliver_to_robot(Time now) { deliver(to_robot_, now); }
  void deliver_to_device(Time now) { deliver(to_device_, now); }
  void clear() {
    to_robot_.clear();
    to_device_.clear();
  }

  double loss = 0.0;
  vehicle::Clock::duration delay{0};
  bool is_cut = false;
  bool is_held_back = false;

 private:
  struct Message {
    Time at;
    Delivery delivery;
  };
  void put(std::deque<Message>& way, Delivery delivery, Time now);
  void deliver(std::deque<Message>& way, Time now) const;

  base::Random random_;
  std::deque<Message> to_robot_;
  std::deque<Message> to_device_;
};

/// A differential robot with a scanner, on the clock of a test.
class ToyRobot {
 public:
  ToyRobot(const ToySpec& spec, std::uint64_t seed) : network(seed), spec_(spec) {}

  const ToySpec& spec() const { return spec_; }
  /// The device's end. The robot outlives it.
  std::unique_ptr<Link> link();
  /// Moves it, and has it say what is due.
  void step(Time now, double dt);
  /// It forgets what it was told, and counts its way from where it is.
  void restart();
  Stamp stamp_of(Time now) const;
  /// As its odometry would say it.
  Odometry odometry(Time now) const;
  LaserScan scan(Time now) const;

  ToyNetwork network;
  geom::Pose pose;  ///< in the world
  double speed = 0.0;
  double turn_rate = 0.0;
  bool is_on = true;
  bool listens = true;      ///< somebody does to its cmd_vel, or serves its navigator
  bool tells_mount = true;  ///< on tf_static, each second
  bool publishes = true;    ///< all of its topics
  int velocities = 0;       ///< that it was told
  int goals = 0;            ///< that it was given
  int cancels = 0;          ///< that named a goal
  int cancels_of_all = 0;
  std::optional<Goal> goal;      ///< that it goes to
  bool takes_goals = true;       ///< else its navigator takes none
  bool finds_ways = true;        ///< else each goal is aborted at once
  int recoveries = 0;            ///< that its navigator tells of
  std::vector<State> states;     ///< what was said of us
  std::optional<Velocity> told;  ///< last
  std::function<void(Odometry&)> change_odometry = [](Odometry&) {};

  /// As though it came from one of the clients of its navigator: the newest is gone to.
  void give(const Goal& goal);
  /// Its navigator ends, and another one begins.
  void restart_navigator();

 private:
  class End;
  void obey(const Velocity& velocity);
  void cancel(const std::optional<GoalId>& id);
  void set(const GoalId& id, GoalState state);
  void tell_states();
  void navigate(double& wanted_speed, double& wanted_turn);
  void tell(Heard heard, Time now);
  void publish(Time now);

  ToySpec spec_;
  geom::Pose origin_;  // of its odometry, in the world
  Time now_;
  std::optional<Time> told_at_;
  Velocity obeyed_;
  std::vector<GoalStatus> states_of_goals_;
  std::uint32_t navigators_ = 1;
  Heard arrived_;
  int steps_ = 0;
};

}  // namespace mlab::ros2::testing
