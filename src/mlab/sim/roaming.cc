#include "mlab/sim/roaming.h"

#include <cstddef>

namespace mlab::sim {

void Roaming::place(std::span<const Roamer> roamers, double time) {
  discs_.clear();
  for (const Roamer& roamer : roamers) discs_.push_back(roamer.at(time));
}

std::span<const ContactSolver::Passing> Roaming::move(std::span<const Roamer> roamers, double until) {
  passing_.clear();
  for (std::size_t k = 0; k < discs_.size(); ++k) {
    const geom::Point from = discs_[k].center;
    discs_[k] = roamers[k].at(until);
    passing_.push_back({from, discs_[k].center - from, discs_[k].radius});
  }
  return passing_;
}

}  // namespace mlab::sim
