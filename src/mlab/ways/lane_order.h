#pragma once

#include <vector>

#include "mlab/ways/bending_planner.h"
#include "mlab/ways/lane_ends.h"
#include "mlab/ways/search_grid.h"

/// For sources of this module only.
namespace mlab::ways {

/// All pieces of all lanes of the grid from which something can be seen, in an order in which the ways from
/// one to the next are short: to and fro in cells in which lanes lie side by side, one cell after the other,
/// then improved by turning round parts of the order, and by moving some pieces elsewhere.
/// @source  H. Choset, Autonomous Robots 9(3), 2000 (boustrophedon cells); S. Lin, Bell System Technical
///          Journal 44(10), 1965 (turning round); I. Or, Northwestern University, 1976 (moving)
std::vector<LanePiece> lane_pieces_in_order(const SearchGrid& grid, BendingPlanner& planner);

}  // namespace mlab::ways
