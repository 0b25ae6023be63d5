#pragma once

#include <memory>

#include "mlab/geography/geo_point.h"
#include "mlab/geom/pose.h"
#include "mlab/model_vehicles/model_vehicle.h"
#include "mlab/overlay/overlay.h"

namespace mlab::model_vehicles {

/// What a model of a rover under ArduPilot is like.
struct MavlinkRoverSpec {
  double max_speed = 1.0;         ///< [m/s], either way
  double max_turn_rate = 1.0;     ///< [rad/s]
  double max_acceleration = 2.0;  ///< [m/s^2]
  double guided_timeout = 1.5;    ///< its parameter GUID_TIMEOUT [s]
  double scan_lag = 0.0;          ///< from when its distances were measured to when they are said [s]
  geom::Pose place = {};          ///< where it stands when it is switched on [m, world]
  /// Where the world's (0, 0) lies, unless the overlay says so.
  geography::GeoPoint earth = {49.0, 8.3};
};

/// A rover that speaks MAVLink 2 as ArduPilot's do, in the world of an overlay: modes and arming,
/// acknowledgements, set-points that expire, its failsafe for a ground station that is not heard any more,
/// messages as often as they were asked for, 72 distances all round. Its parameters are as they have to be.
class MavlinkRoverModel final : public ModelVehicle {
 public:
  MavlinkRoverModel(const overlay::Overlay& world, const MavlinkRoverSpec& spec);
  ~MavlinkRoverModel() override;

  void receive(std::string_view bytes) override;
  std::string step(double dt) override;
  void restart() override;
  Truth truth() const override;
  /// A pilot puts it into MANUAL, and has it go on at that speed until its mode is another one [m/s].
  void take_by_pilot(double speed);
  /// A pilot puts it into HOLD.
  void hold_by_pilot();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace mlab::model_vehicles
