#pragma once

#include <string>
#include <vector>

#include "mlab/sim/simulated_binding.h"
#include "mlab/sim/world.h"
#include "mlab/vehicle/device.h"

namespace mlab::vehicle {

/// A vehicle that is simulated, in a world of its own and in real time, as far as who drives it can tell: for
/// trying missions on vehicles without one. It knows where it is, and has a scanner all round.
class SimulatedDevice final : public Device {
 public:
  struct Settings {
    std::string name = "simulated vehicle";  ///< for people
    binding::BodySpec spec = standard();
    geom::Pose start;
    std::uint64_t seed = 1;  ///< of the scanner's noise
  };
  /// Differential drive, 1 m/s, 60 beams of 10 m.
  static binding::BodySpec standard();

  /// @param world  what stands there; whatever missions know of it
  SimulatedDevice(sim::World world, const Settings& settings);

  const std::string& name() const override { return name_; }
  const Limits& limits() const override { return limits_; }
  void work(Clock::time_point now) override;
  const Report& report(Clock::time_point /*now*/) override { return report_; }
  std::vector<Check> checks(Clock::time_point now) override;
  bool is_simulated() const override { return true; }
  void drive(const Command& command, Clock::time_point now) override;
  void stop(Clock::time_point now) override;

 private:
  void look();

  std::string name_;
  Limits limits_;
  sim::SimulatedBinding world_;
  binding::BodyIndex body_;
  Command command_;
  Clock::time_point told_;  // when it was
  Clock::time_point at_;    // to which it has been simulated
  Report report_;
};

}  // namespace mlab::vehicle
