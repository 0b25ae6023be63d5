#include "mlab/vehicle/mrv2/messages.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <concepts>
#include <limits>

#include "mlab/base/overloaded.h"

namespace mlab::vehicle::mrv2 {
namespace {

constexpr std::uint8_t kIdentity = 'I';
constexpr std::uint8_t kState = 'P';
constexpr std::uint8_t kRanges = 'R';
constexpr std::uint8_t kDrive = 'D';
constexpr std::uint8_t kStop = 'S';
constexpr std::uint8_t kAsk = 'Q';

constexpr double kMilli = 1000.0;       // steps in one m, m/s, s, V
constexpr double kMicro = 1'000'000.0;  // steps in one rad of a heading
constexpr double kPercent = 100.0;
constexpr std::uint16_t kNoEcho = 0xFFFF;
constexpr std::uint16_t kNotFired = 0xFFFE;
constexpr std::uint16_t kFarthest = 0xFFFD;

class Writer {
 public:
  template <std::integral Number>
  void put(Number number) {
    const auto bits = static_cast<std::make_unsigned_t<Number>>(number);
    for (std::size_t i = 0; i < sizeof(Number); ++i)
      bytes_ += static_cast<char>((static_cast<std::uint64_t>(bits) >> (8 * i)) & 0xFFU);
  }
  template <std::integral Number>
  void put(double value, double steps) {
    constexpr auto kLow = static_cast<double>(std::numeric_limits<Number>::min());
    constexpr auto kHigh = static_cast<double>(std::numeric_limits<Number>::max());
    put(static_cast<Number>(std::isnan(value) ? 0.0 : std::clamp(std::round(value * steps), kLow, kHigh)));
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Past the end it gives 0, and says so.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}
  template <std::integral Number>
  Number get() {
    if (bytes_.size() < sizeof(Number)) {
      is_short_ = true;
      return {};
    }
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < sizeof(Number); ++i)
      bits |= static_cast<std::uint64_t>(static_cast<std::uint8_t>(bytes_[i])) << (8 * i);
    bytes_.remove_prefix(sizeof(Number));
    return static_cast<Number>(static_cast<std::make_unsigned_t<Number>>(bits));
  }
  template <std::integral Number>
  double get(double steps) {
    return static_cast<double>(get<Number>()) / steps;
  }
  bool is_done() const { return !is_short_ && bytes_.empty(); }
  std::size_t left() const { return bytes_.size(); }

