#include "mlab/console/published/status_encoder.h"

namespace mlab::console {
namespace {

using mission::BooleanOption;
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

}  // namespace

void encode_options(const Options& options, Status& out) {
  for (const Switch& known : kSwitches) {
    if (options.*known.value) out.add_options(known.name);
  }
  out.set_zoom_percent(options.zoom_percent);
}

}  // namespace mlab::console
