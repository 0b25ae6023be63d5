#include "mlab/cli/fleet_vehicles.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "mlab/base/hash.h"
#include "mlab/cli/clock.h"
#include "mlab/cli/fleet_network.h"
#include "mlab/cli/fleet_words.h"
#include "mlab/cli/places.h"
#include "mlab/cli/version.h"
#include "mlab/preflight/gated_line.h"
#include "mlab/text/shell_word.h"
#include "mlab/vehicle/bodies.h"
#include "mlab/vehicle/messages.h"
#include "mlab/vehicles/vehicle_line.h"

namespace mlab::cli {
namespace {

constexpr std::chrono::seconds kFindingPatience(5);          // for a member that a mission names
constexpr std::chrono::milliseconds kHearingPatience(5000);  // for a vehicle to say where it is
constexpr std::chrono::milliseconds kWonders(500);           // then somebody is told what is waited for

/// The vehicles of a fleet, as runs in this process know them.
class FleetVehicles {
 public:
  FleetVehicles(std::shared_ptr<agents::Roster> roster, std::shared_ptr<vehicles::FleetFacts> facts,
                std::shared_ptr<preflight::Gate> gate)
      : roster_(std::move(roster)), facts_(std::move(facts)), gate_(std::move(gate)) {}

  /// Who is not there yet is waited for, as long as this has only just joined; by any thread.
  bool has(const std::string& host) const {
    const auto is_there = [&](const std::vector<agents::Member>& members) {
      return std::ranges::any_of(members, [&](const agents::Member& one) {
        return one.said.name() == host && one.state == agents::Member::State::kThere;
      });
    };
    const auto wonders = std::min(all_found_, agents::Clock::now() + kWonders);
    if (!roster_->wait(is_there, wonders) && wonders < all_found_) {
      say(fmt::format("waiting for `{}` to join the fleet", host));
      roster_->wait(is_there, all_found_);
    }
    const auto member = roster_->find(host);
    return member && member->said.has_vehicle();
  }

  std::unique_ptr<binding::Binding> bodies(const mission::Mission& mission,
                                           std::unique_ptr<binding::Binding> simulated) {
    const std::vector<std::string> names = preflight::hosts_of(mission);
    const std::shared_ptr<preflight::Permit> permit = gate_->new_permit();
    std::vector<vehicle::Crewed> crewed;
    bool has_real = false;
    for (const std::string& name : names) {
      if (!has(name)) continue;
      const wire::OfferedVehicle said = roster_->find(name)->said.vehicle();
      // Where they can't be, its robot says so when it is started.
      const auto limits = vehicle::limits_of(said);
      auto line = vehicles::open_line(
          roster_, name, kHearingPatience,
          {kWonders, [&] { say(fmt::format("waiting for the vehicle `{}` to say where it is", name)); }});
      // Whose robot is started then hears that its vehicle was not found.
      if (!line) continue;
      const bool is_real = !said.is_simulated();
      has_real = has_real || is_real;
      if (is_real) *line = preflight::gated(name, std::move(*line), permit);
      crewed.push_back({name, limits.value_or(vehicle::Limits()), std::move(*line), said.kind(),
                        limits ? "" : limits.error()});
    }
    if (has_real)
      facts_->expect(names);
    else
      permit->give({});  // nobody has to look at anything
    if (crewed.empty()) return simulated;
    const std::uint64_t session =
        base::hash_text(roster_->participant().guid().text() + "/" + std::to_string(++sessions_));
    return std::make_unique<vehicle::Bodies>(std::move(simulated), std::move(crewed), session | 1U,
                                             mission.overlay.projection);
  }

 private:
  // The run that could tell it in its log is only being made.
  static void say(const std::string& what) { fmt::print(stderr, "mlab: {}\n", what); }

  std::shared_ptr<agents::Roster> roster_;
  std::shared_ptr<vehicles::FleetFacts> facts_;
  std::shared_ptr<preflight::Gate> gate_;
  agents::Clock::time_point all_found_ = agents::Clock::now() + kFindingPatience;
  std::atomic<std::uint64_t> sessions_ = 0;
};

}  // namespace

std::shared_ptr<preflight::Gate> make_gate(const std::shared_ptr<vehicles::FleetFacts>& facts,
                                           const NetworkOptions& network, const std::string& mission,
                                           const std::string& unchecked) {
  const std::string fleet = fleet_of(network.fleet);
  const std::string folder = state_folder();
  return std::make_shared<preflight::Gate>(preflight::Gate::Parts{
      .fleet = fleet,
      .version = kVersion,
      .look = [facts](const std::vector<std::string>& names) { return facts->look(names); },
      .glance = [facts](const std::vector<std::string>& names) { return facts->glance(names); },
      .wall_clock = [] { return wall_clock().epoch_seconds; },
      .store = preflight::Store(folder.empty() ? "" : folder + "/preflight"),
      .how = fmt::format("mlab preflight {} --fleet {}{} --sign \"YOUR NAME\"",
                         mission.empty() ? "MISSION.mdl" : text::shell_word(mission), fleet,
                         fleet_options(network)),
      .unchecked = unchecked,
  });
}

std::shared_ptr<preflight::Gate> settle_vehicles(const std::shared_ptr<agents::Roster>& roster,
                                                 const RunOptions& options, run::RunSettings& settings) {
  const auto facts = std::make_shared<vehicles::FleetFacts>(roster);
  auto gate = make_gate(facts, options.network, options.mission, options.unchecked);
  const auto vehicles = std::make_shared<FleetVehicles>(roster, facts, gate);
  settings.is_vehicle = [vehicles](const std::string& host) { return vehicles->has(host); };
  settings.vehicles = [vehicles](const mission::Mission& mission,
                                 std::unique_ptr<binding::Binding> simulated) {
    return vehicles->bodies(mission, std::move(simulated));
  };
  return gate;
}

}  // namespace mlab::cli
