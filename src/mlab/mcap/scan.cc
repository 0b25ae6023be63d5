#include "mlab/mcap/scan.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "mlab/mcap/chunk_bytes.h"
#include "mlab/mcap/decode.h"

namespace mlab::mcap {
namespace {

/// So much of the messages outside of chunks is read at once [bytes].
constexpr std::uint64_t kMostLooseBytes = std::uint64_t{4} << 20;
/// In so many bytes the name of an attachment or of metadata stands.
constexpr std::uint64_t kMostNameBytes = std::uint64_t{1} << 20;

std::string_view kind_name(Opcode opcode) {
  switch (opcode) {
    case Opcode::kHeader:
      return "a header";
    case Opcode::kFooter:
      return "a footer";
    case Opcode::kSchema:
      return "a schema";
    case Opcode::kChannel:
      return "a channel";
    case Opcode::kMessage:
      return "a message";
    case Opcode::kChunk:
      return "a chunk";
    case Opcode::kAttachment:
      return "an attachment";
    case Opcode::kMetadata:
      return "metadata";
    case Opcode::kMessageIndex:
    case Opcode::kChunkIndex:
    case Opcode::kAttachmentIndex:
    case Opcode::kMetadataIndex:
      return "an index";
    default:
      return "a record";
  }
}

/// Reads a file from front to back in large pieces.
class Window {
 public:
  explicit Window(const Source& source) : source_(source) {}

  /// Bytes that the file has. Valid until the next call.
  std::expected<std::span<const std::byte>, std::string> at(std::uint64_t offset, std::size_t size) {
    if (offset < begin_ || offset - begin_ > bytes_.size() || size > bytes_.size() - (offset - begin_)) {
      constexpr std::uint64_t kStep = std::uint64_t{256} << 10;
      const std::uint64_t wanted = std::min(std::max<std::uint64_t>(size, kStep), source_.size() - offset);
      bytes_ = room_.of(static_cast<std::size_t>(wanted));
      begin_ = offset;
      if (const int error = source_.read(offset, bytes_); error != 0) {
        bytes_ = {};
        return std::unexpected(read_problem(error));
      }
    }
    return bytes_.subspan(static_cast<std::size_t>(offset - begin_), size);
  }

 private:
  const Source& source_;
  Room room_;
  std::span<std::byte> bytes_;
  std::uint64_t begin_ = 0;
};

/// A record of the file, its content not yet read.
struct Place {
  Opcode opcode{};
  std::uint64_t begin = 0;
  std::uint64_t content = 0;
  std::uint64_t length = 0;  ///< of the content

  std::uint64_t end() const { return content + length; }
};

class Scanner {
 public:
  Scanner(const Source& source, const Limits& limits) : source_(source), limits_(limits), window_(source) {}

  std::expected<Scan, std::string> look_through(const std::string& why_not_summary);

 private:
  using Problem = std::optional<std::string>;

  std::optional<Place> next(std::uint64_t at);
  bool was_closed();
  Problem take(const Place& place);
  void take_sound(const Place& place);
  Problem take_chunk(const Place& place);
  Problem take_record(Opcode opcode, std::span<const std::byte> content, std::size_t offset);
  Problem take_message(std::span<const std::byte> content, std::size_t offset);
  Problem take_loose(const Place& place);
  Problem take_message_index(const Place& place);
  Problem take_attachment(const Place& place);
  Problem take_metadata(const Place& place);
  template <class T, class Map>
  Problem define(std::optional<T> one, std::size_t size, Map& map);
  void count(const FoundMessage& message, Piece& piece);
  void finish_chunk(const Place& place, const ChunkHead& head);
  void settle_indexes();
  std::expected<std::span<const std::byte>, std::string> content_of(const Place& place, std::uint64_t most);

  Summary& summary() { return out_.contents.summary; }

