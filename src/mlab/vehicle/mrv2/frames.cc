#include "mlab/vehicle/mrv2/frames.h"

#include "mlab/vehicle/checksum.h"

namespace mlab::vehicle::mrv2 {
namespace {

constexpr std::string_view kBegin = "\xA5\x5A";
constexpr std::size_t kHead = 4;
constexpr std::size_t kTail = 2;

std::uint8_t byte_at(std::string_view bytes, std::size_t place) {
  return static_cast<std::uint8_t>(bytes[place]);
}

}  // namespace

std::string bytes_of(const Frame& frame) {
  const std::string_view payload = frame.payload.substr(0, kLongestPayload);
  std::string bytes(kBegin);
  bytes += static_cast<char>(frame.type);
  bytes += static_cast<char>(payload.size());
  bytes += payload;
  const std::uint16_t sum = checksum_of(std::string_view(bytes).substr(kBegin.size()));
  bytes += static_cast<char>(sum & 0xFFU);
  bytes += static_cast<char>(sum >> 8U);
  return bytes;
}

void FrameReader::add(std::string_view bytes) {
  bytes_.erase(0, read_);
  read_ = 0;
  bytes_ += bytes;
}

std::optional<Frame> FrameReader::next() {
  while (true) {
    const std::string_view rest = std::string_view(bytes_).substr(read_);
    const std::size_t begin = rest.find(kBegin);
    if (begin == std::string_view::npos) {
      // The last byte may be the first one of a begin.
      read_ = bytes_.size() - (rest.ends_with(kBegin[0]) ? 1 : 0);
      return std::nullopt;
    }
    read_ += begin;
    const std::string_view from_begin = rest.substr(begin);
    if (from_begin.size() < kHead) return std::nullopt;
    const std::size_t length = byte_at(from_begin, 3);
    const std::size_t whole = kHead + length + kTail;
    if (from_begin.size() < whole) return std::nullopt;
    const std::uint16_t sum = checksum_of(from_begin.substr(kBegin.size(), 2 + length));
    const auto told =
        static_cast<std::uint16_t>(byte_at(from_begin, whole - 2) | (byte_at(from_begin, whole - 1) << 8));
    if (sum != told) {
      ++read_;  // what looked like a begin was none
      continue;
    }
    read_ += whole;
    return Frame{byte_at(from_begin, 2), from_begin.substr(kHead, length)};
  }
}

void FrameReader::begin_anew() {
  bytes_.clear();
  read_ = 0;
}

}  // namespace mlab::vehicle::mrv2
