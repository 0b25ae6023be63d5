#include "mlab/console/run/pace.h"

#include <algorithm>

namespace mlab::console {

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

void SpeedMeter::note(double wall, double sim) {
  constexpr double kWindow = 1.0;
  constexpr double kApart = 0.01;
  if (!samples_.empty() && sim < samples_.back().sim) samples_.clear();  // the run began anew
  if (!samples_.empty() && wall - samples_.back().wall < kApart) return;
  samples_.push_back({wall, sim});
  while (samples_.size() > 2 && samples_[1].wall <= wall - kWindow) samples_.pop_front();
}

double SpeedMeter::speed(double wall) const {
  constexpr double kStandsAfter = 0.5;
  if (samples_.size() < 2 || wall - samples_.back().wall > kStandsAfter) return 0.0;
  const double passed = samples_.back().wall - samples_.front().wall;
  return passed > 0.0 ? (samples_.back().sim - samples_.front().sim) / passed : 0.0;
}

}  // namespace mlab::console
