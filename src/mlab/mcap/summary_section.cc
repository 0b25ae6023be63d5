// The end of a file that was closed: footer and summary, held against the file and each other.

#include <algorithm>
#include <string_view>
#include <system_error>
#include <utility>

#include <cerrno>

#include <fmt/core.h>

#include "mlab/mcap/contents.h"
#include "mlab/mcap/decode.h"
#include "mlab/text/shown.h"

namespace mlab::mcap {
namespace {

constexpr std::uint64_t kMostHeaderBytes = std::uint64_t{1} << 20;
constexpr const char* kBrokenSummary = "its summary is broken: ";

/// Where the summary lies in the file, and its bytes.
struct SummaryBytes {
  std::uint64_t at = 0;
  Buffer records;
};

bool is_magic(std::span<const std::byte> bytes) {
  return std::ranges::equal(bytes, std::as_bytes(std::span(kMagic)));
}

std::expected<SummaryBytes, std::string> summary_bytes(const Source& source, const Limits& limits) {
  constexpr std::uint64_t kEnd = kFooterLength + kMagic.size();
  if (source.size() < kMagic.size() + kEnd) return std::unexpected("it has no end");
  const std::uint64_t footer_at = source.size() - kEnd;
  Buffer end(kEnd);
  if (const int error = source.read(footer_at, end); error != 0) return std::unexpected(read_problem(error));
  if (!is_magic(std::span(end).subspan(kFooterLength)))
    return std::unexpected(
        "it does not end as its writer ends it: it was cut off, or is still being written");
  Cursor cursor{std::span(end).first(kFooterLength)};
  const auto opcode = static_cast<Opcode>(cursor.number<std::uint8_t>());
  const auto length = cursor.number<std::uint64_t>();
  const auto footer = decode_footer(cursor.rest());
  if (opcode != Opcode::kFooter || length != cursor.rest().size() || !footer)
    return std::unexpected("no footer stands at its end");
  if (footer->summary_start == 0) return std::unexpected("it has no summary");
  if (footer->summary_start < kMagic.size() || footer->summary_start > footer_at)
    return std::unexpected(
        fmt::format("{}it is said to begin at byte {}", kBrokenSummary, footer->summary_start));
  if (footer_at - footer->summary_start > limits.definition_bytes)
    return std::unexpected(fmt::format("its summary has {} bytes, where {} are the most that is read",
                                       footer_at - footer->summary_start, limits.definition_bytes));
  SummaryBytes out{footer->summary_start, Buffer(footer_at - footer->summary_start)};
  if (const int error = source.read(out.at, out.records); error != 0)
    return std::unexpected(read_problem(error));
  constexpr std::size_t kCrc = 4;  // of all in front of it
  const std::uint32_t crc = crc32(std::span(end).first(kFooterLength - kCrc), crc32(out.records));
  if (footer->summary_crc != 0 && footer->summary_crc != crc)
    return std::unexpected(fmt::format("{}its checksum differs", kBrokenSummary));
  return out;
}

/// Takes records of a summary, and looks whether what they speak of lies inside of the data.
class SummaryTaker {
 public:
  explicit SummaryTaker(std::uint64_t data_end) : data_end_(data_end) {}

  std::optional<std::string> take(Opcode opcode, std::span<const std::byte> content) {
    switch (opcode) {
      case Opcode::kSchema:
        return keep_by_id(decode_schema(content), summary_.schemas);
      case Opcode::kChannel:
        return keep_by_id(decode_channel(content), summary_.channels);
      case Opcode::kChunkIndex:
        return keep_placed(decode_chunk_index(content), summary_.chunks);
      case Opcode::kAttachmentIndex:
        return keep_placed(decode_attachment_index(content), summary_.attachments);
      case Opcode::kMetadataIndex:
        return keep_placed(decode_metadata_index(content), summary_.metadata);
      case Opcode::kStatistics:
        statistics_ = decode_statistics(content);
        if (!statistics_) return "its statistics are not whole";
        return std::nullopt;
      default:
        return std::nullopt;
    }
  }

  // Whether it says all that one would find by looking through the file.
  std::optional<std::string> problem() const {
    if (!statistics_) return "it has no statistics";
    const Statistics& said = *statistics_;
    if (said.chunk_count != summary_.chunks.size() || said.attachment_count != summary_.attachments.size() ||
        said.metadata_count != summary_.metadata.size())
      return "it does not name all chunks, attachments and metadata";
    if (said.message_count > 0 && summary_.chunks.empty()) return "its messages stand outside of chunks";
    const auto is_known = [&](const auto& one) { return summary_.channels.contains(one.first); };
    const bool are_channels_known = std::ranges::all_of(said.messages_of, is_known) &&
                                    std::ranges::all_of(summary_.chunks, [&](const ChunkIndex& chunk) {
                                      return std::ranges::all_of(chunk.message_indexes, is_known);
                                    });
    if (!are_channels_known) return "it does not describe all channels";
    return std::nullopt;
  }

