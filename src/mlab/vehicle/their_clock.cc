#include "mlab/vehicle/their_clock.h"

#include <algorithm>

namespace mlab::vehicle {
namespace {

using std::chrono::milliseconds;

/// How much two clocks may differ in what a second is: 1 in 1000.
constexpr int kDrift = 1000;

/// Less late than before by more than this is no jitter.
constexpr auto kJitter = milliseconds(30);
constexpr auto kSettlesIn = milliseconds(300);

/// From one moment of their clock to another, which is less than 25 days away.
milliseconds between(std::uint32_t from, std::uint32_t to) {
  return milliseconds(static_cast<std::int32_t>(to - from));
}

}  // namespace

bool TheirClock::hear(std::uint32_t theirs, Clock::time_point arrived) {
  if (!base_.has_value()) {
    base_ = {theirs, arrived};
    caught_up_at_ = arrived;
    return true;
  }
  const milliseconds since = between(base_->theirs, theirs);
  if (since < milliseconds(0)) return false;
  const Clock::time_point latest = base_->ours + since + Clock::duration(since) / kDrift;
  if (latest - arrived > kJitter) caught_up_at_ = arrived;
  base_ = {theirs, std::min(arrived, latest)};
  return true;
}

bool TheirClock::is_settled(Clock::time_point now) const {
  return base_.has_value() && now - caught_up_at_ >= kSettlesIn;
}

Clock::time_point TheirClock::ours(std::uint32_t theirs) const {
  return base_->ours + between(base_->theirs, theirs);
}

std::uint32_t TheirClock::theirs(Clock::time_point ours) const {
  const auto since = std::chrono::duration_cast<milliseconds>(ours - base_->ours);
  return base_->theirs + static_cast<std::uint32_t>(since.count());
}

}  // namespace mlab::vehicle
