#include "mlab/mcap/chunk_bytes.h"

#include <cstdlib>

#include <fmt/core.h>
#include <zstd.h>

#include "mlab/text/shown.h"

namespace mlab::mcap {
namespace {

// zstd gives at most so many bytes for one of its own: a block of 128 KiB takes at least four.
constexpr std::uint64_t kMostGain = std::uint64_t{128} << 10;

}  // namespace

std::span<std::byte> Room::of(std::size_t size) {
  if (size > capacity_) {
    bytes_.reset();
    bytes_ = std::make_unique_for_overwrite<std::byte[]>(size);
    capacity_ = size;
  }
  return {bytes_.get(), size};
}

struct Compressor::State {
  ZSTD_CCtx* context = ZSTD_createCCtx();
  Room room;
};

Compressor::Compressor(int level) : state_(std::make_unique<State>()) {
  if (state_->context == nullptr) std::abort();  // no memory
  ZSTD_CCtx_setParameter(state_->context, ZSTD_c_compressionLevel, level);
}

Compressor::~Compressor() {
  ZSTD_freeCCtx(state_->context);
}

std::span<const std::byte> Compressor::compressed(std::span<const std::byte> bytes) {
  const std::span<std::byte> to = state_->room.of(ZSTD_compressBound(bytes.size()));
  const std::size_t size = ZSTD_compress2(state_->context, to.data(), to.size(), bytes.data(), bytes.size());
  if (ZSTD_isError(size) != 0) std::abort();  // no memory: there is room for whatever comes out
  return to.first(size);
}

std::expected<std::span<const std::byte>, std::string> records_of(const ChunkRecord& chunk,
                                                                  const Limits& limits, Room& room) {
  const ChunkHead& head = chunk.head;
  if (head.uncompressed_size > limits.chunk_bytes)
    return std::unexpected(fmt::format("a chunk of {} bytes, where {} are the most that is read",
                                       head.uncompressed_size, limits.chunk_bytes));
  std::span<const std::byte> records = chunk.records;
  if (head.compression == "zstd") {
    if (head.uncompressed_size / kMostGain > chunk.records.size())
      return std::unexpected(fmt::format("a chunk that says it has {} bytes, which never come out of {}",
                                         head.uncompressed_size, chunk.records.size()));
    const std::span<std::byte> to = room.of(static_cast<std::size_t>(head.uncompressed_size));
    // It never writes past its room, so whatever else would come out is an error, not memory.
    const std::size_t size =
        ZSTD_decompress(to.data(), to.size(), chunk.records.data(), chunk.records.size());
    if (ZSTD_isError(size) != 0)
      return std::unexpected(
          fmt::format("a chunk that can't be decompressed by zstd: {}", ZSTD_getErrorName(size)));
    records = to.first(size);
  } else if (!head.compression.empty()) {
    return std::unexpected(
        fmt::format("a chunk compressed by `{}`, and this program reads `zstd` and uncompressed ones",
                    text::shown(head.compression)));
  }
  if (records.size() != head.uncompressed_size)
    return std::unexpected(fmt::format("a chunk that says it has {} bytes uncompressed, and has {}",
                                       head.uncompressed_size, records.size()));
  if (head.crc == 0 || crc32(records) == head.crc) return records;
  return std::unexpected("a chunk whose checksum differs: it was changed, or written in part");
}

}  // namespace mlab::mcap
