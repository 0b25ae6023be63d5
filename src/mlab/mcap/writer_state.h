#pragma once

#include <cstdint>
#include <expected>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mlab/mcap/chunk_bytes.h"
#include "mlab/mcap/encode.h"
#include "mlab/mcap/scan.h"
#include "mlab/mcap/writer.h"

/// For sources of this module only.
namespace mlab::mcap {

/// What of them counts against the most that a file may have of schemas and channels.
std::size_t definition_size(const Schema& schema);
std::size_t definition_size(const Channel& channel);

/// What a writer consists of.
class Writer::State {
 public:
  /// @param name  for messages
  State(std::unique_ptr<Sink> sink, std::string name, const WriterOptions& options);

  Written begin(const Header& header);
  /// Goes on with a file of which this was found, and cuts off what is not to stay. What is missing then
  /// waits for `put_out`.
  /// @return  0, or the system's number of an error, after which the file is as it was
  int go_on(Scan found, const Source& source);
  Written put_out();

  std::expected<SchemaId, WriteError> add_schema(const Schema& schema);
  std::expected<ChannelId, WriteError> add_channel(const Channel& channel);
  Written write(const Message& message);
  Written attach(const Attachment& attachment);
  Written add(const Metadata& metadata);
  Written flush();
  Written sync();
  Written close();

  const Summary& summary() const { return summary_; }
  const WriteError* failure() const { return failure_ ? &*failure_ : nullptr; }
  std::uint64_t file_bytes() const { return at_; }

 private:
  /// A channel, and which messages of it the open chunk holds.
  struct OfChannel {
    bool is_there = false;
    std::uint64_t* count = nullptr;  // in the summary; null: it has no messages
    std::vector<IndexEntry> entries;
  };

  OfChannel& channel_at(ChannelId id);
  std::optional<WriteError> not_now() const;
  WriteError misused(const std::string& what) const;
  template <class Record>
  std::expected<void, WriteError> define(const Record& record);
  void take(Summary found);
  void note(ChannelId channel, IndexEntry entry);
  void append_indexes(ChunkIndex& index, std::uint64_t at);
  std::unexpected<WriteError> die(int code);

  std::unique_ptr<Sink> sink_;  // null once closed or dead
  std::string name_;
  std::size_t chunk_bytes_;
  bool is_compressed_;
  Compressor compressor_;
  Summary summary_;
  std::map<std::string, std::vector<SchemaId>, std::less<>> schemas_by_name_;
  std::map<std::string, std::vector<ChannelId>, std::less<>> channels_by_topic_;
  std::size_t definition_bytes_ = 0;
  std::vector<OfChannel> channels_;  // by number
  std::vector<ChannelId> in_chunk_;  // those of which the open chunk has messages
  Buffer chunk_;                     // its records
  std::uint64_t chunk_start_ = 0;    // [ns]
  std::uint64_t chunk_end_ = 0;      // [ns]
  std::uint64_t chunk_messages_ = 0;
  Buffer out_;             // what goes to the sink next
  std::uint64_t at_ = 0;   // bytes of the file
  std::uint32_t crc_ = 0;  // of all of them
  std::uint64_t kept_messages_ = 0;
  std::optional<WriteError> failure_;
};

}  // namespace mlab::mcap