  const Source& source_;
  Limits limits_;
  Window window_;
  Room room_;
  Scan out_;
  std::vector<FoundMessage> found_;       // in the chunk that is being looked at
  std::vector<FoundMessage> last_;        // in the last sound chunk
  std::vector<ChannelId> last_channels_;  // of these, sorted
  bool has_last_ = false;                 // nothing sound but indexes stands behind that
  std::uint64_t definition_bytes_ = 0;
  bool is_behind_chunk_ = false;  // a sound one, with nothing but indexes between
};

std::optional<Place> Scanner::next(std::uint64_t at) {
  std::string& why = out_.contents.ending.why;
  bool& is_broken = out_.contents.ending.is_broken;
  const std::uint64_t left = source_.size() - at;
  if (left == 0) {
    why = "the file ends without a footer: it was cut off, or is still being written";
    return std::nullopt;
  }
  if (left < kRecordHead) {
    why = fmt::format("the file ends with {} of the {} bytes of a record's head: it was cut off", left,
                      kRecordHead);
    return std::nullopt;
  }
  const auto bytes = window_.at(at, kRecordHead);
  if (!bytes) {
    why = bytes.error();
    is_broken = true;
    return std::nullopt;
  }
  Cursor cursor(*bytes);
  Place out;
  out.opcode = static_cast<Opcode>(cursor.number<std::uint8_t>());
  out.begin = at;
  out.content = at + kRecordHead;
  out.length = cursor.number<std::uint64_t>();
  if (static_cast<std::uint8_t>(out.opcode) == 0) {
    why = "a byte of 0 stands where a record should begin: it is broken here";
    is_broken = true;
    return std::nullopt;
  }
  if (out.length > left - kRecordHead) {
    why = fmt::format("the file ends with {} of the {} bytes of {}: it was cut off, or is broken here",
                      left - kRecordHead, out.length, kind_name(out.opcode));
    is_broken = was_closed();
    return std::nullopt;
  }
  return out;
}

// The writer came to the end of the file, so none of it can be missing there.
bool Scanner::was_closed() {
  if (source_.size() < kMagic.size()) return false;
  const auto end = window_.at(source_.size() - kMagic.size(), kMagic.size());
  return end && std::ranges::equal(*end, std::as_bytes(std::span(kMagic)));
}

std::expected<Scan, std::string> Scanner::look_through(const std::string& why_not_summary) {
  auto header = read_header(source_);
  if (!header) return std::unexpected(header.error());
  out_.contents.header = *std::move(header);
  Ending& ending = out_.contents.ending;
  std::uint64_t at = behind_header(source_);
  out_.sound_end = at;
  while (const std::optional<Place> place = next(at)) {
    if (place->opcode == Opcode::kDataEnd || place->opcode == Opcode::kFooter) {
      ending.why = why_not_summary;
      break;
    }
    if (Problem problem = take(*place)) {
      is_behind_chunk_ = false;
      if (ending.damages.size() < Ending::kMostDamages)
        ending.damages.push_back({place->begin, *std::move(problem)});
    } else {
      take_sound(*place);
    }
    at = place->end();
  }
  settle_indexes();
  if (has_last_) out_.last_chunk = std::move(last_);
  ending.is_whole = false;
  ending.readable_bytes = at;
  ending.file_bytes = source_.size();
  return std::move(out_);
}

void Scanner::take_sound(const Place& place) {
  const bool is_index = place.opcode == Opcode::kMessageIndex;
  if (is_index && !is_behind_chunk_) return;  // it goes with a chunk that can't be read
  out_.sound_end = place.end();
  is_behind_chunk_ = is_index || place.opcode == Opcode::kChunk;
  has_last_ = is_behind_chunk_;
}

std::expected<std::span<const std::byte>, std::string> Scanner::content_of(const Place& place,
                                                                           std::uint64_t most) {
  if (place.length > most)
    return std::unexpected(fmt::format("{} of {} bytes, where {} are the most that is read",
                                       kind_name(place.opcode), place.length, most));
  return window_.at(place.content, static_cast<std::size_t>(place.length));
}

Scanner::Problem Scanner::take(const Place& place) {
  switch (place.opcode) {
    case Opcode::kChunk:
      return take_chunk(place);
    case Opcode::kMessageIndex:
      return take_message_index(place);
    case Opcode::kMessage:
      return take_loose(place);
    case Opcode::kSchema:
    case Opcode::kChannel: {
      const auto content = content_of(place, limits_.definition_bytes);
      return content ? take_record(place.opcode, *content, 0) : content.error();
    }
    case Opcode::kAttachment:
      return take_attachment(place);
    case Opcode::kMetadata:
      return take_metadata(place);
    default:
      return std::nullopt;
  }
}

template <class T, class Map>
Scanner::Problem Scanner::define(std::optional<T> one, std::size_t size, Map& map) {
  if (!one) return "a schema or channel that is not whole";
  const auto found = map.find(one->id);
  if (found != map.end()) {
    if (found->second == *one) return std::nullopt;
    return fmt::format("a schema or channel {} that differs from the one before", one->id.value);
  }
  if (size > limits_.definition_bytes - definition_bytes_)
    return fmt::format("more than {} bytes of schemas and channels", limits_.definition_bytes);
  definition_bytes_ += size;
  const auto id = one->id;
  map.emplace(id, *std::move(one));
  return std::nullopt;
}

Scanner::Problem Scanner::take_record(Opcode opcode, std::span<const std::byte> content, std::size_t offset) {
  if (opcode == Opcode::kSchema) return define(decode_schema(content), content.size(), summary().schemas);
  if (opcode == Opcode::kChannel) return define(decode_channel(content), content.size(), summary().channels);
  if (opcode == Opcode::kMessage) return take_message(content, offset);
  return std::nullopt;
}

Scanner::Problem Scanner::take_message(std::span<const std::byte> content, std::size_t offset) {
  const std::optional<Message> message = decode_message(content);
  if (!message) return "a message that is not whole";
  if (!summary().channels.contains(message->channel))
    return fmt::format("a message of channel {}, which nothing in front of it describes",
                       message->channel.value);
  found_.push_back({message->channel, {message->log_time, offset}});
  return std::nullopt;
}

Scanner::Problem Scanner::take_chunk(const Place& place) {
  settle_indexes();
  found_.clear();
  const auto content = content_of(place, most_chunk_length(limits_));
  if (!content) {
    out_.foreign = content.error();
    return content.error();
  }
  const auto chunk = decode_chunk(*content);
  if (!chunk) return "a chunk that is not whole";
  const auto records = records_of(*chunk, limits_, room_);
  if (!records) {
    const bool is_readable = chunk->head.compression.empty() || chunk->head.compression == "zstd";
    if (!is_readable || chunk->head.uncompressed_size > limits_.chunk_bytes) out_.foreign = records.error();
    return records.error();
  }
  if (Problem problem =
          each_record(*records, [&](Opcode opcode, std::span<const std::byte> one, std::size_t offset) {
            return take_record(opcode, one, offset);
          }))
    return "a chunk that is broken: " + *problem;
  finish_chunk(place, chunk->head);
  return std::nullopt;
}

void Scanner::count(const FoundMessage& message, Piece& piece) {
  Summary& all = summary();
  const std::uint64_t time = message.entry.log_time;
  piece.start_time = std::min(piece.start_time, time);
  piece.end_time = std::max(piece.end_time, time);
  all.start_time = all.message_count == 0 ? time : std::min(all.start_time, time);
  all.end_time = std::max(all.end_time, time);
  ++all.message_count;
  ++all.messages_of[message.channel];
  const auto at = std::ranges::lower_bound(piece.channels, message.channel);
  if (at == piece.channels.end() || *at != message.channel) piece.channels.insert(at, message.channel);
}

void Scanner::finish_chunk(const Place& place, const ChunkHead& head) {
  Piece piece{place.begin, place.end() - place.begin, UINT64_MAX, 0, {}, true};
  for (const FoundMessage& message : found_) count(message, piece);
  if (found_.empty()) piece.start_time = 0;
  ChunkIndex index;
  index.start_time = piece.start_time;
  index.end_time = piece.end_time;
  index.offset = piece.offset;
  index.length = piece.length;
  index.compression = head.compression;
  index.compressed_size = place.length - (4 * 8 + 4 + 4 + head.compression.size());
  index.uncompressed_size = head.uncompressed_size;
  summary().chunks.push_back(std::move(index));
  last_channels_ = piece.channels;
  if (!found_.empty()) out_.contents.pieces.push_back(std::move(piece));
  std::swap(last_, found_);
}

// Readers leave out chunks whose indexes name no channel that they want. So it has to be all of them.
void Scanner::settle_indexes() {
  if (summary().chunks.empty()) return;
  ChunkIndex& chunk = summary().chunks.back();
  std::ranges::sort(chunk.message_indexes);
  const auto channel_of = [](const auto& one) { return one.first; };
  if (std::ranges::equal(chunk.message_indexes, last_channels_, {}, channel_of)) return;
  chunk.message_indexes.clear();
  chunk.message_index_length = 0;
}

Scanner::Problem Scanner::take_message_index(const Place& place) {
  if (!is_behind_chunk_) return std::nullopt;
  const auto head =
      window_.at(place.content, static_cast<std::size_t>(std::min<std::uint64_t>(place.length, 2)));
  if (!head) return head.error();
  Cursor cursor(*head);
  const ChannelId channel = cursor.channel();
  if (!cursor.is_good()) return "an index of messages that is not whole";
  ChunkIndex& index = summary().chunks.back();
  index.message_indexes.emplace_back(channel, place.begin);
  index.message_index_length += place.end() - place.begin;
  return std::nullopt;
}

// They have no checksum. Among chunks, where none may be, one is rather another record that was changed.
Scanner::Problem Scanner::take_loose(const Place& place) {
  if (!summary().chunks.empty())
    return "a message outside of chunks, in a file that has its messages in chunks";
  if (out_.foreign.empty())
    out_.foreign = fmt::format("a message outside of chunks stands at byte {}", place.begin);
  if (place.length > limits_.chunk_bytes)
    return fmt::format("a message of {} bytes, where {} are the most that is read", place.length,
                       limits_.chunk_bytes);
  const auto head = window_.at(place.content,
                               static_cast<std::size_t>(std::min<std::uint64_t>(place.length, kMessageHead)));
  if (!head) return head.error();
  found_.clear();
  if (Problem problem = take_message(*head, 0)) return problem;
  std::vector<Piece>& pieces = out_.contents.pieces;
  const bool goes_on = !pieces.empty() && !pieces.back().is_chunk &&
                       pieces.back().offset + pieces.back().length == place.begin &&
                       place.end() - pieces.back().offset <= kMostLooseBytes;
  if (!goes_on) pieces.push_back({place.begin, 0, UINT64_MAX, 0, {}, false});
  pieces.back().length = place.end() - pieces.back().offset;
  count(found_.front(), pieces.back());
  return std::nullopt;
}

Scanner::Problem Scanner::take_attachment(const Place& place) {
  const auto first =
      window_.at(place.content, static_cast<std::size_t>(std::min(place.length, kMostNameBytes)));
  if (!first) return first.error();
  auto head = decode_attachment_head(*first, place.length);
  if (!head) return "an attachment that is not whole";
  head->index.offset = place.begin;
  head->index.length = place.end() - place.begin;
  summary().attachments.push_back(std::move(head->index));
  return std::nullopt;
}

Scanner::Problem Scanner::take_metadata(const Place& place) {
  const auto first =
      window_.at(place.content, static_cast<std::size_t>(std::min(place.length, kMostNameBytes)));
  if (!first) return first.error();
  Cursor cursor(*first);
  const std::string_view name = cursor.text();
  if (!cursor.is_good()) return "metadata that are not whole";
  summary().metadata.push_back({place.begin, place.end() - place.begin, std::string(name)});
  return std::nullopt;
}

}  // namespace

std::string Ending::sentence() const {
  if (is_whole) return {};
  std::string out = fmt::format("readable up to byte {} of {}: {}", readable_bytes, file_bytes, why);
  for (const Damage& damage : damages) out += fmt::format("; at byte {}: {}", damage.offset, damage.what);
  return out;
}

std::expected<Scan, std::string> scan(const Source& source, const Limits& limits,
                                      const std::string& why_not_summary) {
  return Scanner(source, limits).look_through(why_not_summary);
}

}  // namespace mlab::mcap
