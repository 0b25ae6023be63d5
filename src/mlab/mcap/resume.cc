// Going on with a file that was cut off.

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include <sys/stat.h>

#include <fmt/core.h>

#include "mlab/mcap/decode.h"
#include "mlab/mcap/writer_state.h"
#include "mlab/text/shown.h"

namespace mlab::mcap {
namespace {

// What the header of a file could be cut in: nothing was recorded by then.
bool ends_before_header(const Source& source) {
  constexpr std::uint64_t kBegin = kMagic.size() + kRecordHead;
  Buffer bytes(static_cast<std::size_t>(std::min(source.size(), kBegin)));
  if (source.read(0, bytes) != 0) return false;
  const std::size_t magic = std::min(bytes.size(), kMagic.size());
  if (!std::ranges::equal(std::span(bytes).first(magic), std::as_bytes(std::span(kMagic)).first(magic)))
    return false;
  Cursor head{std::span(bytes).subspan(magic)};
  if (head.is_at_end()) return true;
  if (head.number<std::uint8_t>() != static_cast<std::uint8_t>(Opcode::kHeader)) return false;
  constexpr std::uint64_t kMostHeader = std::uint64_t{1} << 20;
  const auto length = head.number<std::uint64_t>();
  return !head.is_good() || (length <= kMostHeader && length > source.size() - kBegin);
}

WriteError not_resumed(const std::string& path, int code, const std::string& why) {
  return {code, fmt::format("`{}` can't be continued: {}", text::shown(path, 200), why), 0, 0, 0};
}

std::string system_reason(int code) {
  if (code == EWOULDBLOCK) return "another process is writing it";
  if (code == EINVAL) return "it is no ordinary file";
  return std::generic_category().message(code);
}

/// Reads the bytes once more for their checksum.
int add_checksum(const Source& source, std::uint64_t size, std::uint32_t& crc) {
  constexpr std::uint64_t kStep = std::uint64_t{1} << 20;
  Buffer bytes;
  for (std::uint64_t at = 0; at < size; at += bytes.size()) {
    bytes.resize(static_cast<std::size_t>(std::min(kStep, size - at)));
    if (const int error = source.read(at, bytes); error != 0) return error;
    crc = crc32(bytes, crc);
  }
  return 0;
}

}  // namespace

void Writer::State::take(Summary found) {
  summary_ = std::move(found);
  for (const auto& [id, schema] : summary_.schemas) {
    schemas_by_name_[schema.name].push_back(id);
    definition_bytes_ += definition_size(schema);
  }
  for (const auto& [id, channel] : summary_.channels) {
    channels_by_topic_[channel.topic].push_back(id);
    definition_bytes_ += definition_size(channel);
    channel_at(id).is_there = true;
  }
  for (auto& [id, count] : summary_.messages_of) channel_at(id).count = &count;
  kept_messages_ = summary_.message_count;
}

int Writer::State::go_on(Scan found, const Source& source) {
  at_ = found.sound_end;
  take(std::move(found.contents.summary));
  if (found.last_chunk) {
    // The indexes of its messages are compared with what they should be: they may be cut, too.
    ChunkIndex& last = summary_.chunks.back();
    const std::uint64_t end = last.offset + last.length;
    for (const FoundMessage& one : *found.last_chunk) note(one.channel, one.entry);
    append_indexes(last, end);
    Buffer standing(static_cast<std::size_t>(at_ - end));
    if (const int error = source.read(end, standing); error != 0) return error;
    if (standing == out_) {
      out_.clear();
    } else {
      at_ = end;
    }
  }
  if (const int error = add_checksum(source, at_, crc_); error != 0) return error;
  return sink_->cut(at_);
}

std::expected<Writer::Resumed, WriteError> Writer::resume(const std::string& path,
                                                          const WriterOptions& options,
                                                          std::uint64_t most_bytes) {
  FileSink::Opened opened = FileSink::open(path);
  if (opened.sink == nullptr)
    return std::unexpected(not_resumed(path, opened.error, system_reason(opened.error)));
  const std::uint64_t size = opened.sink->size();
  const auto source = source_of(opened.sink->descriptor(), std::min(size, most_bytes));
  const auto state_of = [&] { return std::make_unique<State>(std::move(opened.sink), path, options); };
  if (ends_before_header(*source)) {
    if (const int error = opened.sink->cut(0); error != 0)
      return std::unexpected(not_resumed(path, error, system_reason(error)));
    auto state = state_of();
    if (auto written = state->begin(options.header); !written) return std::unexpected(written.error());
    return Resumed{Writer(std::move(state)), size, "it ends before its header does", true};
  }
  const Limits limits;
  const auto whole = contents_by_summary(*source, limits);
  auto found = scan(*source, limits, whole ? std::string() : whole.error());
  if (!found) return std::unexpected(not_resumed(path, EINVAL, found.error()));
  if (!found->foreign.empty()) return std::unexpected(not_resumed(path, EINVAL, found->foreign));
  std::string why = whole ? std::string() : found->contents.ending.sentence();
  auto state = state_of();
  if (const int error = state->go_on(*std::move(found), *source); error != 0)
    return std::unexpected(not_resumed(path, error, system_reason(error)));
  const std::uint64_t cut = size - state->file_bytes();
  if (auto written = state->put_out(); !written) return std::unexpected(written.error());
  return Resumed{Writer(std::move(state)), cut, std::move(why), false};
}

}  // namespace mlab::mcap
