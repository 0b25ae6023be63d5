#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "mlab/geom/pose.h"
#include "mlab/ros2/link.h"
#include "mlab/ros2/messages.h"
#include "mlab/vehicle/device.h"

namespace mlab::ros2 {

/// How far ahead goals are at full speed, where nothing else is said: so far that it takes two seconds, and
/// farther than what a navigator takes for being there [m].
double look_ahead_for(double max_speed);

/// Velocities told as goals, for a robot that is driven by a navigator (Nav2) only: the place that a velocity
/// leads to, a little ahead, told anew whenever that has moved; and what is known of the navigator's goals,
/// by their ids: ours, those of a process of ours that is no more, other people's. Knows nothing of topics.
class Goals {
 public:
  using Time = vehicle::Clock::time_point;

  /// @param look_ahead  how far ahead a goal is at full speed [m], > 0
  /// @param max_speed   full speed [m/s], > 0
  /// @param session     of this process: other ones' goals have other ids
  Goals(double look_ahead, double max_speed, std::uint64_t session);

  /// @param pose  in `frame`
  /// @return  a goal that is sent now; it counts as sent
  std::optional<Goal> next(const vehicle::Command& command, const geom::Pose& pose, const std::string& frame,
                           const Stamp& stamp, Time now);
  void take(const Heard& heard, Time now);
  /// Nothing is to be gone to any more.
  void drop();
  /// The navigator is another one: it knows no goal that was given before. What was told of goals holds until
  /// something else is.
  void forget();

  /// Goals of ours, also of processes before this one, that are gone to or may be soon: of which the
  /// navigator says so, and those that were sent and not heard of yet. Some at most; the others later.
  std::vector<GoalId> to_take_back(Time now) const;
  /// The navigator goes to a goal that somebody else gave it.
  bool is_taken() const { return is_taken_; }
  bool has_any() const { return !ours_.empty() || !others_.empty(); }
  /// Others' goals that are there now may be replaced by ours.
  void engage();

  /// Why the navigator does not go where it is told to, as a sentence without its subject; empty: it does.
  std::string_view problem() const;

  /// Where a command leads: straight on, by the look-ahead at full speed, from where it has turned to in 0.4
  /// s; or, where it only turns, on the spot in 1 s.
  geom::Pose ahead(const geom::Pose& pose, const vehicle::Command& command) const;

 private:
  struct Sent {
    GoalId id;
    Time at;
  };
  enum class Problem : std::uint8_t { kNone, kNotTaken, kNoWay };

  GoalId new_id();
  void take(const std::vector<GoalStatus>& goals, Time now);
  void take_state(GoalState state, Time now);
  void note_heard_of(const GoalId& id);
  void look_for_others();

  double look_ahead_;
  double max_speed_;
  std::uint64_t session_;
  std::uint32_t count_ = 0;

  std::optional<GoalId> id_;  // that it is to go to
  geom::Pose target_;
  bool is_known_ = false;  // to the navigator
  bool has_ended_ = false;
  std::optional<Time> sent_at_;
  std::optional<Time> unanswered_since_;  // the first one that was sent since one was heard of
  std::optional<Time> goes_since_;

  std::vector<Sent> unheard_;          // of those sent lately
  std::vector<GoalId> ours_, others_;  // that the navigator says it goes to
  std::vector<GoalId> engaged_;        // of the others', those that may be replaced
  bool is_taken_ = false;
  bool is_held_up_ = false;
  Problem problem_ = Problem::kNone;
};

}  // namespace mlab::ros2
