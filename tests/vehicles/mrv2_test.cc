// The Denning MRV-2, by what every device has to hold.

#include "mlab/vehicle/mrv2/mrv2.h"
#include "line_rig.h"
#include "mlab/model_vehicles/mrv2_model.h"
#include "mlab/vehicle/testing/conformance.h"

namespace mlab::vehicle {
namespace {

using model_vehicles::Mrv2Model;

/// With somebody beside it.
class Mrv2Rig final : public LineRig {
 public:
  Mrv2Rig(std::uint64_t seed, const Facts& facts, std::unique_ptr<Mrv2Model> vehicle)
      : LineRig(seed, facts, std::move(vehicle),
                [](std::unique_ptr<Stream> stream) { return make_mrv2_over(std::move(stream)); }) {}

  bool take_to_stand() override {
    model().press_stop(true);
    return true;
  }
  void give_back() override { model().press_stop(false); }

 private:
  Mrv2Model& model() { return static_cast<Mrv2Model&>(vehicle()); }
};

std::unique_ptr<Rig> make_mrv2_rig(std::uint64_t seed) {
  model_vehicles::Mrv2Spec spec;
  spec.encoder_noise = 0.0;  // else nobody could say what is right
  spec.seed = seed;
  const Facts facts{.silent_after = kMrv2SilentAfter,
                    .stops_within = 0.4,
                    .has_ranges = true,
                    .has_battery = true,
                    .refuses_late_commands = true};
  return std::make_unique<Mrv2Rig>(seed, facts, std::make_unique<Mrv2Model>(overlay::Overlay{}, spec));
}

INSTANTIATE_TEST_SUITE_P(Mrv2, Conformance, testing::Values(RigKind{"Mrv2", make_mrv2_rig}), kind_name);

}  // namespace
}  // namespace mlab::vehicle
