#pragma once

#include <memory>
#include <optional>

#include "mlab/mavlink/frame.h"
#include "mlab/vehicle/stream.h"

namespace mlab::mavlink {

/// Messages over a stream, to one vehicle and from it.
class Line {
 public:
  using Time = vehicle::Clock::time_point;
  using SigningClock = SigningTime (*)();

  /// @param self  our number as a system
  /// @param key   all is signed with it, and nothing else is accepted; nothing: it is not looked at
  /// @param clock  for signatures
  Line(std::unique_ptr<vehicle::Stream> stream, std::uint8_t self, const std::optional<Key>& key,
       SigningClock clock);

  template <class Message>
  void send(const Message& message, Time now) {
    stream_->write(writer_.write(message, clock_()), now);
  }
  /// Sends what is for one system: its fields `target_system` and `target_component` say so.
  template <class Message>
  void send_to(std::uint8_t system, Message message, Time now) {
    message.target_system = system;
    message.target_component = 1;
    send(message, now);
  }

  /// The next frame of what came; nothing: there is no more for now, or this was enough for one `work`.
  std::optional<Frame> next(Time now);
  /// To be called before frames are taken: so many bytes are read until it is called again.
  void begin_reading() { budget_ = kMostBytes; }

  vehicle::Stream& stream() { return *stream_; }
  const vehicle::Stream& stream() const { return *stream_; }
  const Refusals& refusals() const { return reader_.refusals(); }

 private:
  // Ten times of what a fast radio carries in 50 ms; whoever sends more does not get all of our time.
  static constexpr std::size_t kMostBytes = 65536;

  std::unique_ptr<vehicle::Stream> stream_;
  std::optional<Signatures> signatures_;
  SigningClock clock_;
  FrameReader reader_;
  FrameWriter writer_;
  std::uint64_t opening_ = 0;
  Time read_at_;
  std::size_t budget_ = 0;
};

}  // namespace mlab::mavlink
