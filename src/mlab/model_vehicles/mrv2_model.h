#pragma once

#include <cstdint>
#include <memory>
#include <numbers>

#include "mlab/geom/pose.h"
#include "mlab/model_vehicles/model_vehicle.h"
#include "mlab/model_vehicles/sonar_ring.h"
#include "mlab/overlay/overlay.h"

namespace mlab::model_vehicles {

/// What a model of a Denning MRV-2 is like. As `library/robots/mrv2.cdl` has it, but as slow as it was driven
/// in GIT-COGSCI-95/02.
struct Mrv2Spec {
  double max_speed = 0.1;                         ///< [m/s]
  double max_turn_rate = std::numbers::pi / 2.0;  ///< [rad/s]
  double max_acceleration = 0.5;                  ///< [m/s^2]
  double watchdog = 1.0;        ///< after such a silence it brakes, whatever the last command said [s]
  double encoder_noise = 0.02;  ///< standard deviation of a step's length and turn, as a share of them
  SonarSpec sonar = {};
  bool lurches = false;    ///< it moves for `lurch`, stands for `pause`, and so on
  double lurch = 1.0;      ///< [s], > 0
  double pause = 0.5;      ///< [s], > 0
  geom::Pose place = {};   ///< where it stands when it is switched on [m, world]
  std::uint64_t seed = 1;  ///< of noise, drop-outs and drift
};

/// A Denning MRV-2 in the world of an overlay; speaks as docs/vehicles_mrv2.md says.
class Mrv2Model final : public ModelVehicle {
 public:
  Mrv2Model(const overlay::Overlay& world, const Mrv2Spec& spec);
  ~Mrv2Model() override;

  void receive(std::string_view bytes) override;
  std::string step(double dt) override;
  void restart() override;
  Truth truth() const override;
  /// Somebody beside it presses its emergency stop, or releases it.
  void press_stop(bool is_pressed);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace mlab::model_vehicles
