#pragma once

#include <cstdint>

#include "mlab/vehicle/device.h"

namespace mlab::mavlink {

/// Puts times of a vehicle, milliseconds since it began, onto our clock: what came fastest was not delayed,
/// and what comes later is that much older.
class BootClock {
 public:
  enum class Verdict : std::uint8_t {
    kGood,
    kLate,      ///< older than what came before: overtaken on its way
    kRestarted  ///< so much older that the vehicle has begun again
  };

  /// @param kind  of message: times of each kind grow by themselves
  Verdict hear(std::uint32_t kind, std::uint32_t boot_ms, vehicle::Clock::time_point now);
  /// Of something that was heard, never later than now.
  vehicle::Clock::time_point time_of(std::uint32_t boot_ms, vehicle::Clock::time_point now) const;
  void begin_anew() { *this = {}; }

 private:
  static constexpr std::uint32_t kKinds = 4;
  bool has_any_ = false;
  std::uint32_t newest_ = 0;
  std::uint32_t last_[kKinds] = {};
  bool has_last_[kKinds] = {};
  vehicle::Clock::time_point began_;  // when it began, by what came fastest
  vehicle::Clock::time_point heard_at_;
};

}  // namespace mlab::mavlink
