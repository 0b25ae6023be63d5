#include "mlab/mcap/encode.h"

#include <bit>
#include <concepts>
#include <cstring>
#include <limits>

#include <zlib.h>

namespace mlab::mcap {
namespace {

template <std::unsigned_integral T>
void put_at(std::byte* to, T value) {
  for (std::size_t i = 0; i < sizeof(T); ++i) to[i] = static_cast<std::byte>(value >> (8 * i));
}

template <std::unsigned_integral T>
void put(Buffer& out, T value) {
  const std::size_t at = out.size();
  out.resize(at + sizeof(T));
  put_at(out.data() + at, value);
}

void put_bytes(Buffer& out, std::span<const std::byte> bytes) {
  out.insert(out.end(), bytes.begin(), bytes.end());
}

void put_text(Buffer& out, std::string_view text) {
  put(out, static_cast<std::uint32_t>(text.size()));
  put_bytes(out, std::as_bytes(std::span(text)));
}

void put_id(Buffer& out, std::uint32_t id) {
  put(out, static_cast<std::uint16_t>(id));
}

/// A record whose length is known once its content stands there.
class Record {
 public:
  Record(Buffer& out, Opcode opcode) : out_(out) {
    put(out_, static_cast<std::uint8_t>(opcode));
    put(out_, std::uint64_t{0});
    begin_ = out_.size();
  }
  ~Record() { put_at(out_.data() + begin_ - 8, static_cast<std::uint64_t>(out_.size() - begin_)); }
  Record(const Record&) = delete;
  Record& operator=(const Record&) = delete;

  std::size_t begin() const { return begin_; }

 private:
  Buffer& out_;
  std::size_t begin_ = 0;
};

/// A map or an array, in front of which stands how many bytes it has.
class Sized {
 public:
  explicit Sized(Buffer& out) : out_(out) {
    put(out_, std::uint32_t{0});
    begin_ = out_.size();
  }
  ~Sized() { put_at(out_.data() + begin_ - 4, static_cast<std::uint32_t>(out_.size() - begin_)); }
  Sized(const Sized&) = delete;
  Sized& operator=(const Sized&) = delete;

