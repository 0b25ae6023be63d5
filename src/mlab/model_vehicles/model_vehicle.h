#pragma once

#include <string>
#include <string_view>

#include "mlab/geom/pose.h"

namespace mlab::model_vehicles {

/// A vehicle that isn't there, at its end of a serial line: it obeys what arrives, and says what it has to
/// say. It knows no clock: time goes by when it is told so.
class ModelVehicle {
 public:
  /// What it really does, whatever its sensors say.
  struct Truth {
    geom::Pose pose;         ///< [m, world]
    double speed = 0.0;      ///< along its heading [m/s]
    double turn_rate = 0.0;  ///< [rad/s]
  };

  ModelVehicle() = default;
  ModelVehicle(const ModelVehicle&) = delete;
  ModelVehicle& operator=(const ModelVehicle&) = delete;
  virtual ~ModelVehicle() = default;

  /// @param bytes  any; what is not understood is left out
  virtual void receive(std::string_view bytes) = 0;
  /// @param dt  that goes by [s], > 0, at most 0.1
  /// @return  what it says meanwhile
  virtual std::string step(double dt) = 0;
  /// Off and on again, where it stands.
  virtual void restart() = 0;
  virtual Truth truth() const = 0;
};

}  // namespace mlab::model_vehicles
