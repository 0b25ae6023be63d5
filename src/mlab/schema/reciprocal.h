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

/// Where robots were in the cycle before, so that it can be seen how fast they are. Trivially copyable, so it
/// can be the state of a procedure.
class SeenRobots {
 public:
  /// @param about  it was the one that was added after so many others, probably
  /// @return       how fast the robot at this place is [m/s, world]; zero where it was not seen before
  geom::Offset velocity(base::RobotId robot, geom::Point place, double dt, std::size_t about = 0) const;
  /// What is to be known in the next cycle; those that don't fit are forgotten.
  void clear() { count_ = 0; }
  void add(base::RobotId robot, geom::Point place);

 private:
  struct Seen {
    base::RobotId robot;
    geom::Point place;
  };
  std::size_t count_ = 0;
  std::array<Seen, 16> seen_{};
};

}  // namespace mlab::schema
