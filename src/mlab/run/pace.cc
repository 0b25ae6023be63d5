#include "mlab/run/pace.h"

#include <algorithm>

namespace mlab::run {

void Pace::set_speed(double speed, double wall, double sim) {
  speed_ = speed > 0.0 ? std::clamp(speed, kSlowest, kFastest) : 0.0;
  start(wall, sim);
}

void Pace::start(double wall, double sim) {
  wall_ = wall;
  sim_ = sim;
}

double Pace::due(double sim) const {
  return speed_ > 0.0 ? wall_ + (sim - sim_) / speed_ : wall_;
}

double Pace::behind(double wall, double sim) const {
  return speed_ > 0.0 ? std::max(0.0, wall - due(sim)) : 0.0;
}

void Pace::forgive(double wall, double sim) {
  if (behind(wall, sim) > kMostBehind) start(wall - kMostBehind, sim);
}

void Pace::forgive_all(double wall, double sim, double most) {
  if (behind(wall, sim) > most) start(wall, sim);
}

}  // namespace mlab::run
