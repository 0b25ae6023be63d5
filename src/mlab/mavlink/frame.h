#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mlab/mavlink/messages.h"
#include "mlab/mavlink/signing.h"
#include "mlab/mavlink/wire.h"

namespace mlab::mavlink {

/// A message as it came, with the right checksum.
struct Frame {
  std::uint8_t sequence = 0;
  std::uint8_t system = 0;
  std::uint8_t component = 0;
  std::uint32_t id = 0;  ///< one of `Messages`
  bool is_signed = false;
  std::span<const std::byte> payload;  ///< valid until its reader is called again

  template <class Message>
  bool is() const {
    return id == Message::kInfo.id;
  }
  template <class Message>
  Message as() const {
    return read_payload<Message>(payload);
  }
};

/// What came beside good frames.
struct Refusals {
  std::uint64_t skipped_bytes = 0;
  std::uint64_t unknown = 0;          ///< messages that are none of ours; their checksums can't be told
  std::uint64_t wrong_checksums = 0;  ///< or what only looked like a frame's begin
  std::uint64_t version_1 = 0;        ///< good frames of MAVLink 1
  std::uint64_t not_signed = 0;
  std::uint64_t wrong_signatures = 0;
  std::uint64_t replayed = 0;
};

/// Frames of MAVLink 2 out of any bytes, in any pieces. What is no frame is skipped, byte by byte, up to
/// where the next one begins.
class FrameReader {
 public:
  /// @param signatures  nothing but what was signed is accepted; null: it is not looked at. Outlives the
  /// reader.
  explicit FrameReader(Signatures* signatures = nullptr) : signatures_(signatures) {}

  /// What came next. All of it is kept: who feeds it takes out what is whole before he feeds more.
  void feed(std::span<const std::byte> bytes);
  /// The next frame; nothing: there is no whole one yet.
  /// @param now  for signatures
  std::optional<Frame> next(SigningTime now = 0);
  /// What came so far is no begin of what comes.
  void begin_anew();
  const Refusals& refusals() const { return refusals_; }

 private:
  enum class Step : std::uint8_t { kFrame, kSkipped, kWait };

  Step step(SigningTime now, Frame& out);
  Step step_version_1();
  Step skip(std::size_t bytes);
  bool is_accepted(std::span<const std::byte> frame, const Frame& head, SigningTime now);

  Signatures* signatures_;
  std::vector<std::byte> bytes_;
  std::size_t at_ = 0;
  Refusals refusals_;
};

/// Messages of one component as frames, numbered, and signed where there is a key.
class FrameWriter {
 public:
  /// @param signatures  null: nothing is signed. Outlives the writer.
  FrameWriter(std::uint8_t system, std::uint8_t component, Signatures* signatures = nullptr,
              std::uint8_t link = 0)
      : system_(system), component_(component), link_(link), signatures_(signatures) {}

  /// Valid until the next call.
  template <class Message>
  std::span<const std::byte> write(const Message& message, SigningTime now = 0) {
    begin(Message::kInfo.id);
    write_payload(message, bytes_);
    return end(Message::kInfo.extra, now);
  }

 private:
  void begin(std::uint32_t id);
  std::span<const std::byte> end(std::uint8_t extra, SigningTime now);

  std::uint8_t system_;
  std::uint8_t component_;
  std::uint8_t link_;
  std::uint8_t sequence_ = 0;
  Signatures* signatures_;
  std::vector<std::byte> bytes_;
};

/// CRC-16/MCRF4XX, as frames have it: over all but their first byte, then CRC_EXTRA.
std::uint16_t checksum(std::span<const std::byte> bytes, std::uint8_t extra);

}  // namespace mlab::mavlink