  Summary taken() {
    const auto by_place = [](const auto& one) { return one.offset; };
    std::ranges::stable_sort(summary_.chunks, {}, by_place);
    std::ranges::stable_sort(summary_.attachments, {}, by_place);
    std::ranges::stable_sort(summary_.metadata, {}, by_place);
    summary_.message_count = statistics_->message_count;
    summary_.start_time = statistics_->start_time;
    summary_.end_time = statistics_->end_time;
    summary_.messages_of = std::move(statistics_->messages_of);
    return std::move(summary_);
  }

 private:
  template <class T, class Map>
  static std::optional<std::string> keep_by_id(std::optional<T> one, Map& map) {
    if (!one) return "a schema or channel in it is not whole";
    const auto id = one->id;
    map.insert_or_assign(id, *std::move(one));
    return std::nullopt;
  }
  template <class T>
  std::optional<std::string> keep_placed(std::optional<T> one, std::vector<T>& list) {
    if (!one) return "an index in it is not whole";
    const bool is_inside = one->offset >= kMagic.size() && one->offset <= data_end_ &&
                           one->length >= kRecordHead && one->length <= data_end_ - one->offset;
    if (!is_inside)
      return fmt::format("it names {} bytes at byte {}, outside of the data", one->length, one->offset);
    list.push_back(*std::move(one));
    return std::nullopt;
  }

  std::uint64_t data_end_;
  Summary summary_;
  std::optional<Statistics> statistics_;
};

Piece piece_of(const ChunkIndex& chunk) {
  Piece out{chunk.offset, chunk.length, chunk.start_time, chunk.end_time, {}, true};
  for (const auto& [channel, offset] : chunk.message_indexes) out.channels.push_back(channel);
  return out;
}

std::string strange_beginning(std::span<const std::byte> bytes) {
  const std::string_view is(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const std::string_view wanted(reinterpret_cast<const char*>(kMagic.data()), kMagic.size());
  constexpr std::size_t kVersion = 5;
  if (is.substr(0, kVersion) == wanted.substr(0, kVersion) &&
      is.substr(kVersion + 1) == wanted.substr(kVersion + 1))
    return fmt::format("it is MCAP of version `{}`, and this program reads version `0`",
                       text::shown(is.substr(kVersion, 1)));
  return fmt::format("it begins with `{}`, and an MCAP file with `{}`: it is another kind of file",
                     text::shown(is), text::shown(wanted));
}

}  // namespace

std::string read_problem(int error) {
  if (error == ENODATA) return "it has become shorter while it was read";
  return fmt::format("it can't be read: {}", std::generic_category().message(error));
}

std::uint64_t most_chunk_length(const Limits& limits) {
  constexpr std::uint64_t kHead = 4096;
  return limits.chunk_bytes + limits.chunk_bytes / 64 + kHead;
}

std::expected<Header, std::string> read_header(const Source& source) {
  if (source.size() == 0) return std::unexpected("it is empty");
  Buffer bytes(std::min<std::uint64_t>(source.size(), kMagic.size()));
  if (const int error = source.read(0, bytes); error != 0) return std::unexpected(read_problem(error));
  if (!std::ranges::equal(bytes, std::as_bytes(std::span(kMagic)).first(bytes.size())))
    return std::unexpected(strange_beginning(bytes));
  bytes.resize(kRecordHead);
  const std::uint64_t begin = kMagic.size() + kRecordHead;
  const std::string cut = "it ends before its header does: it was cut off before anything was recorded";
  if (source.size() < begin) return std::unexpected(cut);
  if (const int error = source.read(kMagic.size(), bytes); error != 0)
    return std::unexpected(read_problem(error));
  Cursor head(bytes);
  const auto opcode = head.number<std::uint8_t>();
  const auto length = head.number<std::uint64_t>();
  if (opcode != static_cast<std::uint8_t>(Opcode::kHeader) || length > kMostHeaderBytes)
    return std::unexpected(fmt::format(
        "a record of kind {:#04x} with {} bytes stands first, and should be a header", opcode, length));
  if (length > source.size() - begin) return std::unexpected(cut);
  bytes.resize(static_cast<std::size_t>(length));
  if (const int error = source.read(begin, bytes); error != 0) return std::unexpected(read_problem(error));
  if (auto header = decode_header(bytes)) return *std::move(header);
  return std::unexpected("its header is not whole");
}

std::uint64_t behind_header(const Source& source) {
  Buffer bytes(kRecordHead);
  static_cast<void>(source.read(kMagic.size(), bytes));
  Cursor head{std::span(bytes).subspan(1)};
  return kMagic.size() + kRecordHead + head.number<std::uint64_t>();
}

std::expected<Contents, std::string> contents_by_summary(const Source& source, const Limits& limits) {
  const auto bytes = summary_bytes(source, limits);
  if (!bytes) return std::unexpected(bytes.error());
  SummaryTaker taker(bytes->at);
  auto problem = each_record(bytes->records, [&](Opcode opcode, std::span<const std::byte> content,
                                                 std::size_t) { return taker.take(opcode, content); });
  if (!problem) problem = taker.problem();
  if (problem) return std::unexpected(kBrokenSummary + *problem);
  Contents out;
  out.summary = taker.taken();
  for (const ChunkIndex& chunk : out.summary.chunks) out.pieces.push_back(piece_of(chunk));
  out.ending.readable_bytes = source.size();
  out.ending.file_bytes = source.size();
  return out;
}

}  // namespace mlab::mcap
