#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mlab/ros2/goals.h"
#include "mlab/ros2/link.h"
#include "mlab/ros2/readings.h"
#include "mlab/vehicle/device.h"

namespace mlab::ros2 {

/// Those of a robot of which nothing else is said: half a metre a second, never backwards.
vehicle::Limits robot_limits();

/// What can be promised of a robot that goes to its last goal by itself: twice as long as full speed takes
/// for the look-ahead, and three seconds for its navigator to turn there and to end. One that is slower than
/// half of that, or is held up on the way, takes longer.
double standstill_with_goals(double look_ahead, double max_speed);

/// How a robot is told where to go.
enum class Drives : std::uint8_t {
  kVelocities,  ///< on `cmd_vel`
  kGoals,       ///< by the action `navigate_to_pose`
};

/// What is to be said of a robot that it does not say itself.
struct RobotSettings {
  /// Its own. `standstill` is what is promised of its own watchdog, see docs/ros2.md.
  vehicle::Limits limits = robot_limits();
  std::string robot_namespace;                   ///< `/veh1`; empty: it has none
  std::vector<std::string> scanners = {"scan"};  ///< what they are called, at most kMostScanners
  Places places;
  Drives drives = Drives::kVelocities;
  std::optional<double> look_ahead = {};  ///< of goals, at full speed [m], > 0; nothing: look_ahead_for
  std::uint64_t session = 1;              ///< of this process: goals of others have other ids
};

/// A robot under ROS 2. It is ready once it says where it is and somebody listens to what it is to be told;
/// docs/ros2.md says what stops it, and how soon.
class Ros2Device final : public vehicle::Device {
 public:
  using Time = vehicle::Clock::time_point;

  Ros2Device(std::unique_ptr<Link> link, const RobotSettings& settings);
  ~Ros2Device() override;

  const std::string& name() const override { return name_; }
  const vehicle::Limits& limits() const override { return settings_.limits; }
  void work(Time now) override;
  const vehicle::Report& report(Time now) override;
  void drive(const vehicle::Command& command, Time now) override;
  void stop(Time now) override;
  /// With goals, those of others are taken back, too.
  void stop_in_emergency(Time now) override;
  void engage(Time now) override;
  std::vector<std::string> take_news() override;
  std::vector<vehicle::Check> checks(Time now) override;

 private:
  enum class Doing : std::uint8_t {
    kNothing,  ///< nothing is said: somebody else may drive it
    kDriving,
    kHalting,  ///< it is told to stand, until it is seen to
  };

  bool is_ready(Time now) const { return why_not(now).empty(); }
  std::string why_not(Time now) const;
  vehicle::Check listener_check() const;
  vehicle::Check navigator_check() const;
  vehicle::Check watchdog_check() const;
  bool has_goals() const { return settings_.drives == Drives::kGoals; }
  std::string why_no_navigator() const;
  /// Of others who drive it by its navigator.
  bool is_taken() const { return has_goals() && goals_.is_taken(); }
  void hear(Time now);
  void take_goals_back(Time now);
  bool has_halted() const;
  void halt(Time now);
  void say_halt(Time now);
  void tell(const vehicle::Command& command, Time now);
  void tell_by_goal(const vehicle::Command& command, Time now);
  void say_velocity(const vehicle::Command& command, Time now);
  void say_state(Time now);

  RobotSettings settings_;
  std::unique_ptr<Link> link_;
  std::string name_;
  Readings readings_;
  Goals goals_;
  Heard heard_;
  Doing doing_ = Doing::kNothing;
  Time driven_at_;
  Time halted_at_;
  std::optional<Time> told_at_;
  std::optional<Time> taken_back_at_;
  bool is_emergency_ = false;
  std::uint32_t navigators_ = 0;  // that there were so far
  vehicle::Command told_;
  std::optional<Time> state_at_;
  std::string told_state_;
  std::string told_problem_;
  vehicle::Report report_;
  Time now_;
};

}  // namespace mlab::ros2
