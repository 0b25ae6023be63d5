#pragma once

#include <span>
#include <vector>

#include "mlab/sim/contact.h"
#include "mlab/sim/world.h"

namespace mlab::sim {

/// Where roamers are. It follows from them and the time; kept, so that it is computed once a cycle.
class Roaming {
 public:
  void place(std::span<const Roamer> roamers, double time);
  /// Places them at the end of a cycle. @return their ways since they were placed before
  std::span<const ContactSolver::Passing> move(std::span<const Roamer> roamers, double until);
  /// Stays where it is, with what is in it, until they are placed anew.
  std::span<const MovingDisc> discs() const { return discs_; }

 private:
  std::vector<MovingDisc> discs_;
  std::vector<ContactSolver::Passing> passing_;
};

}  // namespace mlab::sim
