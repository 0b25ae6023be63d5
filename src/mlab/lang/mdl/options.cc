#include "mlab/lang/mdl/options.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "mlab/lang/mdl/quoted.h"
#include "mlab/lang/odl/limits.h"

namespace mlab::mdl {
namespace {

using mission::BooleanOption;
using mission::NumberOption;

struct Range {
  double low = 0.0;
  double high = 0.0;
  std::string_view unit;
};

double shorter_side(overlay::Area area) {
  return std::min(area.width, area.height);
}

Range range_of(NumberOption option, const mission::Options& options, overlay::Area area) {
  const double side = shorter_side(area);
  switch (option) {
    case NumberOption::kSeed:
      return {-3.4e38, 3.4e38, ""};
    case NumberOption::kRobotLength:
      return options.scale_robots ? Range{0.0, side / 5.0, " metres, a fifth of the mission area"}
                                  : Range{0.0, 100.0, " pixels"};
    case NumberOption::kObstacleCoverage:
      return {0.0, 30.0, " per cent of the mission area"};
    case NumberOption::kMinObstacleRadius:
    case NumberOption::kMaxObstacleRadius:
      return {side / 1000.0, side / 5.0, " metres, a fifth of the mission area"};
    case NumberOption::kZoomFactor:
      return {10.0, 400.0, " per cent"};
    case NumberOption::kCycleDuration:
      return {0.01, 1.0, " seconds"};
    case NumberOption::kFailingRobots:
      return {0.0, 65535.0, ""};
    case NumberOption::kFailuresWithin:
      return {0.0, 1e6, " seconds"};
    case NumberOption::kCohesion:
      return {0.0, 1e6, " metres"};
  }
  return {};
}

bool* flag_of(BooleanOption option, mission::Options& options) {
  switch (option) {
    case BooleanOption::kUseMilitaryStyle:
      return &options.use_military_style;
    case BooleanOption::kShowTrails:
      return &options.show_trails;
    case BooleanOption::kHighlightRepellingObstacles:
      return &options.highlight_repelling_obstacles;
    case BooleanOption::kShowMovementVectors:
      return &options.show_movement_vectors;
    case BooleanOption::kShowColormap:
      return &options.show_colormap;
    case BooleanOption::kDebugRobots:
      return &options.debug_robots;
    case BooleanOption::kDebugSimulator:
      return &options.debug_simulator;
    case BooleanOption::kDebugScheduler:
      return &options.debug_scheduler;
    case BooleanOption::kScaleRobots:
    case BooleanOption::kPlanWays:
    case BooleanOption::kAssignStations:
      break;
  }
  return &options.scale_robots;
}

void apply_flag(mission::SetBoolean set, mission::Options& options) {
  if (set.option == BooleanOption::kPlanWays)
    options.plans_ways = set.value;
  else if (set.option == BooleanOption::kAssignStations)
    options.assigns_stations = set.value;
  else
    *flag_of(set.option, options) = set.value;
}

void apply_number(mission::SetNumber set, mission::Options& options) {
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
    case NumberOption::kFailingRobots:
      options.failing_robots = set.value;
      break;
    case NumberOption::kFailuresWithin:
      options.failures_within = set.value;
      break;
    case NumberOption::kCohesion:
      options.cohesion = set.value;
      break;
  }
}

}  // namespace

std::optional<mission::Command> read_set(const statement::Set& set, const mission::Options& options,
                                         overlay::Area area, const text::SourcePtr& source,
                                         text::Diagnostics& diagnostics) {
  if (const auto* flag = std::get_if<BooleanOption>(&set.option)) {
    return mission::SetBoolean{*flag, set.flag.value_or(true)};
  }
  const NumberOption option = std::get<NumberOption>(set.option);
  const Range range = range_of(option, options, area);
  double value = set.number->value;
  if (value < range.low || value > range.high) {
    diagnostics.error("number-out-of-range", {source, set.number->span},
                      fmt::format("{} goes from {:g} to {:g}{}, found {}", source->text(set.option_span),
                                  range.low, range.high, range.unit, in_backticks(set.number->text)));
    return std::nullopt;
  }
  if (option == NumberOption::kFailingRobots && value != std::floor(value)) {
    diagnostics.error("not-whole", {source, set.number->span},
                      fmt::format("{} takes a whole number, found {}", source->text(set.option_span),
                                  in_backticks(set.number->text)));
    return std::nullopt;
  }
  // Historic seeds went through a 32-bit number with a point, so 945816565 always meant 945816576.
  if (option == NumberOption::kSeed) value = std::round(static_cast<float>(value));
  return mission::SetNumber{option, value};
}

bool check_lengths(std::initializer_list<const Number*> lengths, std::string_view what,
                   const text::SourcePtr& source, text::Diagnostics& diagnostics) {
  const auto* wrong = std::ranges::find_if(
      lengths, [](const Number* length) { return std::abs(length->value) > odl::kMaxCoordinate; });
  if (wrong == lengths.end()) return true;
  diagnostics.error("number-out-of-range", {source, (*wrong)->span},
                    fmt::format("{} goes to {:g} metres at most, found {}", what, odl::kMaxCoordinate,
                                in_backticks((*wrong)->text)));
  return false;
}

void apply_set(const mission::Command& command, mission::Options& options) {
  if (const auto* flag = std::get_if<mission::SetBoolean>(&command)) apply_flag(*flag, options);
  if (const auto* number = std::get_if<mission::SetNumber>(&command)) apply_number(*number, options);
}

bool sets_nothing_new(const mission::Command& command, const mission::Options& options) {
  mission::Options now = options;
  if (const auto* flag = std::get_if<mission::SetBoolean>(&command)) {
    return *flag_of(flag->option, now) == flag->value;
  }
  // Of the numbers only this one can be set in a step.
  const auto* number = std::get_if<mission::SetNumber>(&command);
  return number != nullptr && number->option == NumberOption::kCycleDuration &&
         options.cycle_duration == number->value;
}

void reset_for_area(overlay::Area area, mission::Options& options) {
  const double side = shorter_side(area);
  options.min_obstacle_radius = std::clamp(2.0, side / 1000.0, side / 5.0);
  options.max_obstacle_radius = std::clamp(10.0, side / 1000.0, side / 5.0);
  options.zoom_percent = 100.0;
  options.robot_length = 0.0;
}

}  // namespace mlab::mdl
