#include "mlab/mcap/writer_state.h"

#include <algorithm>
#include <cerrno>
#include <system_error>

#include <fmt/core.h>

#include "mlab/base/counted.h"
#include "mlab/text/shown.h"

namespace mlab::mcap {
namespace {

// With the largest message and all definitions in it, a chunk stays below what a reader takes.
constexpr std::size_t kMostBeforeMessage = std::size_t{16} << 20;
constexpr std::size_t kMostDefinitions = std::size_t{16} << 20;
static_assert(kMostBeforeMessage + kMostDefinitions + kMostRecordBytes < kMostChunkBytes);
constexpr std::size_t kMostNames = std::size_t{64} << 10;
constexpr std::size_t kMostAttachment = std::size_t{1} << 29;
constexpr std::uint32_t kLastId = UINT16_MAX;

std::size_t size_of(const Pairs& pairs) {
  std::size_t out = 0;
  for (const auto& [key, value] : pairs) out += 8 + key.size() + value.size();
  return out;
}

/// A number that the map does not have; 0 where it has all.
template <class Map>
std::uint32_t free_id(const Map& map) {
  if (map.empty()) return 1;
  if (map.rbegin()->first.value < kLastId) return map.rbegin()->first.value + 1;
  for (std::uint32_t id = 1; id <= kLastId; ++id) {
    if (!map.contains({id})) return id;
  }
  return 0;
}

/// The one that says the same, whatever its number.
template <class Record, class Map, class Ids>
const Record* find_equal(const Map& map, const Ids& candidates, Record wanted) {
  for (const auto id : candidates) {
    const Record& one = map.at(id);
    wanted.id = id;
    if (one == wanted) return &one;
  }
  return nullptr;
}

}  // namespace

std::size_t definition_size(const Schema& schema) {
  return schema.name.size() + schema.encoding.size() + schema.data.size();
}

std::size_t definition_size(const Channel& channel) {
  return channel.topic.size() + channel.message_encoding.size() + size_of(channel.metadata);
}

Writer::State::State(std::unique_ptr<Sink> sink, std::string name, const WriterOptions& options)
    : sink_(std::move(sink)),
      name_(std::move(name)),
      chunk_bytes_(std::clamp<std::size_t>(options.chunk_bytes, 1, kMostBeforeMessage)),
      is_compressed_(options.is_compressed),
      compressor_(std::clamp(options.level, 1, 19)) {}

Written Writer::State::begin(const Header& header) {
  if (header.profile.size() + header.library.size() > kMostNames)
    return std::unexpected(misused("its header is too long"));
  append_magic(out_);
  append(out_, header);
  return put_out();
}

std::optional<WriteError> Writer::State::not_now() const {
  if (failure_) return failure_;
  if (sink_ == nullptr) return misused("it is closed");
  return std::nullopt;
}

WriteError Writer::State::misused(const std::string& what) const {
  return {EINVAL, fmt::format("`{}`: {}", text::shown(name_, 200), what), at_, kept_messages_, 0};
}

std::unexpected<WriteError> Writer::State::die(int code) {
  WriteError out{code, {}, at_, kept_messages_, summary_.message_count - kept_messages_};
  if (sink_ != nullptr) {
    static_cast<void>(sink_->cut(at_));
    static_cast<void>(sink_->close());
    sink_.reset();
  }
  out.message = fmt::format("`{}` can't be written any further: {}; {} kept, {} lost",
                            text::shown(name_, 200), std::generic_category().message(code),
                            base::counted(out.kept_messages, "message"), out.lost_messages);
  failure_ = out;
  return std::unexpected(std::move(out));
}

Written Writer::State::put_out() {
  if (const int error = sink_->append(out_); error != 0) return die(error);
  at_ += out_.size();
  crc_ = crc32(out_, crc_);
  out_.clear();
  return {};
}

Writer::State::OfChannel& Writer::State::channel_at(ChannelId id) {
  channels_.resize(std::max<std::size_t>(channels_.size(), id.value + 1));
  return channels_[id.value];
}

template <class Record>
std::expected<void, WriteError> Writer::State::define(const Record& record) {
  const std::size_t size = definition_size(record);
  if (size > kMostDefinitions - std::min(kMostDefinitions, definition_bytes_))
    return std::unexpected(
        misused(fmt::format("more than {} bytes of schemas and channels", kMostDefinitions)));
  if (record.id.value == 0) return std::unexpected(misused(fmt::format("more than {} of a kind", kLastId)));
  definition_bytes_ += size;
  append(chunk_, record);
  return {};
}

std::expected<SchemaId, WriteError> Writer::State::add_schema(const Schema& schema) {
  if (auto problem = not_now()) return std::unexpected(*std::move(problem));
  auto& alike = schemas_by_name_[schema.name];
  if (const Schema* const found = find_equal(summary_.schemas, alike, schema)) return found->id;
  Schema added = schema;
  added.id.value = free_id(summary_.schemas);
  if (auto written = define(added); !written) return std::unexpected(std::move(written.error()));
  alike.push_back(added.id);
  const SchemaId id = added.id;
  summary_.schemas.emplace(id, std::move(added));
  return id;
}

std::expected<ChannelId, WriteError> Writer::State::add_channel(const Channel& channel) {
  if (auto problem = not_now()) return std::unexpected(*std::move(problem));
  if (channel.schema.value != 0 && !summary_.schemas.contains(channel.schema))
    return std::unexpected(misused(fmt::format("the channel `{}` names the schema {}, which nobody added",
                                               text::shown(channel.topic), channel.schema.value)));
  auto& alike = channels_by_topic_[channel.topic];
  if (const Channel* const found = find_equal(summary_.channels, alike, channel)) return found->id;
  Channel added = channel;
  added.id.value = free_id(summary_.channels);
  if (auto written = define(added); !written) return std::unexpected(std::move(written.error()));
  alike.push_back(added.id);
  const ChannelId id = added.id;
  summary_.channels.emplace(id, std::move(added));
  channel_at(id).is_there = true;
  return id;
}

void Writer::State::note(ChannelId channel, IndexEntry entry) {
  std::vector<IndexEntry>& entries = channels_[channel.value].entries;
  if (entries.empty()) in_chunk_.push_back(channel);
  entries.push_back(entry);
}

Written Writer::State::write(const Message& message) {
  if (sink_ == nullptr) return std::unexpected(*not_now());
  const std::size_t id = message.channel.value;
  if (id >= channels_.size() || !channels_[id].is_there)
    return std::unexpected(misused(fmt::format("a message of the channel {}, which nobody added", id)));
  if (message.data.size() > kMostRecordBytes)
    return std::unexpected(misused(
        fmt::format("a message of {} bytes, where {} are the most", message.data.size(), kMostRecordBytes)));
  const std::uint64_t time = message.log_time;
  note(message.channel, {time, chunk_.size()});
  append(chunk_, message);
  chunk_start_ = chunk_messages_ == 0 ? time : std::min(chunk_start_, time);
  chunk_end_ = chunk_messages_ == 0 ? time : std::max(chunk_end_, time);
  ++chunk_messages_;
  summary_.start_time = summary_.message_count == 0 ? time : std::min(summary_.start_time, time);
  summary_.end_time = std::max(summary_.end_time, time);
  ++summary_.message_count;
  OfChannel& channel = channels_[id];
  if (channel.count == nullptr) channel.count = &summary_.messages_of[message.channel];
  ++*channel.count;
  return chunk_.size() < chunk_bytes_ ? Written{} : flush();
}

void Writer::State::append_indexes(ChunkIndex& index, std::uint64_t at) {
  const std::size_t begin = out_.size();
  std::ranges::sort(in_chunk_);
  index.message_indexes.clear();
  index.message_indexes.reserve(in_chunk_.size());
  for (const ChannelId channel : in_chunk_) {
    index.message_indexes.emplace_back(channel, at + (out_.size() - begin));
    append_message_index(out_, channel, channels_[channel.value].entries);
    channels_[channel.value].entries.clear();
  }
  in_chunk_.clear();
  index.message_index_length = out_.size() - begin;
}

Written Writer::State::flush() {
  if (auto problem = not_now()) return std::unexpected(*std::move(problem));
  if (chunk_messages_ == 0) return {};
  const std::span<const std::byte> records = is_compressed_ ? compressor_.compressed(chunk_) : chunk_;
  const ChunkHead head{chunk_start_, chunk_end_, chunk_.size(), crc32(chunk_), is_compressed_ ? "zstd" : ""};
  append(out_, head, records);
  ChunkIndex index;
  index.start_time = chunk_start_;
  index.end_time = chunk_end_;
  index.offset = at_;
  index.length = out_.size();
  index.compression = head.compression;
  index.compressed_size = records.size();
  index.uncompressed_size = chunk_.size();
  append_indexes(index, at_ + index.length);
  if (auto written = put_out(); !written) return written;
  summary_.chunks.push_back(std::move(index));
  kept_messages_ += chunk_messages_;
  chunk_messages_ = 0;
  chunk_.clear();
  return {};
}

Written Writer::State::attach(const Attachment& attachment) {
  if (auto problem = not_now()) return std::unexpected(*std::move(problem));
  if (attachment.name.size() + attachment.media_type.size() > kMostNames ||
      attachment.data.size() > kMostAttachment)
    return std::unexpected(
        misused(fmt::format("the attachment `{}` has {} bytes, where {} are the most",
                            text::shown(attachment.name), attachment.data.size(), kMostAttachment)));
  append(out_, attachment);
  AttachmentIndex index{at_,
                        out_.size(),
                        attachment.log_time,
                        attachment.create_time,
                        attachment.data.size(),
                        attachment.name,
                        attachment.media_type};
  if (auto written = put_out(); !written) return written;
  summary_.attachments.push_back(std::move(index));
  return {};
}

Written Writer::State::add(const Metadata& metadata) {
  if (auto problem = not_now()) return std::unexpected(*std::move(problem));
  if (metadata.name.size() > kMostNames || size_of(metadata.values) > kMostRecordBytes)
    return std::unexpected(misused(fmt::format("the metadata `{}` have more than {} bytes",
                                               text::shown(metadata.name), kMostRecordBytes)));
  append(out_, metadata);
  MetadataIndex index{at_, out_.size(), metadata.name};
  if (auto written = put_out(); !written) return written;
  summary_.metadata.push_back(std::move(index));
  return {};
}

Written Writer::State::sync() {
  if (auto written = flush(); !written) return written;
  if (const int error = sink_->sync(); error != 0) return die(error);
  return {};
}

Written Writer::State::close() {
  if (sink_ == nullptr && !failure_) return {};
  if (auto written = flush(); !written) return written;
  append_data_end(out_, crc_);
  append_end(out_, summary_, at_ + out_.size());
  if (auto written = put_out(); !written) return written;
  const int error = sink_->close();
  if (error != 0) return die(error);
  sink_.reset();
  return {};
}

}  // namespace mlab::mcap