 private:
  std::string_view bytes_;
  bool is_short_ = false;
};

std::uint16_t distance_bits(float distance) {
  if (std::isnan(distance)) return kNotFired;
  if (std::isinf(distance)) return kNoEcho;
  return static_cast<std::uint16_t>(
      std::clamp(std::round(static_cast<double>(distance) * kMilli), 0.0, static_cast<double>(kFarthest)));
}

float distance_of(std::uint16_t bits) {
  if (bits == kNotFired) return std::numeric_limits<float>::quiet_NaN();
  if (bits == kNoEcho) return std::numeric_limits<float>::infinity();
  return static_cast<float>(bits / kMilli);
}

std::uint8_t write(const Identity& m, Writer& out) {
  out.put(m.boot);
  out.put(static_cast<std::uint8_t>(m.lurches ? 1 : 0));
  out.put<std::uint16_t>(m.radius, kMilli);
  out.put<std::uint16_t>(m.max_speed, kMilli);
  out.put<std::uint16_t>(m.max_turn_rate, kMilli);
  out.put<std::uint16_t>(m.max_acceleration, kMilli);
  out.put<std::uint16_t>(m.watchdog, kMilli);
  out.put(m.sensors);
  out.put<std::uint16_t>(m.range, kMilli);
  out.put<std::uint16_t>(m.nearest, kMilli);
  out.put<std::uint16_t>(m.beam_width, kMilli);
  return kIdentity;
}

std::optional<Message> read_identity(Reader in) {
  Identity m;
  m.boot = in.get<std::uint16_t>();
  m.lurches = in.get<std::uint8_t>() != 0;
  m.radius = in.get<std::uint16_t>(kMilli);
  m.max_speed = in.get<std::uint16_t>(kMilli);
  m.max_turn_rate = in.get<std::uint16_t>(kMilli);
  m.max_acceleration = in.get<std::uint16_t>(kMilli);
  m.watchdog = in.get<std::uint16_t>(kMilli);
  m.sensors = in.get<std::uint8_t>();
  m.range = in.get<std::uint16_t>(kMilli);
  m.nearest = in.get<std::uint16_t>(kMilli);
  m.beam_width = in.get<std::uint16_t>(kMilli);
  const bool is_sense = m.nearest <= m.range;
  if (!in.is_done() || !is_sense) return std::nullopt;
  return m;
}

std::uint8_t write(const State& m, Writer& out) {
  out.put(m.boot);
  out.put(m.time);
  out.put<std::int32_t>(m.pose.position.x, kMilli);
  out.put<std::int32_t>(m.pose.position.y, kMilli);
  out.put<std::int32_t>(m.pose.heading, kMicro);
  out.put<std::int16_t>(m.speed, kMilli);
  out.put<std::int16_t>(m.turn_rate, kMilli);
  out.put(m.flags);
  out.put<std::uint16_t>(m.voltage, kMilli);
  out.put<std::uint8_t>(m.charge, kPercent);
  return kState;
}

std::optional<Message> read_state(Reader in) {
  State m;
  m.boot = in.get<std::uint16_t>();
  m.time = in.get<std::uint32_t>();
  m.pose.position.x = in.get<std::int32_t>(kMilli);
  m.pose.position.y = in.get<std::int32_t>(kMilli);
  m.pose.heading = in.get<std::int32_t>(kMicro);
  m.speed = in.get<std::int16_t>(kMilli);
  m.turn_rate = in.get<std::int16_t>(kMilli);
  m.flags = in.get<std::uint8_t>();
  m.voltage = in.get<std::uint16_t>(kMilli);
  m.charge = in.get<std::uint8_t>(kPercent);
  if (!in.is_done() || m.charge > 1.0) return std::nullopt;
  return m;
}

std::uint8_t write(const Ranges& m, Writer& out) {
  out.put(m.boot);
  out.put(m.time);
  for (const float distance : m.distances) out.put(distance_bits(distance));
  return kRanges;
}

std::optional<Message> read_ranges(Reader in) {
  Ranges m;
  m.boot = in.get<std::uint16_t>();
  m.time = in.get<std::uint32_t>();
  while (in.left() >= sizeof(std::uint16_t)) m.distances.push_back(distance_of(in.get<std::uint16_t>()));
  if (!in.is_done() || m.distances.empty()) return std::nullopt;
  return m;
}

std::uint8_t write(const Drive& m, Writer& out) {
  out.put(m.boot);
  out.put(m.good_until);
  out.put<std::int16_t>(m.speed, kMilli);
  out.put<std::int16_t>(m.turn_rate, kMilli);
  return kDrive;
}

std::optional<Message> read_drive(Reader in) {
  Drive m;
  m.boot = in.get<std::uint16_t>();
  m.good_until = in.get<std::uint32_t>();
  m.speed = in.get<std::int16_t>(kMilli);
  m.turn_rate = in.get<std::int16_t>(kMilli);
  if (!in.is_done()) return std::nullopt;
  return m;
}

}  // namespace

std::string bytes_of(const Message& message) {
  Writer out;
  const std::uint8_t type =
      std::visit(base::Overloaded{[](const Stop&) { return kStop; }, [](const Ask&) { return kAsk; },
                                  [&](const auto& m) { return write(m, out); }},
                 message);
  return bytes_of(Frame{type, out.bytes()});
}

std::optional<Message> message_of(const Frame& frame) {
  const Reader in(frame.payload);
  switch (frame.type) {
    case kIdentity:
      return read_identity(in);
    case kState:
      return read_state(in);
    case kRanges:
      return read_ranges(in);
    case kDrive:
      return read_drive(in);
    case kStop:
      return in.is_done() ? std::optional<Message>(Stop{}) : std::nullopt;
    case kAsk:
      return in.is_done() ? std::optional<Message>(Ask{}) : std::nullopt;
    default:
      return std::nullopt;
  }
}

}  // namespace mlab::vehicle::mrv2
