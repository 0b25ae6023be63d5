#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "mlab/binding/body.h"
#include "mlab/binding/vehicle_state.h"
#include "mlab/fleet/fence.h"
#include "mlab/geom/pose.h"
#include "mlab/mission/failsafe.h"
#include "mlab/percept/action.h"
#include "mlab/percept/needs.h"

namespace mlab::fleet {

/// What of a robot its failsafes look at in a cycle.
struct Situation {
  std::uint16_t rows = 0xffff;           ///< those of the table that are the robot's, a bit for each
  static constexpr double kSight = 5.0;  ///< how far a robot that returns has to see [m]
  /// A battery of which nothing has been told for so long counts as empty [s]: vehicles tell of it every few
  /// seconds.
  static constexpr double kBatteryPatience = 10.0;
  Motion motion;
  geom::Point home;  ///< where it was started [m, world]
  const binding::Kinematics* kinematics = nullptr;
  double radius = 0.0;                        ///< of its body [m]
  double cruise_speed = 1.0;                  ///< with which it returns [m/s]
  bool is_in_contact = false;                 ///< its body touches something
  const binding::Passage* passage = nullptr;  ///< what is in its way before a fence; not null
  double silence = 0.0;                       ///< so long nothing has been heard of its program [s]
  double percept_age = 0.0;                   ///< so old is what its action answers [s]; 0: it is in time
  bool lacks_operator = false;                ///< it is under teleoperation, and nobody holds the stick
  std::optional<binding::Upkeep> vehicle;     ///< that is its body; nothing: its body is made up
  std::uint32_t order = 0;                    ///< number of the order that it carries out
  bool is_steered = false;                    ///< a person steers it
  /// What it senses around it; only a robot that returns has to know.
  std::span<const percept::Obstacle> obstacles;
  std::span<const percept::RobotReading> others;
};

/// What failsafes keep of a robot from one cycle to the next. Plain data: a copy is a checkpoint.
struct FailsafeState {
  static constexpr std::uint8_t kNone = 0xff;
  std::array<double, mission::kMostFailsafes> held{};  ///< by row: for how long its condition has held [s]
  std::array<bool, mission::kMostFailsafes> is_met{};  ///< by row: it has held for long enough
  std::uint8_t active = kNone;                         ///< the row whose action is carried out
  std::uint16_t waiting = 0;  ///< rows that have been met while one of higher rank acted, a bit for each
  bool has_begun = false;     ///< it was looked at
  std::uint32_t order = 0;    ///< the order that the robot had when that began
  bool has_anchor = false;
  geom::Point anchor;         ///< from where it came no half metre further
  bool makes_no_way = false;  ///< though it wants to
};

/// How a row of the table stands for a robot.
struct RowStanding {
  enum class State : std::uint8_t {
    kOthers,     ///< it is no row of this robot's
    kOff,        ///< nobody looks at it: the robot does not run, is waited for, or under no teleoperation
    kArmed,      ///< it is looked at, and far from being met
    kNear,       ///< half of what it takes, or more
    kWaiting,    ///< met while a row of higher rank acted
    kActive,     ///< what it says is done
    kOverruled,  ///< met, but the robot was given another order since, is steered, or began outside
  };
  State state = State::kOthers;
  double used = 0.0;  ///< share of what it takes, 0 .. 1
  /// For how long its condition has held [s]; of a fence, how far the body is from the line, beyond it less
  /// than 0 [m]; of a battery the share that is left, less than 0 where that is not known.
  double measure = 0.0;

  static constexpr double kNearFrom = 0.5;  ///< of `used`
  friend bool operator==(const RowStanding&, const RowStanding&) = default;
};

/// The ranked table of failsafes, below the behaviors: what a robot's program wants passes through here. A
/// row is triggered by the transition into its condition, not by its duration: who has been given another
/// order, or is steered, is not held again until the condition was over. Fences hold in any case.
class Failsafes {
 public:
  /// @param rows  the highest rank first, at most kMostFailsafes
  explicit Failsafes(std::span<const mission::Failsafe> rows = {});
  bool empty() const { return rows_.empty(); }
  const std::vector<mission::Failsafe>& rows() const { return rows_; }
  /// Whether the table has a row that can only come true then.
  bool watches(mission::FailsafeWatch when) const;

  /// The rows of a type of robots, a bit for each.
  std::uint16_t rows_of(std::string_view type) const;
  /// Whether the robot finds its way by what it senses.
  bool returns(const FailsafeState& state) const {
    return state.active < rows_.size() && rows_[state.active].action == mission::FailsafeAction::kReturn;
  }

  /// Whether the body does what a failsafe says, also where there is no program any more.
  bool drives(const FailsafeState& state) const {
    return state.active < rows_.size() &&
           (returns(state) || rows_[state.active].action == mission::FailsafeAction::kReverseInside);
  }

  /// What these rows look at, and what their actions find their way by.
  percept::Needs needs(std::uint16_t rows, const FailsafeState& state) const;
  /// What in a robot's surroundings may lead it aside before a fence is this near to it [m], whether its
  /// program drives it or a failsafe does. 0: nothing has to be known.
  double passage_reach(const Situation& situation, const percept::Action& wanted, double dt) const;

  /// How a row stands between two cycles. Of a fence all of the room before the line is used up where no more
  /// is left than the body needs to stop, and to turn back.
  ///
  /// @param action  that the robot carries out
  RowStanding standing(std::size_t row, const Situation& situation, const percept::Action& action, double dt,
                       const FailsafeState& state) const;
  /// Of a row that is OUTSIDE.
  const Fence& fence(std::size_t row) const { return fences_[row]; }

  /// What began in a cycle.
  struct Outcome {
    std::optional<std::size_t> triggered;  ///< the row that has come into force
    std::optional<std::size_t> gave_way;   ///< to it: the one that was in force, and may be again
    bool is_over = false;                  ///< the one that was in force is no longer
    std::optional<std::size_t> outside;    ///< the fence that it has begun outside of
  };
  /// One robot's cycle.
  ///
  /// @param action  as its program wants it, and then as it may be
  Outcome guard(const Situation& situation, double dt, FailsafeState& state, percept::Action& action) const;

 private:
  /// A row among those that are the robot's own.
  template <class Visit>
  void for_each_own(std::uint16_t rows, Visit&& visit) const;
  bool holds(std::size_t row, const Situation& situation, const percept::Action& wanted, double dt,
             const FailsafeState& state) const;
  bool makes_no_way(const Situation& situation, const percept::Action& wanted, FailsafeState& state) const;
  bool lacks_battery(std::size_t row, const binding::Upkeep& vehicle, const FailsafeState& state) const;
  std::uint16_t newly_met(const Situation& situation, const percept::Action& wanted, double dt,
                          FailsafeState& state) const;
  std::optional<std::size_t> begin(const Situation& situation, FailsafeState& state) const;
  void end(const Situation& situation, FailsafeState& state, Outcome& out) const;
  bool goes_on(std::size_t row) const;
  void act(const mission::Failsafe& row, const Situation& situation, percept::Action& action) const;
  void reverse(const Fence& fence, const Situation& situation, percept::Action& action) const;

  std::vector<mission::Failsafe> rows_;
  std::vector<Fence> fences_;  // by row; of those without one an empty one
};

}  // namespace mlab::fleet
