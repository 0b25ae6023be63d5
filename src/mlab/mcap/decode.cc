#include "mlab/mcap/decode.h"

#include <algorithm>
#include <type_traits>

namespace mlab::mcap {
namespace {

template <class T>
std::optional<std::remove_cvref_t<T>> if_good(const Cursor& cursor, T&& value) {
  if (!cursor.is_good()) return std::nullopt;
  return std::forward<T>(value);
}

}  // namespace

std::span<const std::byte> Cursor::take(std::uint64_t size) {
  if (size > rest_.size()) {
    is_good_ = false;
    rest_ = {};
    return {};
  }
  const std::span<const std::byte> out = rest_.first(static_cast<std::size_t>(size));
  rest_ = rest_.subspan(out.size());
  return out;
}

std::span<const std::byte> Cursor::sized() {
  return take(number<std::uint32_t>());
}

std::string_view Cursor::text() {
  const std::span<const std::byte> bytes = sized();
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

Pairs Cursor::pairs() {
  Cursor inside(sized());
  Pairs out;
  while (!inside.is_at_end()) {
    const std::string_view key = inside.text();
    const std::string_view value = inside.text();
    if (!inside.is_good()) {
      is_good_ = false;
      break;
    }
    out.insert_or_assign(std::string(key), std::string(value));
  }
  return out;
}

std::optional<Header> decode_header(std::span<const std::byte> content) {
  Cursor cursor(content);
  Header out;
  out.profile = cursor.text();
  out.library = cursor.text();
  return if_good(cursor, std::move(out));
}

std::optional<Schema> decode_schema(std::span<const std::byte> content) {
  Cursor cursor(content);
  Schema out;
  out.id = cursor.schema();
  out.name = cursor.text();
  out.encoding = cursor.text();
  out.data = cursor.text();
  if (out.id.value == 0) return std::nullopt;
  return if_good(cursor, std::move(out));
}

std::optional<Channel> decode_channel(std::span<const std::byte> content) {
  Cursor cursor(content);
  Channel out;
  out.id = cursor.channel();
  out.schema = cursor.schema();
  out.topic = cursor.text();
  out.message_encoding = cursor.text();
  out.metadata = cursor.pairs();
  return if_good(cursor, std::move(out));
}

std::optional<Message> decode_message(std::span<const std::byte> content) {
  Cursor cursor(content);
  Message out;
  out.channel = cursor.channel();
  out.sequence = cursor.number<std::uint32_t>();
  out.log_time = cursor.number<std::uint64_t>();
  out.publish_time = cursor.number<std::uint64_t>();
  out.data = cursor.rest();
  return if_good(cursor, out);
}

std::optional<ChunkRecord> decode_chunk(std::span<const std::byte> content) {
  Cursor cursor(content);
  ChunkRecord out;
  out.head.start_time = cursor.number<std::uint64_t>();
  out.head.end_time = cursor.number<std::uint64_t>();
  out.head.uncompressed_size = cursor.number<std::uint64_t>();
  out.head.crc = cursor.number<std::uint32_t>();
  out.head.compression = cursor.text();
  out.records = cursor.take(cursor.number<std::uint64_t>());
  return if_good(cursor, out);
}

std::optional<AttachmentHead> decode_attachment_head(std::span<const std::byte> first,
                                                     std::uint64_t content_length) {
  Cursor cursor(first);
  AttachmentHead out;
  out.index.log_time = cursor.number<std::uint64_t>();
  out.index.create_time = cursor.number<std::uint64_t>();
  out.index.name = cursor.text();
  out.index.media_type = cursor.text();
  out.index.data_size = cursor.number<std::uint64_t>();
  out.data_at = first.size() - cursor.rest().size();
  constexpr std::uint64_t kCrc = 4;
  const std::uint64_t behind = content_length - std::min(content_length, out.data_at);
  if (behind < kCrc || behind - kCrc < out.index.data_size) return std::nullopt;
  return if_good(cursor, std::move(out));
}

std::optional<Metadata> decode_metadata(std::span<const std::byte> content) {
  Cursor cursor(content);
  Metadata out;
  out.name = cursor.text();
  out.values = cursor.pairs();
  return if_good(cursor, std::move(out));
}

std::optional<ChunkIndex> decode_chunk_index(std::span<const std::byte> content) {
  Cursor cursor(content);
  ChunkIndex out;
  out.start_time = cursor.number<std::uint64_t>();
  out.end_time = cursor.number<std::uint64_t>();
  out.offset = cursor.number<std::uint64_t>();
  out.length = cursor.number<std::uint64_t>();
  Cursor inside(cursor.sized());
  while (!inside.is_at_end()) {
    const ChannelId channel = inside.channel();
    const auto offset = inside.number<std::uint64_t>();
    if (!inside.is_good()) return std::nullopt;
    out.message_indexes.emplace_back(channel, offset);
  }
  std::ranges::sort(out.message_indexes);
  out.message_index_length = cursor.number<std::uint64_t>();
  out.compression = cursor.text();
  out.compressed_size = cursor.number<std::uint64_t>();
  out.uncompressed_size = cursor.number<std::uint64_t>();
  return if_good(cursor, std::move(out));
}

std::optional<AttachmentIndex> decode_attachment_index(std::span<const std::byte> content) {
  Cursor cursor(content);
  AttachmentIndex out;
  out.offset = cursor.number<std::uint64_t>();
  out.length = cursor.number<std::uint64_t>();
  out.log_time = cursor.number<std::uint64_t>();
  out.create_time = cursor.number<std::uint64_t>();
  out.data_size = cursor.number<std::uint64_t>();
  out.name = cursor.text();
  out.media_type = cursor.text();
  return if_good(cursor, std::move(out));
}

std::optional<MetadataIndex> decode_metadata_index(std::span<const std::byte> content) {
  Cursor cursor(content);
  MetadataIndex out;
  out.offset = cursor.number<std::uint64_t>();
  out.length = cursor.number<std::uint64_t>();
  out.name = cursor.text();
  return if_good(cursor, std::move(out));
}

std::optional<Statistics> decode_statistics(std::span<const std::byte> content) {
  Cursor cursor(content);
  Statistics out;
  out.message_count = cursor.number<std::uint64_t>();
  cursor.number<std::uint16_t>();  // schemas and channels: the summary has them
  cursor.number<std::uint32_t>();
  out.attachment_count = cursor.number<std::uint32_t>();
  out.metadata_count = cursor.number<std::uint32_t>();
  out.chunk_count = cursor.number<std::uint32_t>();
  out.start_time = cursor.number<std::uint64_t>();
  out.end_time = cursor.number<std::uint64_t>();
  Cursor inside(cursor.sized());
  while (!inside.is_at_end()) {
    const ChannelId channel = inside.channel();
    const auto count = inside.number<std::uint64_t>();
    if (!inside.is_good()) return std::nullopt;
    out.messages_of.insert_or_assign(channel, count);
  }
  return if_good(cursor, std::move(out));
}

std::optional<Footer> decode_footer(std::span<const std::byte> content) {
  Cursor cursor(content);
  Footer out;
  out.summary_start = cursor.number<std::uint64_t>();
  out.summary_offset_start = cursor.number<std::uint64_t>();
  out.summary_crc = cursor.number<std::uint32_t>();
  return if_good(cursor, out);
}

}  // namespace mlab::mcap
