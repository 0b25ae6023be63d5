// The simulated vehicle in a process of its own, as runs of a fleet drive it, by what every device has to
// hold.

#include "mlab/simulated_vehicle/simulated_device.h"
#include "mlab/vehicle/testing/conformance.h"
#include "served_rig.h"

namespace mlab::vehicle {
namespace {

std::unique_ptr<Rig> make_simulated_rig(std::uint64_t seed) {
  // Nearly all of the time for which a command lives goes by on such a way: it moves in jerks.
  const Facts facts{.silent_after = 1.0,
                    .stops_within = 0.8,
                    .bad_line_share = 0.3,
                    .has_ranges = true,
                    .refuses_late_commands = true,
                    .has_checks = false};
  return std::make_unique<ServedRig>(seed, facts, [seed](const geom::Pose& place) {
    SimulatedDevice::Settings settings;
    settings.start = place;
    settings.seed = seed;
    return std::make_unique<SimulatedDevice>(sim::World{}, settings);
  });
}

INSTANTIATE_TEST_SUITE_P(Simulated, Conformance, testing::Values(RigKind{"Simulated", make_simulated_rig}),
                         kind_name);

}  // namespace
}  // namespace mlab::vehicle
