#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "mlab/mission/mission.h"

namespace mlab::mission {

// Parameters of the standard robot where a type sets none, as `library/robots/scout.cdl` has them [m].

inline constexpr double kDefaultBodyRadius = 0.2;  ///< `robot_radius`
inline constexpr double kDefaultMargin = 5.0;      ///< `avoid_obstacle_safety_margin`
inline constexpr double kDefaultRobotSphere =
    30.0;  ///< `navigation_avoid_robot_sphere`, `occupy_avoid_robot_sphere`
inline constexpr double kDefaultSuccessRadius = 10.0;  ///< `navigation_success_radius`
inline constexpr double kDefaultSpacing = 50.0;        ///< `formation_spacing`
inline constexpr double kDefaultSlop = 10.0;           ///< `formation_slop`
inline constexpr double kDefaultTrigger = 100.0;       ///< `formation_default_trigger`

/// The type of a robot; null where the mission has none of that number.
inline const RobotType* type_of(const Mission& mission, base::RobotId id) {
  const auto robot = std::ranges::find(mission.robots, id, &Robot::id);
  return robot == mission.robots.end() || robot->type >= mission.types.size() ? nullptr
                                                                              : &mission.types[robot->type];
}

/// What a type's parameter is set to, last; `otherwise` where it is not, or to what is no number.
inline double number_parameter(const RobotType& type, std::string_view key, double otherwise) {
  double out = otherwise;
  for (const RobotParameter& parameter : type.parameters) {
    if (parameter.key != key) continue;
    double value = 0.0;
    const char* end = parameter.value.data() + parameter.value.size();
    const auto read = std::from_chars(parameter.value.data(), end, value);
    out = read.ec == std::errc{} && read.ptr == end && std::isfinite(value) ? value : otherwise;
  }
  return out;
}

}  // namespace mlab::mission