 private:
  Buffer& out_;
  std::size_t begin_ = 0;
};

void put_pairs(Buffer& out, const Pairs& pairs) {
  const Sized sized(out);
  for (const auto& [key, value] : pairs) {
    put_text(out, key);
    put_text(out, value);
  }
}

void append(Buffer& out, const ChunkIndex& index) {
  const Record record(out, Opcode::kChunkIndex);
  put(out, index.start_time);
  put(out, index.end_time);
  put(out, index.offset);
  put(out, index.length);
  {
    const Sized sized(out);
    for (const auto& [channel, offset] : index.message_indexes) {
      put_id(out, channel.value);
      put(out, offset);
    }
  }
  put(out, index.message_index_length);
  put_text(out, index.compression);
  put(out, index.compressed_size);
  put(out, index.uncompressed_size);
}

void append(Buffer& out, const AttachmentIndex& index) {
  const Record record(out, Opcode::kAttachmentIndex);
  put(out, index.offset);
  put(out, index.length);
  put(out, index.log_time);
  put(out, index.create_time);
  put(out, index.data_size);
  put_text(out, index.name);
  put_text(out, index.media_type);
}

void append(Buffer& out, const MetadataIndex& index) {
  const Record record(out, Opcode::kMetadataIndex);
  put(out, index.offset);
  put(out, index.length);
  put_text(out, index.name);
}

void append_statistics(Buffer& out, const Summary& summary) {
  const Record record(out, Opcode::kStatistics);
  put(out, summary.message_count);
  put(out, static_cast<std::uint16_t>(summary.schemas.size()));
  put(out, static_cast<std::uint32_t>(summary.channels.size()));
  put(out, static_cast<std::uint32_t>(summary.attachments.size()));
  put(out, static_cast<std::uint32_t>(summary.metadata.size()));
  put(out, static_cast<std::uint32_t>(summary.chunks.size()));
  put(out, summary.start_time);
  put(out, summary.end_time);
  const Sized sized(out);
  for (const auto& [channel, count] : summary.messages_of) {
    put_id(out, channel.value);
    put(out, count);
  }
}

struct Group {
  Opcode opcode;
  std::uint64_t start;
  std::uint64_t length;
};

std::vector<Group> append_groups(Buffer& out, const Summary& summary, std::uint64_t at) {
  const std::size_t before = out.size();
  std::vector<Group> groups;
  const auto group = [&](Opcode opcode, auto&& write) {
    const std::size_t begin = out.size();
    write();
    if (out.size() > begin) groups.push_back({opcode, at + (begin - before), out.size() - begin});
  };
  group(Opcode::kSchema, [&] {
    for (const auto& [id, schema] : summary.schemas) append(out, schema);
  });
  group(Opcode::kChannel, [&] {
    for (const auto& [id, channel] : summary.channels) append(out, channel);
  });
  group(Opcode::kStatistics, [&] { append_statistics(out, summary); });
  group(Opcode::kChunkIndex, [&] {
    for (const ChunkIndex& one : summary.chunks) append(out, one);
  });
  group(Opcode::kAttachmentIndex, [&] {
    for (const AttachmentIndex& one : summary.attachments) append(out, one);
  });
  group(Opcode::kMetadataIndex, [&] {
    for (const MetadataIndex& one : summary.metadata) append(out, one);
  });
  return groups;
}

}  // namespace

std::uint32_t crc32(std::span<const std::byte> bytes, std::uint32_t before) {
  if (bytes.empty()) return before;  // zlib begins anew where there is no pointer
  return static_cast<std::uint32_t>(
      ::crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

void append_magic(Buffer& out) {
  put_bytes(out, std::as_bytes(std::span(kMagic)));
}

void append(Buffer& out, const Header& header) {
  const Record record(out, Opcode::kHeader);
  put_text(out, header.profile);
  put_text(out, header.library);
}

void append(Buffer& out, const Schema& schema) {
  const Record record(out, Opcode::kSchema);
  put_id(out, schema.id.value);
  put_text(out, schema.name);
  put_text(out, schema.encoding);
  put_text(out, schema.data);
}

void append(Buffer& out, const Channel& channel) {
  const Record record(out, Opcode::kChannel);
  put_id(out, channel.id.value);
  put_id(out, channel.schema.value);
  put_text(out, channel.topic);
  put_text(out, channel.message_encoding);
  put_pairs(out, channel.metadata);
}

void append(Buffer& out, const Message& message) {
  const std::size_t at = out.size();
  out.resize(at + kRecordHead + kMessageHead + message.data.size());
  std::byte* const to = out.data() + at;
  put_at(to, static_cast<std::uint8_t>(Opcode::kMessage));
  put_at(to + 1, static_cast<std::uint64_t>(kMessageHead + message.data.size()));
  put_at(to + 9, static_cast<std::uint16_t>(message.channel.value));
  put_at(to + 11, message.sequence);
  put_at(to + 15, message.log_time);
  put_at(to + 23, message.publish_time);
  if (!message.data.empty()) std::memcpy(to + 31, message.data.data(), message.data.size());
}

void append(Buffer& out, const Attachment& attachment) {
  const Record record(out, Opcode::kAttachment);
  put(out, attachment.log_time);
  put(out, attachment.create_time);
  put_text(out, attachment.name);
  put_text(out, attachment.media_type);
  put(out, static_cast<std::uint64_t>(attachment.data.size()));
  put_bytes(out, std::as_bytes(std::span(attachment.data)));
  put(out, crc32(std::span(out).subspan(record.begin())));
}

void append(Buffer& out, const Metadata& metadata) {
  const Record record(out, Opcode::kMetadata);
  put_text(out, metadata.name);
  put_pairs(out, metadata.values);
}

void append(Buffer& out, const ChunkHead& head, std::span<const std::byte> records) {
  const Record record(out, Opcode::kChunk);
  put(out, head.start_time);
  put(out, head.end_time);
  put(out, head.uncompressed_size);
  put(out, head.crc);
  put_text(out, head.compression);
  put(out, static_cast<std::uint64_t>(records.size()));
  put_bytes(out, records);
}

void append_message_index(Buffer& out, ChannelId channel, std::span<const IndexEntry> entries) {
  const Record record(out, Opcode::kMessageIndex);
  put_id(out, channel.value);
  const Sized sized(out);
  for (const IndexEntry& entry : entries) {
    put(out, entry.log_time);
    put(out, entry.offset);
  }
}

void append_data_end(Buffer& out, std::uint32_t crc) {
  const Record record(out, Opcode::kDataEnd);
  put(out, crc);
}

void append_end(Buffer& out, const Summary& summary, std::uint64_t at) {
  const std::size_t begin = out.size();
  const std::vector<Group> groups = append_groups(out, summary, at);
  const std::uint64_t offsets_start = at + (out.size() - begin);
  for (const Group& group : groups) {
    const Record record(out, Opcode::kSummaryOffset);
    put(out, static_cast<std::uint8_t>(group.opcode));
    put(out, group.start);
    put(out, group.length);
  }
  put(out, static_cast<std::uint8_t>(Opcode::kFooter));
  put(out, std::uint64_t{20});
  put(out, at);
  put(out, offsets_start);
  put(out, crc32(std::span(out).subspan(begin)));
  append_magic(out);
}

}  // namespace mlab::mcap
