#include "link.h"

#include <fmt/format.h>

#include <algorithm>

#include "mlab/base/random.h"

namespace mlab::network {
namespace {

Duration seconds(double value) {
  return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(value));
}

}  // namespace

Counters& Counters::operator+=(const Counters& other) {
  sent += other.sent;
  delivered += other.delivered;
  lost += other.lost;
  cut += other.cut;
  overflowed += other.overflowed;
  delayed += other.delayed;
  reordered += other.reordered;
  duplicated += other.duplicated;
  bytes += other.bytes;
  return *this;
}

std::string Counters::words() const {
  return fmt::format(
      "{} packets: {} delivered ({} bytes), {} lost, {} cut, {} overflowed; {} delayed, {} reordered, {} "
      "duplicated",
      sent, delivered, bytes, lost, cut, overflowed, delayed, reordered, duplicated);
}

Wire::Wire(std::uint64_t seed, int from, int to) : seed_(seed), from_(from), to_(to) {}

Fate Wire::next(const Link& link, std::size_t bytes, Time now) {
  // As many numbers for each packet, whatever is set, so that none changes what becomes of the next.
  auto random =
      base::Random::of(seed_, static_cast<std::uint64_t>(from_), static_cast<std::uint64_t>(to_), count_++);
  const double loss = random.uniform();
  const double jitter = random.uniform(-1.0, 1.0);
  const double reordering = random.uniform();
  const double duplication = random.uniform();
  Fate fate;
  Time leaves = now;
  if (link.bits_per_second > 0.0) {
    const Time begins = std::max(now, free_at_);
    const double waiting = std::chrono::duration<double>(begins - now).count() * link.bits_per_second / 8.0;
    if (waiting + static_cast<double>(bytes) > static_cast<double>(link.queue_bytes)) {
      fate.end = Fate::End::kOverflows;
      return fate;
    }
    leaves = free_at_ = begins + seconds(static_cast<double>(bytes) * 8.0 / link.bits_per_second);
  }
  if (loss < link.loss) {
    fate.end = Fate::End::kLost;
    return fate;
  }
  const double varied = std::chrono::duration<double>(link.jitter).count() * jitter;
  fate.due = leaves + std::max(link.delay + seconds(varied), Duration(0));
  fate.is_reordered = reordering < link.reordering;
  if (fate.is_reordered) {
    fate.due = std::max(fate.due, last_due_) + link.held_back;
  } else {
    fate.due = last_due_ = std::max(fate.due, last_due_);
  }
  fate.is_twice = duplication < link.duplication;
  return fate;
}

}  // namespace mlab::network
