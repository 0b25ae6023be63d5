#pragma once

#include <cstdint>
#include <vector>

#include "mlab/binding/radio.h"
#include "mlab/sim/bodies.h"
#include "mlab/sim/sensors.h"
#include "mlab/sim/statics.h"

namespace mlab::sim {

/// How strong the signal between two bodies is [%]; 0: they don't hear each other.
/// @param walls  memory for those in between
double signal_between(const Sensors::Scene& scene, std::uint32_t a, std::uint32_t b,
                      std::vector<std::uint32_t>& walls);

/// Who hears whom, as bodies stand in a scene.
class Radio final : public binding::RadioLinks {
 public:
  /// Links bodies anew.
  void link(const Sensors::Scene& scene);

  std::uint32_t net_of(BodyIndex body) const override;
  bool arrives(BodyIndex from, BodyIndex to) const override;
  bool loses(BodyIndex from) const override { return losses_[from.value] > 0.0; }

 private:
  std::uint32_t root_of(std::uint32_t body);
  void join(std::uint32_t a, std::uint32_t b);
  void link_near(const Sensors::Scene& scene, std::uint32_t body, double range);

  std::vector<std::uint32_t> parents_;  // towards the lowest of those that are linked; of that one itself
  std::vector<double> losses_;          // by body
  std::vector<std::uint32_t> robots_;   // their numbers, by body
  std::vector<std::uint8_t> silent_;    // by body: it is in a zone without radio, or gone
  std::vector<std::uint32_t> walls_;    // between two of them
  std::uint64_t seed_ = 0;
  std::uint64_t cycle_ = 0;
};

}  // namespace mlab::sim
