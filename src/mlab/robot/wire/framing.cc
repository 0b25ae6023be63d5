#include "mlab/robot/wire/framing.h"

#include <cstring>

namespace mlab::robot_wire {
namespace {

constexpr std::size_t kHead = 4;

}  // namespace

void append_framed(const google::protobuf::MessageLite& message, std::string& out) {
  const std::size_t size = message.ByteSizeLong();
  const std::size_t at = out.size();
  out.resize(at + kHead + size);
  for (std::size_t i = 0; i < kHead; ++i) out[at + i] = static_cast<char>(size >> (8 * i) & 0xFFU);
  message.SerializeWithCachedSizesToArray(reinterpret_cast<std::uint8_t*>(out.data() + at + kHead));
}

std::span<char> FrameReader::room(std::size_t least) {
  if (begin_ > 0) {
    std::memmove(bytes_.data(), bytes_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
  }
  if (bytes_.size() < end_ + least) bytes_.resize(end_ + least);
  return std::span(bytes_).subspan(end_);
}

std::optional<std::string_view> FrameReader::next() {
  if (is_nonsense_ || end_ - begin_ < kHead) return std::nullopt;
  std::size_t size = 0;
  for (std::size_t i = 0; i < kHead; ++i)
    size |= static_cast<std::size_t>(static_cast<unsigned char>(bytes_[begin_ + i])) << (8 * i);
  if (size > kMaxMessage) {
    is_nonsense_ = true;
    return std::nullopt;
  }
  if (end_ - begin_ - kHead < size) return std::nullopt;
  const std::string_view message(bytes_.data() + begin_ + kHead, size);
  begin_ += kHead + size;
  return message;
}

}  // namespace mlab::robot_wire
