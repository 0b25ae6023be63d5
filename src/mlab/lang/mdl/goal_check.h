#pragma once

#include <cstdint>

#include "mlab/mission/mission.h"
#include "mlab/text/diagnostic.h"

namespace mlab::mdl {

/// Warns of places that a unit is sent to and can't reach: outside the mission area, in an obstacle, in a
/// wall. The work is bounded.
class GoalCheck {
 public:
  GoalCheck(const mission::Mission& mission, text::Diagnostics& diagnostics)
      : mission_(mission), diagnostics_(diagnostics) {}

  /// @param radius  of the bodies that go there [m]
  void check(const mission::UnitCommand& command, double radius);

  bool is_outside(geom::Point p) const;
  /// The obstacle that a body with its centre there would stand in; null: none.
  const overlay::ObstacleDisc* obstacle_at(geom::Point p, double radius);
  /// The area that robots keep out of in which a place lies; null: none.
  const overlay::ControlMeasure* minefield_at(geom::Point p);

 private:
  const overlay::ControlMeasure* wall_at(geom::Point p, double radius);

  const mission::Mission& mission_;
  text::Diagnostics& diagnostics_;
  std::uint64_t visits_ = 0;
};

}  // namespace mlab::mdl
