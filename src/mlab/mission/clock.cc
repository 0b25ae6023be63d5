#include "mlab/mission/clock.h"

#include <fmt/format.h>

#include <cmath>

namespace mlab::mission {
namespace {

constexpr double kDay = 86400.0;

// Seconds since 1970-01-01 00:00 that the mission clock shows at run time 0, in its own time zone.
double local_start(const ExecutiveOptions& options) {
  return options.epoch_seconds + options.zone_offset;
}

}  // namespace

double run_time_of(const MissionTime& time, const ExecutiveOptions& options, double reached) {
  const double start = local_start(options);
  switch (time.kind) {
    case MissionTime::Kind::kSinceReached:
      return reached + time.seconds;
    case MissionTime::Kind::kSinceStart:
      return time.seconds;
    case MissionTime::Kind::kOfDay:
      return std::floor(start / kDay) * kDay + time.seconds - start;
    case MissionTime::Kind::kAbsolute:
      return time.seconds - start;
  }
  return reached;
}

std::string clock_text(double run_time, const ExecutiveOptions& options) {
  const double local = std::round(local_start(options) + run_time);
  if (!std::isfinite(local)) return "an unknown time";
  const double of_day = local - std::floor(local / kDay) * kDay;
  const int seconds = static_cast<int>(of_day);
  return fmt::format("{:02}:{:02}:{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60);
}

}  // namespace mlab::mission
