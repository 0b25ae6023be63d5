#pragma once

#include <span>
#include <vector>

#include "mlab/ways/bending_planner.h"
#include "mlab/ways/lane_order.h"

/// For sources of this module only.
namespace mlab::ways {

/// Pieces of lanes that one robot follows, one after the other.
using LaneShare = std::vector<LanePiece>;

/// Shares pieces out so that all ways together are short, and none of them much longer than the others: the
/// order is cut into parts of one length, then pieces are turned round, moved and exchanged between them,
/// some of them though that is worse for now. Long pieces are cut.
///
/// @param in_order  as one robot would follow them
/// @param robots    where those are that share it; without, there is one share [m, world]
/// @param swath     [m], > 0; a share has the length of some swaths at least, so there may be fewer of them
///                  than robots
/// @return  one at least; none is empty unless all are; the same for the same
/// @source  G. Frederickson, M. Hecht, C. Kim, Approximation algorithms for some routing problems, SIAM
/// Journal on
///          Computing 7(2), 1978 (cutting a tour); I. Osman, Metastrategy simulated annealing and tabu search
///          algorithms for the vehicle routing problem, Annals of Operations Research 41, 1993
std::vector<LaneShare> shared_out(std::span<const LanePiece> in_order, BendingPlanner& planner,
                                  std::span<const geom::Point> robots, double swath);

}  // namespace mlab::ways
