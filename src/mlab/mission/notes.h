#pragma once

#include <string>
#include <vector>

#include "mlab/mission/mission.h"

namespace mlab::mission {

/// What people should know of a mission before it runs, though nothing is wrong with it: hosts, which have no
/// meaning yet. One sentence each.
std::vector<std::string> notes_of(const Mission& mission);

}  // namespace mlab::mission
