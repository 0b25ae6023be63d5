#include "mlab/mavlink/boot_clock.h"

#include <algorithm>

namespace mlab::mavlink {
namespace {

using std::chrono::milliseconds;

// A link does not delay one message by so much more than another.
constexpr std::uint32_t kOvertakenBy = 5000;
// Two clocks part by less than a part in a thousand, so the fastest message is forgotten so slowly.
constexpr std::int64_t kPartsPerDrift = 1000;

}  // namespace

BootClock::Verdict BootClock::hear(std::uint32_t kind, std::uint32_t boot_ms,
                                   vehicle::Clock::time_point now) {
  const std::size_t i = std::min(kind, kKinds - 1);
  if (has_any_ && boot_ms < newest_ && newest_ - boot_ms > kOvertakenBy) return Verdict::kRestarted;
  if (has_last_[i] && boot_ms < last_[i]) return Verdict::kLate;
  const auto began = now - milliseconds(boot_ms);
  if (has_any_) began_ += (now - heard_at_) / kPartsPerDrift;
  began_ = has_any_ ? std::min(began_, began) : began;
  heard_at_ = now;
  newest_ = has_any_ ? std::max(newest_, boot_ms) : boot_ms;
  has_any_ = true;
  last_[i] = boot_ms;
  has_last_[i] = true;
  return Verdict::kGood;
}

vehicle::Clock::time_point BootClock::time_of(std::uint32_t boot_ms, vehicle::Clock::time_point now) const {
  return std::min(began_ + milliseconds(boot_ms), now);
}

}  // namespace mlab::mavlink
