#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/mcap/encode.h"
#include "mlab/mcap/records.h"

/// Records out of bytes, which a stranger may have written. For sources of this module only. What follows the
/// last field of a record is left alone: later versions of the format may put more there.
namespace mlab::mcap {

/// Reads fields one after the other and never past the end: a field that is not whole is 0 or empty, and
/// `is_good` says so.
class Cursor {
 public:
  explicit Cursor(std::span<const std::byte> bytes) : rest_(bytes) {}

  bool is_good() const { return is_good_; }
  bool is_at_end() const { return rest_.empty(); }
  std::span<const std::byte> rest() const { return rest_; }

  template <std::unsigned_integral T>
  T number() {
    T out = 0;
    const std::span<const std::byte> bytes = take(sizeof(T));
    for (std::size_t i = 0; i < bytes.size(); ++i)
      out = static_cast<T>(out | static_cast<T>(static_cast<T>(bytes[i]) << (8 * i)));
    return out;
  }
  SchemaId schema() { return {number<std::uint16_t>()}; }
  ChannelId channel() { return {number<std::uint16_t>()}; }
  std::span<const std::byte> take(std::uint64_t size);
  /// Of as many bytes as a number of 32 bits in front of it says.
  std::string_view text();
  std::span<const std::byte> sized();
  Pairs pairs();

 private:
  std::span<const std::byte> rest_;
  bool is_good_ = true;
};

/// A chunk, its records as they stand in the file.
struct ChunkRecord {
  ChunkHead head;  ///< views into the content
  std::span<const std::byte> records;
};

/// What can be said of an attachment without its data.
struct AttachmentHead {
  AttachmentIndex index;      ///< without offset and length
  std::uint64_t data_at = 0;  ///< in the content
};

/// What statistics say that a reader looks at.
struct Statistics {
  std::uint64_t message_count = 0;
  std::uint32_t chunk_count = 0;
  std::uint32_t attachment_count = 0;
  std::uint32_t metadata_count = 0;
  std::uint64_t start_time = 0;
  std::uint64_t end_time = 0;
  std::map<ChannelId, std::uint64_t> messages_of;
};

/// Each of them: nothing where the content is too short for what it says.
std::optional<Header> decode_header(std::span<const std::byte> content);
std::optional<Schema> decode_schema(std::span<const std::byte> content);
std::optional<Channel> decode_channel(std::span<const std::byte> content);
std::optional<Message> decode_message(std::span<const std::byte> content);
std::optional<ChunkRecord> decode_chunk(std::span<const std::byte> content);
/// Of the first bytes of a content; its whole length says how many bytes of data there must be.
std::optional<AttachmentHead> decode_attachment_head(std::span<const std::byte> first,
                                                     std::uint64_t content_length);
std::optional<Metadata> decode_metadata(std::span<const std::byte> content);
std::optional<ChunkIndex> decode_chunk_index(std::span<const std::byte> content);
std::optional<AttachmentIndex> decode_attachment_index(std::span<const std::byte> content);
std::optional<MetadataIndex> decode_metadata_index(std::span<const std::byte> content);
std::optional<Statistics> decode_statistics(std::span<const std::byte> content);
std::optional<Footer> decode_footer(std::span<const std::byte> content);

/// Hands each record of a chunk or a summary to `take(opcode, content, offset)`, which may refuse it with a
/// sentence.
/// @errors  what is wrong, without a place
template <class Take>
std::optional<std::string> each_record(std::span<const std::byte> records, Take&& take) {
  Cursor cursor(records);
  while (!cursor.is_at_end()) {
    const std::size_t offset = records.size() - cursor.rest().size();
    const auto opcode = static_cast<Opcode>(cursor.number<std::uint8_t>());
    const std::span<const std::byte> content = cursor.take(cursor.number<std::uint64_t>());
    if (!cursor.is_good()) return "a record in it is longer than what is left";
    if (std::optional<std::string> problem = take(opcode, content, offset)) return problem;
  }
  return std::nullopt;
}

}  // namespace mlab::mcap
