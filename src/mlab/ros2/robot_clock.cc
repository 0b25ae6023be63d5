#include "mlab/ros2/robot_clock.h"

#include <chrono>
#include <cstdlib>

namespace mlab::ros2 {
namespace {

using std::chrono::milliseconds;

/// What comes so much out of order was not overtaken: the clock was set.
constexpr std::int64_t kSet = 1000;  // [ms]
/// A stamp may run so far ahead of the time that has gone by, after a pause in which it waited somewhere.
constexpr std::int64_t kAhead = 2000;           // [ms]
constexpr std::int64_t kFarthestStamp = 60000;  // [ms]
constexpr std::uint32_t kNanosPerMilli = 1'000'000;

std::int64_t millis_of(const Stamp& stamp) {
  return std::int64_t{stamp.sec} * 1000 + stamp.nanosec / kNanosPerMilli;
}

bool is_time(const Stamp& stamp) {
  return stamp.sec >= 0 && stamp.nanosec < 1'000'000'000 && stamp != Stamp{};
}

/// Differences count, so what is lost of it does not matter.
std::uint32_t low_bits(std::int64_t millis) {
  return static_cast<std::uint32_t>(millis);
}

}  // namespace

RobotClock::Verdict RobotClock::hear(const Stamp& stamp, Time arrived) {
  if (!is_time(stamp)) return Verdict::kLate;
  const std::int64_t millis = millis_of(stamp);
  Verdict out = Verdict::kGood;
  if (newest_) {
    const std::int64_t since = millis - *newest_;
    const std::int64_t gone = std::chrono::duration_cast<milliseconds>(arrived - heard_at_).count();
    if (since <= 0 && since > -kSet) return Verdict::kLate;
    if (since < 0 || since > gone + kAhead) {
      forget();
      out = Verdict::kRestarted;
    }
  }
  newest_ = millis;
  heard_at_ = arrived;
  clock_.hear(low_bits(millis), arrived);
  return out;
}

void RobotClock::forget() {
  newest_.reset();
  clock_.forget();
}

std::optional<RobotClock::Time> RobotClock::ours(const Stamp& stamp) const {
  if (!newest_ || !is_time(stamp)) return std::nullopt;
  const std::int64_t millis = millis_of(stamp);
  if (std::abs(millis - *newest_) > kFarthestStamp) return std::nullopt;
  return clock_.ours(low_bits(millis));
}

Stamp RobotClock::theirs(Time time) const {
  if (!newest_) return {};
  const auto ahead = static_cast<std::int32_t>(clock_.theirs(time) - low_bits(*newest_));
  const std::int64_t millis = *newest_ + ahead;
  if (millis < 0) return {};
  return {static_cast<std::int32_t>(millis / 1000),
          static_cast<std::uint32_t>(millis % 1000) * kNanosPerMilli};
}

}  // namespace mlab::ros2
