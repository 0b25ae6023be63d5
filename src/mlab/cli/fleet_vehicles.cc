#include "mlab/cli/fleet_vehicles.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "mlab/base/hash.h"
#include "mlab/vehicle/bodies.h"
#include "mlab/vehicle/messages.h"
#include "mlab/vehicles/vehicle_line.h"

namespace mlab::cli {
namespace {

constexpr std::chrono::seconds kFindingPatience(5);          // for a member that a mission names
constexpr std::chrono::milliseconds kHearingPatience(2000);  // for a vehicle to say where it is

/// The vehicles of a fleet, as runs in this process know them.
class FleetVehicles {
 public:
  explicit FleetVehicles(std::shared_ptr<agents::Roster> roster) : roster_(std::move(roster)) {}

  /// Who is not there yet is waited for, as long as this has only just joined; by any thread.
  bool has(const std::string& host) const {
    const auto is_there = [&](const std::vector<agents::Member>& members) {
      return std::ranges::any_of(members, [&](const agents::Member& one) {
        return one.said.name() == host && one.state == agents::Member::State::kThere;
      });
    };
    roster_->wait(is_there, all_found_);
    const auto member = roster_->find(host);
    return member && member->said.has_vehicle();
  }

  std::unique_ptr<binding::Binding> bodies(const mission::Mission& mission,
                                           std::unique_ptr<binding::Binding> simulated) {
    std::set<std::string> names;
    for (const mission::Robot& robot : mission.robots) names.insert(mission.types[robot.type].host);
    std::vector<vehicle::Crewed> crewed;
    for (const std::string& name : names) {
      if (name.empty() || !has(name)) continue;
      const auto limits = vehicle::limits_of(roster_->find(name)->said.vehicle());
      if (!limits) continue;
      auto line = vehicles::open_line(roster_, name, kHearingPatience);
      // Whose robot is started then hears that its vehicle was not found.
      if (line) crewed.push_back({name, *limits, std::move(*line)});
    }
    if (crewed.empty()) return simulated;
    const std::uint64_t session =
        base::hash_text(roster_->participant().guid().text() + "/" + std::to_string(++sessions_));
    return std::make_unique<vehicle::Bodies>(std::move(simulated), std::move(crewed), session | 1U,
                                             mission.overlay.projection);
  }

 private:
  std::shared_ptr<agents::Roster> roster_;
  agents::Clock::time_point all_found_ = agents::Clock::now() + kFindingPatience;
  std::atomic<std::uint64_t> sessions_ = 0;
};

}  // namespace

void settle_vehicles(const std::shared_ptr<agents::Roster>& roster, run::RunSettings& settings) {
  const auto vehicles = std::make_shared<FleetVehicles>(roster);
  settings.is_vehicle = [vehicles](const std::string& host) { return vehicles->has(host); };
  settings.vehicles = [vehicles](const mission::Mission& mission,
                                 std::unique_ptr<binding::Binding> simulated) {
    return vehicles->bodies(mission, std::move(simulated));
  };
}

}  // namespace mlab::cli
