#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "mlab/geom/pose.h"
#include "mlab/ros2/link.h"
#include "mlab/ros2/messages.h"
#include "mlab/vehicle/device.h"

namespace mlab::ros2 {

/// Velocities told as goals, for a robot that is driven by a navigator (Nav2) only: the place that a velocity
/// leads to, a little ahead, told anew whenever that has moved. Knows nothing of topics.
class Goals {
 public:
  using Time = vehicle::Clock::time_point;

  /// @param look_ahead  how far ahead a goal is at full speed [m], > 0
  /// @param max_speed   full speed [m/s], > 0
  /// @param session     of this process: other ones' goals have other ids
  Goals(double look_ahead, double max_speed, std::uint64_t session);

  /// @param pose  in `frame`
  /// @return  a goal that is to be sent now; `sent` is to be called with it
  std::optional<Goal> next(const vehicle::Command& command, const geom::Pose& pose, const std::string& frame,
                           const Stamp& stamp, Time now);
  void sent(std::int64_t request) { request_ = request; }
  void take(const Heard& heard);
  /// All goals are taken back.
  void drop();

  /// Why the navigator does not go where it is told to, as a sentence without its subject; empty: it does.
  const std::string& problem() const { return problem_; }

  /// Where a command leads: straight on, by the look-ahead at full speed, from where it has turned to in 0.4
  /// s; or, where it only turns, on the spot in 1 s.
  geom::Pose ahead(const geom::Pose& pose, const vehicle::Command& command) const;

 private:
  GoalId new_id();

  double look_ahead_;
  double max_speed_;
  std::uint64_t session_;
  std::uint64_t count_ = 0;
  std::optional<GoalId> id_;
  geom::Pose target_;
  bool has_ended_ = false;
  std::int64_t request_ = 0;
  std::optional<Time> sent_at_;
  std::string problem_;
};

}  // namespace mlab::ros2
