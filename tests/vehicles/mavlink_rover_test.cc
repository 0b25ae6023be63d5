// A rover under ArduPilot, by what every device has to hold. What plays it knows MAVLink as its device does;
// mavlink_peer_test.cc has one that does not.

#include "line_rig.h"
#include "mlab/mavlink/rover_device.h"
#include "mlab/model_vehicles/mavlink_rover_model.h"
#include "mlab/vehicle/testing/conformance.h"

namespace mlab::vehicle {
namespace {

using model_vehicles::MavlinkRoverModel;

/// With a pilot beside it.
class MavlinkRoverRig final : public LineRig {
 public:
  MavlinkRoverRig(std::uint64_t seed, const Facts& facts, std::unique_ptr<MavlinkRoverModel> vehicle,
                  const std::function<Made(std::unique_ptr<Stream>)>& make_device, TestLine::Kind kind)
      : LineRig(seed, facts, std::move(vehicle), make_device, kind) {}

  bool take() override {
    static_cast<MavlinkRoverModel&>(vehicle()).take_by_pilot(0.5);
    return true;
  }
  bool take_to_stand() override {
    static_cast<MavlinkRoverModel&>(vehicle()).hold_by_pilot();
    return true;
  }
};

std::unique_ptr<Rig> make_mavlink_rover_rig(std::uint64_t seed, TestLine::Kind kind) {
  const model_vehicles::MavlinkRoverSpec spec;
  const Facts facts{.silent_after = std::chrono::duration<double>(mavlink::kSilentAfter).count(),
                    .battery_lasts = std::chrono::duration<double>(mavlink::kBatteryLasts).count(),
                    .ready_within = 10.0,  // three of which it starts
                    .stops_within = 1.0,
                    .has_ranges = true,
                    .has_battery = true};
  const auto make_device = [&](std::unique_ptr<Stream> stream) -> LineRig::Made {
    mavlink::RoverSettings settings;
    settings.limits.kinematics.max_speed = spec.max_speed;
    settings.limits.kinematics.max_turn_rate = spec.max_turn_rate;
    settings.limits.min_speed = -spec.max_speed;
    return std::make_unique<mavlink::RoverDevice>(std::move(stream), settings);
  };
  return std::make_unique<MavlinkRoverRig>(
      seed, facts, std::make_unique<MavlinkRoverModel>(overlay::Overlay{}, spec), make_device, kind);
}

std::unique_ptr<Rig> make_serial_rig(std::uint64_t seed) {
  return make_mavlink_rover_rig(seed, TestLine::Kind::kSerial);
}

std::unique_ptr<Rig> make_udp_rig(std::uint64_t seed) {
  return make_mavlink_rover_rig(seed, TestLine::Kind::kDatagrams);
}

INSTANTIATE_TEST_SUITE_P(MavlinkRover, Conformance,
                         testing::Values(RigKind{"MavlinkSerial", make_serial_rig},
                                         RigKind{"MavlinkUdp", make_udp_rig}),
                         kind_name);

}  // namespace
}  // namespace mlab::vehicle
