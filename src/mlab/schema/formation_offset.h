#pragma once

#include "mlab/geom/pose.h"
#include "mlab/geom/vector.h"
#include "mlab/percept/formation.h"
#include "mlab/percept/percepts.h"

namespace mlab::schema {

/// The way from a robot to its station in the formation of its unit [m, robot frame].
///
/// Measured from the unit's centre, which is taken one cycle ahead of where it is; or from the leader, or the
/// member one rank before, at the distance that their stations have from each other: then the leader keeps no
/// station.
///
/// @param unit     as this robot's unit tells it
/// @param pose     of this robot
/// @param spacing  between neighbours [m]
/// @param heading  where the formation looks, from straight ahead of the robot [rad]
/// @return  zero without a formation, and for a unit of one; for a sweep only the part along the heading
/// @source  Balch and Arkin 1998
geom::Vector formation_offset(const percept::UnitPercept& unit, const geom::Pose& pose,
                              percept::Formation formation, percept::FormationReference reference,
                              double spacing, double heading);

}  // namespace mlab::schema
