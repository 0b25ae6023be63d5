#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace mlab::vehicle::mrv2 {

/// What goes over the line at once: A5 5A, type, length, as many bytes, and a checksum of type, length and
/// bytes (CRC-16/CCITT, begun with FFFF), low byte first.
struct Frame {
  std::uint8_t type = 0;
  std::string_view payload;  ///< at most kLongestPayload bytes
};

inline constexpr std::size_t kLongestPayload = 255;

/// @param frame  of its payload what is beyond kLongestPayload bytes is left out
std::string bytes_of(const Frame& frame);

/// Finds frames in bytes as they come. Whatever comes, it goes on with the next whole frame; bytes that
/// belong to none are left out.
class FrameReader {
 public:
  void add(std::string_view bytes);
  /// The next whole frame. Valid until the next call.
  std::optional<Frame> next();
  /// What has come so far is no begin of what comes.
  void begin_anew();

 private:
  std::string bytes_;
  std::size_t read_ = 0;  // of bytes_
};

}  // namespace mlab::vehicle::mrv2
