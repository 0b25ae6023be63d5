#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "mlab/mcap/records.h"

/// Records as bytes. For sources of this module only.
namespace mlab::mcap {

using Buffer = std::vector<std::byte>;

/// Opcode and length, in front of each record [bytes].
inline constexpr std::size_t kRecordHead = 9;
/// In front of the data in the content of a message [bytes].
inline constexpr std::size_t kMessageHead = 22;
/// The footer with its head [bytes].
inline constexpr std::size_t kFooterLength = kRecordHead + 20;

/// A message of a chunk: when it was logged, and where its record begins in the uncompressed chunk.
struct IndexEntry {
  std::uint64_t log_time = 0;
  std::uint64_t offset = 0;
};

/// What stands in front of the records in a chunk.
struct ChunkHead {
  std::uint64_t start_time = 0;
  std::uint64_t end_time = 0;
  std::uint64_t uncompressed_size = 0;
  std::uint32_t crc = 0;  ///< of the uncompressed records; 0: not said
  std::string_view compression;
};

/// What stands in the footer.
struct Footer {
  std::uint64_t summary_start = 0;
  std::uint64_t summary_offset_start = 0;
  std::uint32_t summary_crc = 0;
};

/// Goes on from the value for the bytes before.
std::uint32_t crc32(std::span<const std::byte> bytes, std::uint32_t before = 0);

void append_magic(Buffer& out);
void append(Buffer& out, const Header& header);
void append(Buffer& out, const Schema& schema);
void append(Buffer& out, const Channel& channel);
void append(Buffer& out, const Message& message);
void append(Buffer& out, const Attachment& attachment);
void append(Buffer& out, const Metadata& metadata);
void append(Buffer& out, const ChunkHead& head, std::span<const std::byte> records);
void append_message_index(Buffer& out, ChannelId channel, std::span<const IndexEntry> entries);
void append_data_end(Buffer& out, std::uint32_t crc);
/// Summary, where its groups stand, footer and magic: all that follows the end of the data.
/// @param at  where it begins in the file
void append_end(Buffer& out, const Summary& summary, std::uint64_t at);

}  // namespace mlab::mcap
