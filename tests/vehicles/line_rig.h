#pragma once

#include <expected>
#include <functional>
#include <memory>
#include <string>

#include "mlab/model_vehicles/model_vehicle.h"
#include "mlab/vehicle/device.h"
#include "mlab/vehicle/stream.h"
#include "mlab/vehicle/testing/line.h"
#include "mlab/vehicle/testing/rig.h"

namespace mlab::vehicle {

/// A device and a model vehicle at the two ends of a line, on a clock of their own.
class LineRig : public Rig {
 public:
  using Made = std::expected<std::unique_ptr<Device>, std::string>;

  LineRig(std::uint64_t seed, const Facts& facts, std::unique_ptr<model_vehicles::ModelVehicle> vehicle,
          const std::function<Made(std::unique_ptr<Stream>)>& make_device,
          TestLine::Kind kind = TestLine::Kind::kSerial);

  const Facts& facts() const override { return facts_; }
  Device& device() override { return *device_; }
  void drop_device() override { device_.reset(); }
  Clock::time_point step() override;
  Truth truth() const override;
  void impair(const Impairment& impairment) override { line_.impair(impairment); }
  void cut(Cut how) override;
  void mend() override;
  void hold_back() override { line_.hold_back(); }
  void release() override { line_.release(now_); }

 protected:
  model_vehicles::ModelVehicle& vehicle() { return *vehicle_; }

 private:
  Facts facts_;
  TestLine line_;
  std::unique_ptr<model_vehicles::ModelVehicle> vehicle_;
  std::unique_ptr<Device> device_;
  Clock::time_point now_{std::chrono::hours(1)};
  bool is_off_ = false;
};

}  // namespace mlab::vehicle
