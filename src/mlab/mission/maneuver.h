#pragma once

#include <array>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "mlab/mission/mission.h"

namespace mlab::mission {

/// An option of SET that says how robots move. Its words are not reserved: they are told by where they stand.
struct ManeuverInfo {
  std::variant<BooleanOption, NumberOption> option;
  std::string_view word;  ///< `NAVIGATION`
  std::string_view on;    ///< what stands for true; empty: it takes a number
  std::string_view off;
  std::string_view help;       ///< what editors say of it
  std::string_view parameter;  ///< of robots' programs that it sets unless NEW-ROBOT does; empty: none
};
/// Parsers, printers, completion and crews take them from here.
inline constexpr std::array kManeuvers = {
    ManeuverInfo{BooleanOption::kPlanWays, "NAVIGATION", "PLANNED", "REACTIVE",
                 "PLANNED: robots plan their ways; REACTIVE: they only react to what they see", "plans_ways"},
    ManeuverInfo{BooleanOption::kAssignStations, "STATIONS", "ASSIGNED", "RANK",
                 "ASSIGNED: robots take the stations that need the least way; RANK: in their order", ""},
    ManeuverInfo{NumberOption::kCohesion, "COHESION", "", "",
                 "metres that a robot may be ahead of its station; 0: nobody waits", "cohesion"},
};

/// The row of an option; null where it is another kind of option.
constexpr const ManeuverInfo* maneuver(std::variant<BooleanOption, NumberOption> option) {
  for (const ManeuverInfo& one : kManeuvers) {
    if (one.option == option) return &one;
  }
  return nullptr;
}

/// A parameter of robots' programs, for those types that don't set it themselves.
struct Preset {
  std::string_view parameter;
  std::string value;
};
/// Those that a mission sets.
std::vector<Preset> presets(const Options& options);

}  // namespace mlab::mission
