// The vehicle of docs/adding_a_vehicle.md, by what every device has to hold.

#include "mlab/vehicle/text_rover/text_rover.h"
#include "line_rig.h"
#include "mlab/model_vehicles/text_rover_model.h"
#include "mlab/vehicle/testing/conformance.h"

namespace mlab::vehicle {
namespace {

std::unique_ptr<Rig> make_text_rover_rig(std::uint64_t seed) {
  model_vehicles::TextRoverSpec spec;
  spec.encoder_noise = 0.0;  // else nobody could say what is right
  spec.seed = seed;
  const Facts facts{.silent_after = 1.0,
                    .stops_within = 1.3,
                    .has_ranges = true,
                    .has_battery = true,
                    .refuses_late_commands = true};
  return std::make_unique<LineRig>(
      seed, facts, std::make_unique<model_vehicles::TextRoverModel>(overlay::Overlay{}, spec),
      [](std::unique_ptr<Stream> stream) { return make_text_rover_over(std::move(stream)); });
}

INSTANTIATE_TEST_SUITE_P(TextRover, Conformance, testing::Values(RigKind{"TextRover", make_text_rover_rig}),
                         kind_name);

}  // namespace
}  // namespace mlab::vehicle
