#pragma once

#include <set>
#include <string>
#include <vector>

#include "mlab/lang/cdl/syntax/tree.h"

namespace mlab::cdl_historic {

/// A robot that an import leaves standing, because what moved it has no counterpart here.
struct Standing {
  std::string robot;
  std::vector<std::string> states;  ///< in which it stands; empty: always
  std::set<std::string> missing;    ///< the empty assemblages in the place of what moved it
};

/// Those of an imported configuration, in the order of the text. A robot that cooperates or competes stands
/// where all members do; what chooses only when to do something (triggers) does not count.
std::vector<Standing> standing_robots(const cdl::Tree& imported);

/// For people, one line: `R1 (no Dock); R2 in the state A.Docking (no Dock)`.
std::string said_of(const std::vector<Standing>& robots);

}  // namespace mlab::cdl_historic
