#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "mlab/base/random.h"
#include "mlab/vehicle/stream.h"
#include "mlab/vehicle/testing/rig.h"

namespace mlab::vehicle {

/// A line on the clock of a test: a serial one of 57,600 bit/s, of which pieces of 1 to 64 bytes are lost, or
/// one that carries datagrams, at once and whole or not at all. All that arrives arrives later; it can be
/// cut, and be opened again half a second after it was mended. What was under way when it was cut is lost.
class TestLine {
 public:
  enum class Kind { kSerial, kDatagrams };
  explicit TestLine(std::uint64_t seed, Kind kind = Kind::kSerial) : random_(seed), kind_(kind) {}

  /// The device's end. Refers to the line, which has to outlive it.
  std::unique_ptr<Stream> device_end();
  /// What has arrived at the vehicle's end.
  std::string read(Clock::time_point now) { return take(to_vehicle_, now); }
  void write(std::string_view bytes, Clock::time_point now) { put(to_device_, bytes, now); }

  void impair(const Impairment& impairment) { impairment_ = impairment; }
  void cut(Cut how);
  void mend(Clock::time_point now);
  void hold_back() { is_held_back_ = true; }
  /// What was held back comes, as fast as the line is.
  void release(Clock::time_point now);
  bool is_cut() const { return state_ != State::kWhole; }

 private:
  class DeviceEnd;
  enum class State { kWhole, kSilent, kGone };
  struct Piece {
    Clock::time_point arrives;
    std::string bytes;
  };
  using Way = std::deque<Piece>;
  void put(Way& way, std::string_view bytes, Clock::time_point now);
  std::string take(Way& way, Clock::time_point now) const;

  Clock::duration time_of(std::size_t bytes) const;

  base::Random random_;
  Kind kind_;
  Impairment impairment_;
  State state_ = State::kWhole;
  Clock::time_point mended_at_;
  bool is_held_back_ = false;
  Way to_vehicle_;
  Way to_device_;
};

}  // namespace mlab::vehicle
