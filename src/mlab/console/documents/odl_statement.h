#pragma once

#include <string>

#include "mlab/console.pb.h"
#include "mlab/geom/pose.h"
#include "mlab/lang/odl/tree.h"
#include "mlab/overlay/overlay.h"

namespace mlab::console {

/// What keeps a thing from being written; empty: nothing.
std::string problem_with(const Measure& measure);
std::string problem_with(const Obstacle& obstacle);
std::string problem_with(const WorldObject& object);

/// The statements that say these. The thing has no problem.
/// @param origin  in force where the statement is to stand: it is taken off coordinates
odl::Statement statement_of(const Measure& measure, geom::Offset origin);
odl::Statement statement_of(const Obstacle& obstacle, geom::Offset origin);
odl::Statement statement_of(const WorldObject& object, geom::Offset origin);

/// What becomes of a statement, so that it says `after` in place of `before`. What both have in common stays
/// as its author wrote it; a point in degrees that moves becomes metres.
/// @param origin  in force, for points whose statement does not tell it
odl::Statement changed(const odl::Statement& was, const overlay::ControlMeasure& before, const Measure& after,
                       geom::Offset origin);
odl::Statement changed(const odl::Statement& was, const overlay::ObstacleDisc& before, const Obstacle& after,
                       geom::Offset origin);
odl::Statement changed(const odl::Statement& was, const overlay::WorldObject& before,
                       const WorldObject& after, geom::Offset origin);

/// Differences below this are none [m].
inline constexpr double kSameNumber = 1e-6;
/// A new coordinate. What is left of one after taking an origin off may be dust.
double coordinate(double value);

}  // namespace mlab::console
