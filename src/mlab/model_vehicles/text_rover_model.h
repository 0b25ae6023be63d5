#pragma once

#include <cstdint>
#include <memory>

#include "mlab/geom/pose.h"
#include "mlab/model_vehicles/model_vehicle.h"
#include "mlab/overlay/overlay.h"

namespace mlab::model_vehicles {

/// What a model of the text rover is like.
struct TextRoverSpec {
  double max_speed = 0.5;       ///< [m/s]
  double max_turn_rate = 1.0;   ///< [rad/s]
  double encoder_noise = 0.02;  ///< standard deviation of a step's length and turn, as a share of them
  geom::Pose place = {};        ///< where it stands when it is switched on [m, world]
  std::uint64_t seed = 1;
};

/// The vehicle of docs/adding_a_vehicle.md, in the world of an overlay: two wheels, eight sensors of
/// distances.
class TextRoverModel final : public ModelVehicle {
 public:
  TextRoverModel(const overlay::Overlay& world, const TextRoverSpec& spec);
  ~TextRoverModel() override;

  void receive(std::string_view bytes) override;
  std::string step(double dt) override;
  void restart() override;
  Truth truth() const override;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace mlab::model_vehicles
