#include "mlab/mission/maneuver.h"

#include <fmt/core.h>

namespace mlab::mission {

std::vector<Preset> presets(const Options& options) {
  std::vector<Preset> out;
  if (options.plans_ways)
    out.push_back({maneuver(BooleanOption::kPlanWays)->parameter, *options.plans_ways ? "1" : "0"});
  if (options.cohesion)
    out.push_back({maneuver(NumberOption::kCohesion)->parameter, fmt::format("{}", *options.cohesion)});
  return out;
}

}  // namespace mlab::mission
