#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "mlab/binding/body.h"
#include "mlab/binding/world_view.h"
#include "mlab/geom/pose.h"
#include "mlab/model_vehicles/model_vehicle.h"
#include "mlab/overlay/overlay.h"
#include "mlab/percept/percepts.h"

namespace mlab::model_vehicles {

/// One body of the simulator, alone in the world of an overlay.
class Body {
 public:
  /// @param place  where it is put, or at the nearest free place
  /// @param seed   of its encoders' drift
  Body(const overlay::Overlay& world, const binding::BodySpec& spec, const geom::Pose& place,
       std::uint64_t seed);
  ~Body();
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;

  void step(double speed, double turn_rate, double dt);
  ModelVehicle::Truth truth() const;
  /// Where its encoders say that it is, counted from where it was put or `count_from_here` was called.
  geom::Pose counted();
  void count_from_here();
  /// From its edge, without any noise. Valid until the next call.
  std::span<const percept::RangeReading> ranges();
  std::span<const binding::Wall> walls() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace mlab::model_vehicles
