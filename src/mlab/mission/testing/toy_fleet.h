#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mlab/mission/executive.h"

namespace mlab::mission::testing {

/// Writes a mission down in a test, without any file.
class MissionMaker {
 public:
  MissionMaker();
  /// Adds a flat unit of new robots. @return its index
  std::uint32_t unit(std::string name, int robots);
  /// Adds a unit of units that are there already. @return its index
  std::uint32_t unit(std::string name, std::initializer_list<std::uint32_t> parts);
  MissionMaker& step(std::vector<Command> commands);
  MissionMaker& step(std::string label, std::vector<Command> commands);
  Mission& mission() { return mission_; }
  std::shared_ptr<const Mission> make() const { return std::make_shared<const Mission>(mission_); }

 private:
  Mission mission_;
};

UnitCommand command(std::uint32_t unit, Task task, std::string place = {}, geom::Point goal = {});
UnitCommand start(std::uint32_t unit, geom::Point at = {}, geom::Offset step = {0.0, 20.0});
UnitCommand stop(std::uint32_t unit);
UnitCommand move_to(std::uint32_t unit, std::string place, geom::Point goal);
UnitCommand occupy(std::uint32_t unit, std::string place, geom::Point goal);

/// Robots as points that drive straight where their order wants them, and the executive that commands them.
/// They keep their places relative to the centre of their order's members, and are done when that centre is
/// near the goal.
class ToyFleet {
 public:
  static constexpr double kCycle = 0.1;    ///< [s]
  static constexpr double kSpeed = 5.0;    ///< [m/s]
  static constexpr double kSuccess = 1.0;  ///< [m]

  struct Body {
    RobotReport report;
    effect::Order order;
    bool in_world = false;
    bool reports = true;
    bool is_stuck = false;
    bool starts = true;           ///< a Start brings it into the world
    bool faults = false;          ///< its program fails as it starts
    geom::Offset step;            ///< last motion [m]
    std::size_t route_index = 0;  ///< FOLLOW: the point that it heads for
  };

  explicit ToyFleet(std::shared_ptr<const Mission> mission, const ExecutiveOptions& options = {});

  /// Hands the event to the executive and carries out what it wants.
  void send(const Event& event);
  void answer(std::uint32_t question, bool proceed = true);
  void cycle();
  /// Cycles until nothing runs or the time is up. @return true where nothing runs
  bool run(double seconds = 3600.0);
  void run_cycles(int count);
  /// Somebody else holds all of them: time passes, and the executive hears nothing.
  void hold(double seconds);
  /// Cycles until the predicate holds. @return false where that takes longer
  bool run_until(const std::function<bool()>& holds, double seconds = 3600.0);

  const State& state() const { return state_; }
  Body& robot(std::uint32_t id) { return bodies_.at(id); }
  std::map<std::uint32_t, Body>& robots() { return bodies_; }
  geom::Point position(std::uint32_t id) const { return bodies_.at(id).report.pose.position; }
  geom::Point centre(const std::vector<base::RobotId>& robots) const;
  double time() const { return time_; }
  bool is_paused() const { return paused_; }

  const std::vector<Effect>& last_effects() const { return last_effects_; }
  const std::map<std::uint32_t, effect::Ask>& questions() const { return questions_; }
  const std::vector<effect::Tell>& told() const { return told_; }
  /// Everything told, one text a line.
  std::string transcript() const;
  bool has_told(std::string_view text) const { return transcript().find(text) != std::string::npos; }
  template <class T>
  int count() const {
    int n = 0;
    for (const Effect& effect : all_effects_) n += std::holds_alternative<T>(effect) ? 1 : 0;
    return n;
  }
  const std::vector<Effect>& all_effects() const { return all_effects_; }

 private:
  void apply(const Effect& effect);
  void take_order(const effect::Order& order);
  void drive(Body& body) const;

  State state_;
  double time_ = 0.0;
  bool paused_ = false;
  std::map<std::uint32_t, Body> bodies_;
  std::map<std::uint32_t, effect::Ask> questions_;
  std::vector<effect::Tell> told_;
  std::vector<Effect> last_effects_;
  std::vector<Effect> all_effects_;
};

}  // namespace mlab::mission::testing
