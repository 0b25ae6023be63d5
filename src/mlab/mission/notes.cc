#include "mlab/mission/notes.h"

#include <fmt/format.h>

namespace mlab::mission {

std::vector<std::string> notes_of(const Mission& mission) {
  std::vector<std::string> notes;
  for (const RobotType& type : mission.types) {
    if (!type.host.empty())
      notes.push_back(
          fmt::format("note: robots of the type `{}` run on this machine, not on `{}`: hosts have no "
                      "meaning yet",
                      type.name, type.host));
  }
  return notes;
}

}  // namespace mlab::mission
