#pragma once

#include <cstdint>
#include <optional>

#include "mlab/vehicle/device.h"

namespace mlab::mavlink {

/// Puts times of a vehicle, milliseconds since it began, onto our clock: what came fastest was not delayed,
/// and what comes later is that much older. What came fastest counts for five to ten seconds: clocks part.
class BootClock {
 public:
  enum class Verdict : std::uint8_t {
    kGood,
    kLate,      ///< older than what came before: overtaken on its way
    kRestarted  ///< so much older, or for so long, that the vehicle has begun again
  };

  /// @param kind  of message: times of each kind grow by themselves
  Verdict hear(std::uint32_t kind, std::uint32_t boot_ms, vehicle::Clock::time_point now);
  /// When it was so, never later than now; now, where nothing was heard yet.
  vehicle::Clock::time_point time_of(std::uint32_t boot_ms, vehicle::Clock::time_point now) const;
  void begin_anew() { *this = {}; }

 private:
  static constexpr std::uint32_t kKinds = 4;
  bool has_any_ = false;
  std::uint32_t newest_ = 0;
  std::uint32_t last_[kKinds] = {};
  bool has_last_[kKinds] = {};
  std::optional<vehicle::Clock::time_point> late_since_;  // nothing else came since
  // When it began, by what came fastest: in this span of five seconds, and in the one before it.
  vehicle::Clock::time_point began_;
  vehicle::Clock::time_point began_before_;
  vehicle::Clock::time_point span_from_;
};

}  // namespace mlab::mavlink
