#include "mlab/mavlink/line.h"

#include <algorithm>
#include <utility>

#include "mlab/mavlink/ardupilot.h"

namespace mlab::mavlink {
namespace {

constexpr std::chrono::milliseconds kPause{300};

Signatures* pointer_to(std::optional<Signatures>& signatures) {
  return signatures ? &*signatures : nullptr;
}

}  // namespace

Line::Line(std::unique_ptr<vehicle::Stream> stream, std::uint8_t self, const std::optional<Key>& key,
           SigningClock clock)
    : stream_(std::move(stream)),
      signatures_(key ? std::optional<Signatures>(std::in_place, *key) : std::nullopt),
      clock_(clock),
      reader_(pointer_to(signatures_)),
      writer_(self, kComponentGroundStation, pointer_to(signatures_)) {}

std::optional<Frame> Line::next(Time now) {
  for (;;) {
    if (auto frame = reader_.next(clock_())) return frame;
    if (budget_ == 0) return std::nullopt;
    const auto bytes = stream_->read(now);
    if (stream_->openings() != std::exchange(opening_, stream_->openings())) reader_.begin_anew();
    if (bytes.empty()) return std::nullopt;
    // The rest of a frame does not come so late: a begin that was cut off would swallow what comes now.
    if (now - std::exchange(read_at_, now) > kPause) reader_.begin_anew();
    budget_ -= std::min(budget_, bytes.size());
    reader_.feed(bytes);
  }
}

}  // namespace mlab::mavlink
