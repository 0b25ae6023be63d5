#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mlab/ros2/messages.h"

namespace mlab::ros2 {

/// How the services of a navigator are spoken.
enum class Services : std::uint8_t {
  kNone,     ///< nobody serves goals
  kPlain,    ///< as rmw_fastrtps does: a request alone
  kHeaded,   ///< as rmw_cyclonedds does: who asks, and the number of the request, stand before it
  kUnknown,  ///< neither, or there are several who don't agree: asked in the wrong way one would take a
             ///< request for another one
};

/// Who listens to what we may say. One kind of velocity may have listeners while the other has none.
struct Listeners {
  bool twist = false;
  bool twist_stamped = false;
  Services navigator = Services::kNone;
  /// Grows when another one begins to serve goals: it knows none that were given before.
  std::uint32_t navigators_so_far = 0;
  bool any_velocity() const { return twist || twist_stamped; }
  bool can_be_given_goals() const { return navigator == Services::kPlain || navigator == Services::kHeaded; }
};

/// What the robot is told, until it is told otherwise.
struct Velocity {
  double speed = 0.0;      ///< [m/s]
  double turn_rate = 0.0;  ///< [rad/s]
  Stamp stamp;             ///< of the robot's clock, where it is known
  std::string frame;       ///< the robot's own
};

/// Where the robot is to go by itself.
struct Goal {
  GoalId id;
  Stamp stamp;
  std::string frame;
  double x = 0.0, y = 0.0;  ///< [m]
  double heading = 0.0;     ///< [rad]
};

/// How bad it is, of diagnostic_msgs/DiagnosticStatus.
enum class Level : std::uint8_t { kOk = 0, kWarning = 1, kError = 2, kStale = 3 };

/// What we say of ourselves, for people with ROS's own tools.
struct State {
  struct Value {
    std::string key;
    std::string value;
  };
  Stamp stamp;
  Level level = Level::kOk;
  std::string name;
  std::string message;
  std::string hardware_id;
  std::vector<Value> values;
};

/// What connects us with a robot's topics. All is called by one thread, nothing waits.
class Link {
 public:
  Link() = default;
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;
  virtual ~Link() = default;

  /// Where it is, for people: `domain 0`.
  virtual const std::string& name() const = 0;
  /// Adds what has come since the last call, some hundred messages at most.
  virtual void hear(Heard& heard) = 0;
  virtual Listeners listeners() const = 0;
  /// Says it to all who listen to velocities.
  virtual void say(const Velocity& velocity) = 0;
  virtual void say(const State& state) = 0;
  /// Nothing is sent where there is no navigator, or none that would understand it. What becomes of a goal
  /// is heard by its id.
  virtual void send(const Goal& goal) = 0;
  virtual void cancel(const GoalId& id) = 0;
  /// All goals of that navigator, whoever gave them.
  virtual void cancel_all_goals() = 0;
  /// What was noticed since this was called last, a line each.
  virtual std::vector<std::string> take_news() = 0;
};

}  // namespace mlab::ros2
