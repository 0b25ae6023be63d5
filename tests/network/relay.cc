#include "relay.h"

#include <linux/if_packet.h>
#include <sys/socket.h>
#include <sys/timerfd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "address.h"

namespace mlab::network {
namespace {

constexpr std::size_t kEthernetHeader = 14;
constexpr std::size_t kIpHeader = 20;
constexpr std::uint8_t kIgmp = 2;
constexpr int kBurst = 64;  // frames that are taken from one host before the next has its turn
constexpr std::size_t kMaxWaiting = 200'000;  // frames, of all links; then even one without a limit overflows
constexpr std::size_t kLargestFrame = std::size_t{64} * 1024;

bool is_ip(std::span<const std::uint8_t> frame) {
  return frame.size() >= kEthernetHeader + kIpHeader && frame[12] == 0x08 && frame[13] == 0x00 &&
         frame[kEthernetHeader] >> 4 == 4 && frame[kEthernetHeader + 9] != kIgmp;
}

std::uint32_t receiver_of(std::span<const std::uint8_t> frame) {
  std::uint32_t address = 0;
  for (std::size_t i = 0; i < 4; ++i) address = address << 8 | frame[kEthernetHeader + 16 + i];
  return address;
}

}  // namespace

Relay::Relay(std::uint64_t seed)
    : seed_(seed), timer_(::timerfd_create(CLOCK_MONOTONIC, TFD_CLOEXEC | TFD_NONBLOCK)) {
  if (!timer_.is_open()) throw std::system_error(errno, std::generic_category(), "timerfd");
  loop_.add(timer_.number(), [this] {
    std::uint64_t rings = 0;
    if (::read(timer_.number(), &rings, sizeof rings) < 0) return;
    const std::scoped_lock lock(mutex_);
    timer_is_set_for_ = {};
    deliver_due();
  });
}

void Relay::attach(int host, Descriptor wire) {
  detach(host);
  const int number = wire.number();
  {
    const std::scoped_lock lock(mutex_);
    wires_[host] = std::move(wire);
  }
  loop_.add(number, [this, host] { read_from(host); });
}

void Relay::detach(int host) {
  int number = -1;
  {
    const std::scoped_lock lock(mutex_);
    const auto found = wires_.find(host);
    if (found == wires_.end()) return;
    number = found->second.number();
  }
  loop_.remove(number);
  const std::scoped_lock lock(mutex_);
  wires_.erase(host);
  decltype(waiting_) others;
  for (; !waiting_.empty(); waiting_.pop()) {
    if (waiting_.top().to == host)
      ++way(waiting_.top().from, host).counters.cut;
    else
      others.push(waiting_.top());
  }
  waiting_ = std::move(others);
}

void Relay::set(const Link& link) {
  const std::scoped_lock lock(mutex_);
  all_ = link;
  for (auto& [pair, way] : ways_) way.link = link;
}

void Relay::set(int from, int to, const Link& link) {
  const std::scoped_lock lock(mutex_);
  way(from, to).link = link;
}

Link Relay::link(int from, int to) const {
  const std::scoped_lock lock(mutex_);
  const auto found = ways_.find({from, to});
  return found == ways_.end() ? all_ : found->second.link;
}

void Relay::cut(int from, int to, bool is_cut) {
  const std::scoped_lock lock(mutex_);
  way(from, to).is_cut = is_cut;
}

Counters Relay::counters(int from, int to) const {
  const std::scoped_lock lock(mutex_);
  const auto found = ways_.find({from, to});
  return found == ways_.end() ? Counters{} : found->second.counters;
}

Counters Relay::total() const {
  const std::scoped_lock lock(mutex_);
  Counters sum;
  for (const auto& [pair, way] : ways_) sum += way.counters;
  return sum;
}

std::uint64_t Relay::ignored() const {
  const std::scoped_lock lock(mutex_);
  return ignored_;
}

std::uint64_t Relay::overruns(int host) {
  const std::scoped_lock lock(mutex_);
  const auto wire = wires_.find(host);
  tpacket_stats since_last{};
  socklen_t size = sizeof since_last;
  if (wire != wires_.end() &&
      ::getsockopt(wire->second.number(), SOL_PACKET, PACKET_STATISTICS, &since_last, &size) == 0)
    overruns_[host] += since_last.tp_drops;
  return overruns_[host];
}

Relay::Way& Relay::way(int from, int to) {
  return ways_.try_emplace({from, to}, seed_, from, to, all_).first->second;
}

void Relay::read_from(int host) {
  const std::scoped_lock lock(mutex_);
  const auto found = wires_.find(host);
  if (found == wires_.end()) return;
  std::array<std::uint8_t, kLargestFrame>
      frame;  // NOLINT(cppcoreguidelines-pro-type-member-init): read(2) does
  for (int i = 0; i < kBurst; ++i) {
    const ssize_t size = ::read(found->second.number(), frame.data(), frame.size());
    if (size <= 0) break;
    route(host, std::span(frame).first(static_cast<std::size_t>(size)));
  }
  set_timer();
}

void Relay::route(int from, std::span<std::uint8_t> frame) {
  if (!is_ip(frame)) {
    ++ignored_;
    return;
  }
  const Time now = Clock::now();
  const std::uint32_t address = receiver_of(frame);
  if (is_for_all(address)) {
    for (const auto& [to, wire] : wires_) {
      if (to != from) send(from, to, frame, now);
    }
    return;
  }
  const int to = host_with(address);
  if (to == from || (!wires_.contains(to) && !ways_.contains({from, to}))) {
    ++ignored_;
    return;
  }
  send(from, to, frame, now);
}

void Relay::send(int from, int to, std::span<std::uint8_t> frame, Time now) {
  Way& found = way(from, to);
  Counters& counters = found.counters;
  ++counters.sent;
  const Fate fate = found.wire.next(found.link, frame.size(), now);
  if (found.is_cut || !wires_.contains(to)) {
    ++counters.cut;
    return;
  }
  if (fate.end == Fate::End::kLost) {
    ++counters.lost;
    return;
  }
  if (fate.end == Fate::End::kOverflows || waiting_.size() >= kMaxWaiting) {
    ++counters.overflowed;
    return;
  }
  counters.reordered += fate.is_reordered ? 1 : 0;
  counters.duplicated += fate.is_twice ? 1 : 0;
  if (fate.due <= now) {
    deliver(found, to, frame, fate.is_twice);
    return;
  }
  ++counters.delayed;
  waiting_.push({fate.due, order_++, from, to, fate.is_twice, Frame(frame.begin(), frame.end())});
}

void Relay::deliver(Way& way, int to, std::span<std::uint8_t> frame, bool is_twice) {
  const auto wire = wires_.find(to);
  if (way.is_cut || wire == wires_.end()) {
    ++way.counters.cut;
    return;
  }
  // Nobody asks for addresses of hardware here, so senders wrote their own.
  if ((frame[0] & 1U) == 0) std::ranges::copy(hardware_address(to), frame.begin());
  const bool is_taken = ::write(wire->second.number(), frame.data(), frame.size()) >= 0;
  if (is_twice) [[maybe_unused]]
    const ssize_t again = ::write(wire->second.number(), frame.data(), frame.size());
  ++(is_taken ? way.counters.delivered : way.counters.overflowed);
  way.counters.bytes += is_taken ? frame.size() : 0;
}

void Relay::deliver_due() {
  const Time now = Clock::now();
  while (!waiting_.empty() && waiting_.top().due <= now) {
    Waiting next = waiting_.top();
    waiting_.pop();
    deliver(way(next.from, next.to), next.to, next.frame, next.is_twice);
  }
  set_timer();
}

void Relay::set_timer() {
  if (waiting_.empty() || waiting_.top().due == timer_is_set_for_) return;
  timer_is_set_for_ = waiting_.top().due;
  const Duration since_start = timer_is_set_for_.time_since_epoch();
  itimerspec when{};
  when.it_value.tv_sec = since_start / std::chrono::seconds(1);
  when.it_value.tv_nsec = (since_start % std::chrono::seconds(1)).count();
  ::timerfd_settime(timer_.number(), TFD_TIMER_ABSTIME, &when, nullptr);
}

}  // namespace mlab::network
