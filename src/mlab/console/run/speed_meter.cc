#include "mlab/console/run/speed_meter.h"

namespace mlab::console {

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
