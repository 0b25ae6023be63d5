#include <string>
#include <variant>
#include <vector>

#include "mlab/console/live_run.h"

namespace mlab::console {
namespace {

using mission::BooleanOption;
using mission::NumberOption;
using mission::Options;

struct Switch {
  BooleanOption option;
  const char* name;
  bool Options::* value;
};

constexpr Switch kSwitches[] = {
    {BooleanOption::kUseMilitaryStyle, "USE-MILITARY-STYLE", &Options::use_military_style},
    {BooleanOption::kShowTrails, "SHOW-TRAILS", &Options::show_trails},
    {BooleanOption::kHighlightRepellingObstacles, "HIGHLIGHT-REPELLING-OBSTACLES",
     &Options::highlight_repelling_obstacles},
    {BooleanOption::kShowMovementVectors, "SHOW-MOVEMENT-VECTORS", &Options::show_movement_vectors},
    {BooleanOption::kShowColormap, "SHOW-COLORMAP", &Options::show_colormap},
    {BooleanOption::kDebugRobots, "DEBUG-ROBOTS", &Options::debug_robots},
    {BooleanOption::kDebugSimulator, "DEBUG-SIMULATOR", &Options::debug_simulator},
    {BooleanOption::kDebugScheduler, "DEBUG-SCHEDULER", &Options::debug_scheduler},
    {BooleanOption::kScaleRobots, "SCALE-ROBOTS", &Options::scale_robots},
};

void set_number(Options& options, const mission::SetNumber& set) {
  switch (set.option) {
    case NumberOption::kSeed:
      options.seed = set.value;
      break;
    case NumberOption::kRobotLength:
      options.robot_length = set.value;
      break;
    case NumberOption::kObstacleCoverage:
      options.obstacle_coverage = set.value;
      break;
    case NumberOption::kMinObstacleRadius:
      options.min_obstacle_radius = set.value;
      break;
    case NumberOption::kMaxObstacleRadius:
      options.max_obstacle_radius = set.value;
      break;
    case NumberOption::kZoomFactor:
      options.zoom_percent = set.value;
      break;
    case NumberOption::kCycleDuration:
      options.cycle_duration = set.value;
      break;
  }
}

}  // namespace

void set_option(Options& options, const std::variant<mission::SetBoolean, mission::SetNumber>& option) {
  if (const auto* number = std::get_if<mission::SetNumber>(&option)) set_number(options, *number);
  const auto* boolean = std::get_if<mission::SetBoolean>(&option);
  if (boolean == nullptr) return;
  for (const Switch& known : kSwitches) {
    if (known.option == boolean->option) options.*known.value = boolean->value;
  }
}

std::vector<std::string> options_on(const Options& options) {
  std::vector<std::string> out;
  for (const Switch& known : kSwitches) {
    if (options.*known.value) out.emplace_back(known.name);
  }
  return out;
}

}  // namespace mlab::console
