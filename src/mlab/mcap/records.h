#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "mlab/base/id.h"

/// What an MCAP file is made of. Times are nanoseconds; from when they count, who writes the file says.
/// @source MCAP format specification, version 0
namespace mlab::mcap {

/// How a message is to be read: a schema of the file, counted from 1; 0 is "no schema". At most 65,535.
using SchemaId = base::Id<struct SchemaTag>;
/// Where a message belongs: a channel of the file, at most 65,535. A writer of ours counts from 1.
using ChannelId = base::Id<struct ChannelTag>;

/// Both ends of a file.
inline constexpr std::array<unsigned char, 8> kMagic = {0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};

/// What a record is; stands in front of it. Those from 0x80 on are private, all others to come.
enum class Opcode : std::uint8_t {
  kHeader = 0x01,
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunk = 0x06,
  kMessageIndex = 0x07,
  kChunkIndex = 0x08,
  kAttachment = 0x09,
  kAttachmentIndex = 0x0a,
  kStatistics = 0x0b,
  kMetadata = 0x0c,
  kMetadataIndex = 0x0d,
  kSummaryOffset = 0x0e,
  kDataEnd = 0x0f,
};

/// The largest chunk that a reader takes unless it is told otherwise, and more than a writer of ours makes
/// [bytes, uncompressed].
inline constexpr std::size_t kMostChunkBytes = std::size_t{64} << 20;
/// The largest message, schema or description of a channel that a writer takes [bytes].
inline constexpr std::size_t kMostRecordBytes = std::size_t{16} << 20;

using Pairs = std::map<std::string, std::string, std::less<>>;

struct Header {
  std::string profile = {};  ///< what the channels keep to: `ros2`; may be empty
  std::string library = {};  ///< who wrote the file

  friend bool operator==(const Header&, const Header&) = default;
};

struct Schema {
  SchemaId id = {};
  std::string name = {};      ///< of the type: `foxglove.SceneUpdate`
  std::string encoding = {};  ///< `protobuf`, `jsonschema`, `ros2msg`, ...
  std::string data = {};      ///< the definition, bytes

  friend bool operator==(const Schema&, const Schema&) = default;
};

struct Channel {
  ChannelId id = {};
  SchemaId schema = {};
  std::string topic = {};
  std::string message_encoding = {};  ///< `protobuf`, `json`, `cdr`, ...
  Pairs metadata = {};

  friend bool operator==(const Channel&, const Channel&) = default;
};

/// One message. Its bytes belong to whoever made it: who writes one, or the iterator that gave it.
struct Message {
  ChannelId channel = {};
  std::uint32_t sequence = 0;      ///< within its channel, where somebody counts
  std::uint64_t log_time = 0;      ///< when it was recorded; what the order goes by [ns]
  std::uint64_t publish_time = 0;  ///< when it was said [ns]
  std::span<const std::byte> data = {};
};

/// A file within the file.
struct Attachment {
  std::string name = {};
  std::string media_type = {};
  std::uint64_t log_time = 0;     ///< [ns]
  std::uint64_t create_time = 0;  ///< [ns], 0 where nobody knows
  std::string data = {};          ///< bytes

  friend bool operator==(const Attachment&, const Attachment&) = default;
};

struct Metadata {
  std::string name = {};
  Pairs values = {};

  friend bool operator==(const Metadata&, const Metadata&) = default;
};

/// Where a chunk stands and what it holds.
struct ChunkIndex {
  std::uint64_t start_time = 0;  ///< of the earliest message [ns]
  std::uint64_t end_time = 0;    ///< of the latest [ns]
  std::uint64_t offset = 0;      ///< of its record in the file
  std::uint64_t length = 0;      ///< of its record, opcode and length included
  std::vector<std::pair<ChannelId, std::uint64_t>> message_indexes;  ///< offsets in the file, by channel
  std::uint64_t message_index_length = 0;                            ///< of all of them
  std::string compression;
  std::uint64_t compressed_size = 0;
  std::uint64_t uncompressed_size = 0;

  friend bool operator==(const ChunkIndex&, const ChunkIndex&) = default;
};

/// Where an attachment stands: offset and length of its record in the file.
struct AttachmentIndex {
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
  std::uint64_t log_time = 0;     ///< [ns]
  std::uint64_t create_time = 0;  ///< [ns]
  std::uint64_t data_size = 0;
  std::string name;
  std::string media_type;

  friend bool operator==(const AttachmentIndex&, const AttachmentIndex&) = default;
};

/// Where metadata stand: offset and length of their record in the file.
struct MetadataIndex {
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
  std::string name;

  friend bool operator==(const MetadataIndex&, const MetadataIndex&) = default;
};

/// What can be known of a file without looking at its messages.
struct Summary {
  std::map<SchemaId, Schema> schemas;
  std::map<ChannelId, Channel> channels;
  std::vector<ChunkIndex> chunks;  ///< in the order of the file, as the others
  std::vector<AttachmentIndex> attachments;
  std::vector<MetadataIndex> metadata;
  std::uint64_t message_count = 0;
  std::uint64_t start_time = 0;  ///< of the earliest message [ns]; 0 where there is none
  std::uint64_t end_time = 0;    ///< of the latest [ns]; 0 where there is none
  std::map<ChannelId, std::uint64_t> messages_of;

  friend bool operator==(const Summary&, const Summary&) = default;
};

}  // namespace mlab::mcap
