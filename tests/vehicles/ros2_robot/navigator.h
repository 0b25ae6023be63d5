#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "action_messages.h"
#include "mlab/geom/pose.h"
#include "robot.h"

namespace mlab::ros2_robot {

/// As action_msgs/GoalStatus numbers them.
enum class GoalState : std::int8_t {
  kUnknown = 0,
  kAccepted = 1,
  kExecuting = 2,
  kCanceling = 3,
  kSucceeded = 4,
  kCanceled = 5,
  kAborted = 6,
};
constexpr bool is_over(GoalState state) {
  return state >= GoalState::kSucceeded;
}

struct Goal {
  GoalId id{};
  geom::Pose target;  ///< in the frame of its odometry
  Time accepted;      ///< as it is told to others
  GoalState state = GoalState::kExecuting;
  double began = 0.0;  ///< of the robot's time [s]
  /// When it last came nearer, and how near that was [s; m and rad added].
  double came_nearer = 0.0;
  double nearest = 1e9;
};

/// What becomes of an asked cancellation, as action_msgs/CancelGoal numbers it.
enum class CancelCode : std::int8_t { kDone = 0, kRejected = 1, kUnknownGoal = 2, kIsOver = 3 };

/// Goals of Nav2's NavigateToPose, without their way over the network: turns towards the goal, goes there,
/// turns as it is to stand. It knows no obstacles; where it does not get on for ten seconds it gives up.
class Navigator {
 public:
  /// Whoever comes last is driven for; the goal before is aborted, as Nav2 does it.
  /// @return  false: there is a goal of this id already
  bool accept(const Goal& goal);
  /// @param asked  an id of zeros: all that were accepted until its stamp, or all where that is 0, too
  /// @param told   those that are being canceled
  CancelCode cancel(const GoalInfo& asked, std::vector<GoalInfo>& told);
  /// Gives up the newest goal.
  void abort();
  /// @return  what the robot is to do; nothing: it has no goal
  std::optional<Speeds> step(const geom::Pose& pose, double now);

  /// The oldest first; those that are over are kept, as many as `kKept`.
  const std::vector<Goal>& goals() const { return goals_; }
  const Goal* find(const GoalId& id) const;
  const Goal* current() const;
  /// Grows with each change of a goal's state.
  std::uint64_t changes() const { return changes_; }

 private:
  static constexpr std::size_t kKept = 16;
  void set(Goal& goal, GoalState state);

  std::vector<Goal> goals_;
  std::uint64_t changes_ = 0;
};

/// What a robot does to come there: turn, then go, then turn as it is to stand.
/// @return  nothing: it is there
std::optional<Speeds> towards(const geom::Pose& pose, const geom::Pose& target);

}  // namespace mlab::ros2_robot
