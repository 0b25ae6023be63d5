#pragma once

#include <cstddef>
#include <cstdint>
#include <expected>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "mlab/mcap/decode.h"
#include "mlab/mcap/limits.h"

/// For sources of this module only.
namespace mlab::mcap {

/// Bytes that are not set to 0 before they are written, and never fewer than they were.
class Room {
 public:
  std::span<std::byte> of(std::size_t size);
  std::size_t capacity() const { return capacity_; }

 private:
  std::unique_ptr<std::byte[]> bytes_;
  std::size_t capacity_ = 0;
};

/// A compressor; keeps its memory from one chunk to the next.
class Compressor {
 public:
  explicit Compressor(int level);
  ~Compressor();
  Compressor(const Compressor&) = delete;
  Compressor& operator=(const Compressor&) = delete;

  /// Valid until the next call.
  std::span<const std::byte> compressed(std::span<const std::byte> bytes);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The records of a chunk: uncompressed, as many as it says, with the right checksum. Valid as long as the
/// chunk's bytes and the room.
/// @errors  a sentence without a place: `chunk compressed by `lz4`, and this program reads ...`
std::expected<std::span<const std::byte>, std::string> records_of(const ChunkRecord& chunk,
                                                                  const Limits& limits, Room& room);

}  // namespace mlab::mcap
