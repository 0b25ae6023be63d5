#include "mlab/lang/mdl/battery_check.h"

#include <fmt/core.h>

#include "mlab/lang/mdl/quoted.h"

namespace mlab::mdl {

void check_batteries(const mission::Mission& mission, text::Diagnostics& diagnostics) {
  for (const mission::Failsafe& row : mission.failsafes) {
    if (mission::info(row.condition).watch != mission::FailsafeWatch::kVehicle) continue;
    bool guards_some = false;
    bool may_be_vehicle = false;
    for (const mission::Robot& robot : mission.robots) {
      const mission::RobotType& type = mission.types[robot.type];
      if (!row.is_of(type.name)) continue;
      guards_some = true;
      may_be_vehicle = may_be_vehicle || !type.host.empty();
    }
    if (!guards_some || may_be_vehicle) continue;
    diagnostics
        .warning(
            "no-battery", row.place,
            fmt::format("{} never acts: simulated robots have no battery, and no robot that it guards is "
                        "a vehicle",
                        in_backticks(mission::words_of(row))))
        .hints.emplace_back(
            "a vehicle is the host of its robot's type: `NEW-ROBOT scout robot green \"veh-1\"`");
  }
}

}  // namespace mlab::mdl
