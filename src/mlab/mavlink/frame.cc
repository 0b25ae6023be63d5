#include "mlab/mavlink/frame.h"

namespace mlab::mavlink {
namespace {

constexpr std::byte kMagic{0xfd};
constexpr std::byte kMagic1{0xfe};
constexpr std::size_t kHead = 10;
constexpr std::size_t kHead1 = 6;
constexpr std::size_t kCrc = 2;
constexpr std::uint8_t kSigned = 1;

std::uint16_t accumulate(std::uint16_t crc, std::byte byte) {
  auto low = static_cast<std::uint8_t>(static_cast<std::uint8_t>(byte) ^ (crc & 0xffU));
  low = static_cast<std::uint8_t>(low ^ (low << 4U));
  return static_cast<std::uint16_t>((crc >> 8U) ^ (low << 8U) ^ (low << 3U) ^ (low >> 4U));
}

std::uint8_t number_at(std::span<const std::byte> bytes, std::size_t at) {
  return static_cast<std::uint8_t>(bytes[at]);
}

bool has_checksum(std::span<const std::byte> frame, std::uint8_t extra) {
  const std::uint16_t crc = checksum(frame.subspan(1, frame.size() - 1 - kCrc), extra);
  return number_at(frame, frame.size() - 2) == (crc & 0xffU) &&
         number_at(frame, frame.size() - 1) == crc >> 8U;
}

}  // namespace

std::uint16_t checksum(std::span<const std::byte> bytes, std::uint8_t extra) {
  std::uint16_t crc = 0xffff;
  for (const std::byte one : bytes) crc = accumulate(crc, one);
  return accumulate(crc, static_cast<std::byte>(extra));
}

void FrameReader::feed(std::span<const std::byte> bytes) {
  bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(at_));
  at_ = 0;
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
}

void FrameReader::begin_anew() {
  bytes_.clear();
  at_ = 0;
}

std::optional<Frame> FrameReader::next(SigningTime now) {
  Frame out;
  while (at_ < bytes_.size()) {
    const Step step = this->step(now, out);
    if (step == Step::kFrame) return out;
    if (step == Step::kWait) break;
  }
  return std::nullopt;
}

FrameReader::Step FrameReader::skip(std::size_t bytes) {
  at_ += bytes;
  refusals_.skipped_bytes += bytes;
  return Step::kSkipped;
}

FrameReader::Step FrameReader::step(SigningTime now, Frame& out) {
  const std::span<const std::byte> rest = std::span(bytes_).subspan(at_);
  if (rest[0] == kMagic1) return step_version_1();
  if (rest[0] != kMagic) return skip(1);
  if (rest.size() < kHead) return Step::kWait;
  const std::uint8_t incompatible = number_at(rest, 2);
  // What asks for more than signatures can't be understood; most likely it is no begin of a frame.
  if ((incompatible & ~kSigned) != 0) return skip(1);
  out.is_signed = (incompatible & kSigned) != 0;
  out.sequence = number_at(rest, 4);
  out.system = number_at(rest, 5);
  out.component = number_at(rest, 6);
  out.id =
      number_at(rest, 7) | number_at(rest, 8) << 8U | static_cast<std::uint32_t>(number_at(rest, 9)) << 16U;
  const std::size_t size = kHead + number_at(rest, 1) + kCrc;
  const std::size_t whole = size + (out.is_signed ? Signature::kSize : 0);
  if (rest.size() < whole) return Step::kWait;
  const auto extra = extra_of(out.id);
  if (!extra) {
    // A message of others ends where another one begins, or where nothing has come yet.
    const bool is_frame = rest.size() == whole || rest[whole] == kMagic || rest[whole] == kMagic1;
    if (!is_frame) return skip(1);
    ++refusals_.unknown;
    at_ += whole;
    return Step::kSkipped;
  }
  if (!has_checksum(rest.first(size), *extra)) {
    ++refusals_.wrong_checksums;
    return skip(1);
  }
  if (!is_accepted(rest.first(whole), out, now)) return skip(whole);
  out.payload = rest.subspan(kHead, size - kHead - kCrc);
  at_ += whole;
  return Step::kFrame;
}

FrameReader::Step FrameReader::step_version_1() {
  const std::span<const std::byte> rest = std::span(bytes_).subspan(at_);
  if (rest.size() < kHead1) return Step::kWait;
  const auto extra = extra_of(number_at(rest, 5));
  if (!extra) return skip(1);
  const std::size_t whole = kHead1 + number_at(rest, 1) + kCrc;
  if (rest.size() < whole) return Step::kWait;
  if (!has_checksum(rest.first(whole), *extra)) return skip(1);
  ++refusals_.version_1;
  return skip(whole);
}

bool FrameReader::is_accepted(std::span<const std::byte> frame, const Frame& head, SigningTime now) {
  if (signatures_ == nullptr) return true;
  if (!head.is_signed) {
    ++refusals_.not_signed;
    return false;
  }
  const std::size_t size = frame.size() - Signature::kSize;
  switch (signatures_->judge(frame.first(size), head.system, head.component,
                             Signature::read(frame.subspan(size)), now)) {
    case Signatures::Verdict::kGood:
      return true;
    case Signatures::Verdict::kWrong:
      ++refusals_.wrong_signatures;
      return false;
    case Signatures::Verdict::kReplayed:
      ++refusals_.replayed;
      return false;
  }
  return false;
}

void FrameWriter::begin(std::uint32_t id) {
  bytes_.clear();
  for (const std::uint32_t one :
       {0xfdU, 0U, signatures_ == nullptr ? 0U : kSigned, 0U, static_cast<unsigned>(sequence_),
        static_cast<unsigned>(system_), static_cast<unsigned>(component_), id, id >> 8U, id >> 16U})
    bytes_.push_back(static_cast<std::byte>(one & 0xffU));
  ++sequence_;
}

std::span<const std::byte> FrameWriter::end(std::uint8_t extra, SigningTime now) {
  bytes_[1] = static_cast<std::byte>(bytes_.size() - kHead);
  wire::put(bytes_, checksum(std::span(bytes_).subspan(1), extra));
  if (signatures_ != nullptr) {
    const auto signature = sign(signatures_->key(), bytes_, link_, signatures_->next_time(now)).bytes();
    bytes_.insert(bytes_.end(), signature.begin(), signature.end());
  }
  return bytes_;
}

}  // namespace mlab::mavlink
