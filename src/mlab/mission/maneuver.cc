#include "mlab/mission/maneuver.h"

#include <fmt/core.h>

namespace mlab::mission {

std::vector<Preset> presets(const Options& options) {
  std::vector<Preset> out;
  for (const ManeuverInfo& one : kManeuvers) {
    if (one.parameter.empty()) continue;
    if (one.option == decltype(one.option){BooleanOption::kPlanWays} && options.plans_ways)
      out.push_back({one.parameter, *options.plans_ways ? "1" : "0"});
    if (one.option == decltype(one.option){NumberOption::kCohesion} && options.cohesion)
      out.push_back({one.parameter, fmt::format("{}", *options.cohesion)});
  }
  return out;
}

}  // namespace mlab::mission
