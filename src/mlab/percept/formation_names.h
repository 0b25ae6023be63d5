#pragma once

#include <array>
#include <string_view>

#include "mlab/base/table.h"
#include "mlab/percept/formation.h"

namespace mlab::percept {

/// How missions write a formation.
struct FormationInfo {
  Formation formation;
  std::string_view name;     ///< `Wedge-Left`
  std::string_view keyword;  ///< the same in capitals
};
/// By their numbers.
inline constexpr std::array kFormations = {
    FormationInfo{Formation::kNone, "No-Formation", "NO-FORMATION"},
    FormationInfo{Formation::kLine, "Line", "LINE"},
    FormationInfo{Formation::kLineLeft, "Line-Left", "LINE-LEFT"},
    FormationInfo{Formation::kLineRight, "Line-Right", "LINE-RIGHT"},
    FormationInfo{Formation::kWedge, "Wedge", "WEDGE"},
    FormationInfo{Formation::kWedgeLeft, "Wedge-Left", "WEDGE-LEFT"},
    FormationInfo{Formation::kWedgeRight, "Wedge-Right", "WEDGE-RIGHT"},
    FormationInfo{Formation::kDiamond, "Diamond", "DIAMOND"},
    FormationInfo{Formation::kColumn, "Column", "COLUMN"},
    FormationInfo{Formation::kSweep, "Sweep", "SWEEP"},
};
static_assert(base::has_a_row_for_each<kFormations, &FormationInfo::formation>());
static_assert(kFormations.size() == kFormationCount);

}  // namespace mlab::percept
