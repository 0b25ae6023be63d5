#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <google/protobuf/message_lite.h>

namespace mlab::robot_wire {

/// Version of proto/mlab/robot.proto; programs of another one are not understood.
inline constexpr std::uint32_t kProtocol = 1;
/// A longer message is nonsense [bytes].
inline constexpr std::size_t kMaxMessage = std::size_t{64} << 20;
/// A robot's values may take up so much, so that they fit into a message with all that goes with them
/// [bytes].
inline constexpr std::size_t kMaxFrame = kMaxMessage / 2;

/// Appends the message with its length in front, as it travels.
void append_framed(const google::protobuf::MessageLite& message, std::string& out);

/// Cuts a stream of bytes into messages.
class FrameReader {
 public:
  /// Where the next bytes go, at least `least` of them; `advance` says how many came.
  std::span<char> room(std::size_t least = std::size_t{16} << 10);
  void advance(std::size_t count) { end_ += count; }

  /// The next whole message; nothing where more bytes are needed. Valid until `room` is called.
  std::optional<std::string_view> next();
  /// The stream names a length that no message has: it is none of ours, and nothing more comes out of it.
  bool is_nonsense() const { return is_nonsense_; }
  /// Nothing has begun that is not whole yet.
  bool is_empty() const { return begin_ == end_; }

 private:
  std::vector<char> bytes_;
  std::size_t begin_ = 0;  // of what was not taken yet
  std::size_t end_ = 0;
  bool is_nonsense_ = false;
};

}  // namespace mlab::robot_wire
