#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace mlab::lsp {

/// Cuts a stream of bytes into messages: header lines, an empty line, as many bytes as `Content-Length` says.
class MessageReader {
 public:
  /// A longer message is skipped; texts have at most 64 MiB.
  static constexpr std::size_t kMostBytes = std::size_t{256} << 20;
  /// A longer header is no header.
  static constexpr std::size_t kMostHeaderBytes = 8192;

  void add(std::string_view bytes) { buffer_ += bytes; }

  struct Message {
    std::string body;
    /// What is wrong with the frame, then there is no body: `no Content-Length`, ...
    std::string error;
  };
  /// The next whole message, or what is wrong with the next frame; nothing where more bytes are needed.
  std::optional<Message> next();

 private:
  std::string buffer_;
  std::size_t skip_ = 0;  ///< bytes of a message that is too long
};

/// The frame around a message.
std::string framed(std::string_view body);

}  // namespace mlab::lsp
