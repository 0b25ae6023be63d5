#include "mlab/mavlink/boot_clock.h"

#include <algorithm>

namespace mlab::mavlink {
namespace {

using std::chrono::milliseconds;

// A link does not delay one message by so much more than another.
constexpr std::uint32_t kOvertakenBy = 5000;
constexpr milliseconds kSpan{5000};
// One kind of message does not come by so much later than another, as long as the vehicle is the same.
constexpr std::uint32_t kApart = 500;
// For longer than this not everything is overtaken.
constexpr milliseconds kOvertakingLasts{500};

}  // namespace

BootClock::Verdict BootClock::hear(std::uint32_t kind, std::uint32_t boot_ms,
                                   vehicle::Clock::time_point now) {
  const std::size_t i = std::min(kind, kKinds - 1);
  if (has_any_ && boot_ms < newest_ && newest_ - boot_ms > kOvertakenBy) return Verdict::kRestarted;
  const bool is_late = has_any_ && boot_ms + kApart < newest_;
  if (is_late || (has_last_[i] && boot_ms < last_[i])) {
    if (!late_since_) late_since_ = now;
    return now - *late_since_ > kOvertakingLasts ? Verdict::kRestarted : Verdict::kLate;
  }
  late_since_.reset();
  const auto began = now - milliseconds(boot_ms);
  if (!has_any_ || now - span_from_ >= kSpan) {
    began_before_ = has_any_ && now - span_from_ < 2 * kSpan ? began_ : began;
    began_ = began;
    span_from_ = now;
  }
  began_ = std::min(began_, began);
  newest_ = has_any_ ? std::max(newest_, boot_ms) : boot_ms;
  has_any_ = true;
  last_[i] = boot_ms;
  has_last_[i] = true;
  return Verdict::kGood;
}

vehicle::Clock::time_point BootClock::time_of(std::uint32_t boot_ms, vehicle::Clock::time_point now) const {
  return has_any_ ? std::min(std::min(began_, began_before_) + milliseconds(boot_ms), now) : now;
}

}  // namespace mlab::mavlink
