#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "mlab/base/id.h"
#include "mlab/geom/pose.h"

namespace mlab::schema {

/// Somebody or something to keep clear of, as seen from a body.
struct Traffic {
  geom::Offset place;     ///< from the body [m]
  geom::Offset velocity;  ///< [m/s]
  double reach = 0.0;     ///< that their centres must not come nearer than [m]
  double horizon = 3.0;   ///< how far ahead to look for it [s], > 0
  bool shares = false;    ///< it keeps clear as well, so each does half; else the body does all
  bool passes =
      false;  ///< it doesn't share, but moves: who can't keep clear of all gets out of its way least badly
};

/// The velocity nearest to the wanted one with which the body meets nobody within their horizons, if
/// everybody keeps clear by this rule. Where there is none: the one that breaks it least, and never for what
/// stands.
///
/// @param wanted    [m/s]
/// @param now       the body's velocity [m/s]
/// @param traffic   those that stand come first
/// @param cycle     how long until it chooses anew [s], > 0
/// @param fastest   [m/s]
/// @source  J. van den Berg, S. J. Guy, M. Lin, D. Manocha, "Reciprocal n-body collision avoidance", ISRR
/// 2009
///          (optimal reciprocal collision avoidance)
geom::Offset reciprocal_velocity(geom::Offset wanted, geom::Offset now, std::span<const Traffic> traffic,
                                 double cycle, double fastest);

/// Whether the wanted velocity is permitted by somebody so clearly that less than reciprocal_velocity looks
/// at tells it: where it is by all, and not faster than the fastest, that is what is chosen. No velocity,
/// relative to who is so far away, that is shorter than what is between the two by the time that one looks
/// ahead meets him; what the velocity now lacks of that is between it and the line which he draws.
inline bool is_clear_of(const Traffic& other, geom::Offset wanted, geom::Offset now) {
  constexpr double kRounding = 1e-6;  // [m/s]
  const double lacks = (length(other.place) - other.reach) / other.horizon - length(now - other.velocity);
  return length(wanted - now) + kRounding <= (other.shares ? 0.5 : 1.0) * lacks;
}

/// Where robots were in the cycle before, so that it can be seen how fast they are. Trivially copyable, so it
/// can be the state of a procedure.
class SeenRobots {
 public:
  /// @param about  it was the one that was added after so many others, probably
  /// @return       how fast the robot at this place is [m/s, world]; zero where it was not seen before
  geom::Offset velocity(base::RobotId robot, geom::Point place, double dt, std::size_t about = 0) const {
    if (about < count_ && seen_[about].robot == robot && dt > 0.0)
      return (place - seen_[about].place) * (1.0 / dt);
    return velocity_of(robot, place, dt);
  }
  /// What is to be known in the next cycle; those that don't fit are forgotten.
  void clear() { count_ = 0; }
  void add(base::RobotId robot, geom::Point place) {
    if (count_ < seen_.size()) seen_[count_++] = {robot, place};
  }

 private:
  geom::Offset velocity_of(base::RobotId robot, geom::Point place, double dt) const;

  struct Seen {
    base::RobotId robot;
    geom::Point place;
  };
  std::size_t count_ = 0;
  std::array<Seen, 16> seen_{};
};

}  // namespace mlab::schema
