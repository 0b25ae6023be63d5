#include "mlab/mcap/messages.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include <fmt/core.h>

#include "mlab/mcap/chunk_bytes.h"
#include "mlab/mcap/contents.h"
#include "mlab/mcap/decode.h"

namespace mlab::mcap {

/// A piece in memory, and which of its messages come next.
struct Messages::Open {
  struct Entry {
    std::uint64_t log_time;
    std::uint32_t offset;  // of the record in the records
  };
  std::uint64_t place = 0;  // in the file
  Room file_bytes;
  Room room;
  std::span<const std::byte> records;
  std::vector<Entry> entries;
  std::string problem;  // the piece can't be read; it has one entry, where that is to be told
  std::size_t at = 0;
  std::uint64_t bytes = 0;  // of memory, by which the open ones are counted

  auto key() const { return std::tuple(entries[at].log_time, place); }
};

namespace {

// For heaps whose first one is the earliest.
constexpr auto kIsLater = [](const auto& a, const auto& b) { return a->key() > b->key(); };

}  // namespace

Messages::Messages(std::shared_ptr<const Source> source, std::shared_ptr<const Contents> contents,
                   Limits limits, const Selection& selection)
    : source_(std::move(source)),
      contents_(std::move(contents)),
      limits_(limits),
      from_(selection.from),
      to_(selection.to) {
  limits_.chunk_bytes = std::min<std::uint64_t>(limits_.chunk_bytes, UINT32_MAX);
  for (const auto& [id, channel] : contents_->summary.channels) {
    const bool is_wanted = selection.topics.empty() ||
                           std::ranges::find(selection.topics, channel.topic) != selection.topics.end();
    if (!is_wanted) continue;
    wanted_.resize(std::max<std::size_t>(wanted_.size(), id.value + 1));
    wanted_[id.value] = true;
  }
  for (const Piece& piece : contents_->pieces) {
    if (may_have_some(piece)) waiting_.push_back(&piece);
  }
  std::ranges::stable_sort(waiting_, [](const Piece* a, const Piece* b) {
    return std::tuple(a->start_time, a->offset) > std::tuple(b->start_time, b->offset);
  });
}

Messages::~Messages() = default;
Messages::Messages(Messages&& from) noexcept = default;
Messages& Messages::operator=(Messages&& from) noexcept = default;

bool Messages::may_have_some(const Piece& piece) const {
  if (piece.start_time > to_ || piece.end_time < from_) return false;
  return piece.channels.empty() ||
         std::ranges::any_of(piece.channels, [&](ChannelId one) { return is_wanted(one); });
}

bool Messages::has_to_open() const {
  if (waiting_.empty()) return false;
  return open_.empty() || waiting_.back()->start_time <= std::get<0>(open_.front()->key());
}

text::Result<const Message*> Messages::next() {
  while (has_to_open()) {
    const Piece& piece = *waiting_.back();
    waiting_.pop_back();
    open(piece);
  }
  if (open_.empty()) return nullptr;
  std::ranges::pop_heap(open_, kIsLater);
  Open& earliest = *open_.back();
  if (!earliest.problem.empty()) {
    text::Diagnostic out{text::Severity::kError,
                         "broken-chunk",
                         fmt::format("at byte {}: {}", earliest.place, earliest.problem),
                         {},
                         {},
                         {},
                         {}};
    open_.pop_back();
    return std::unexpected(std::move(out));
  }
  const Open::Entry entry = earliest.entries[earliest.at++];
  Cursor cursor(earliest.records.subspan(entry.offset + 1));
  message_ = *decode_message(cursor.take(cursor.number<std::uint64_t>()));
  if (earliest.at < earliest.entries.size()) {
    std::ranges::push_heap(open_, kIsLater);
  } else {
    // Its memory holds the message that is given now; nothing is opened before the next call.
    open_bytes_ -= earliest.bytes;
    keep_spare(std::move(open_.back()));
    open_.pop_back();
  }
  return &message_;
}

void Messages::keep_spare(std::unique_ptr<Open> one) {
  constexpr std::size_t kMost = 2;
  if (spare_.size() == kMost) spare_.erase(spare_.begin());
  spare_.push_back(std::move(one));  // behind the others: the message that is given now lies in it
}

void Messages::open(const Piece& piece) {
  std::unique_ptr<Open> out = spare_.empty() ? std::make_unique<Open>() : std::move(spare_.back());
  if (!spare_.empty()) spare_.pop_back();
  auto problem = load(piece, *out);
  out->bytes =
      out->file_bytes.capacity() + out->room.capacity() + out->entries.capacity() * sizeof(Open::Entry);
  if (!problem && open_bytes_ + out->bytes > limits_.open_bytes)
    problem = fmt::format("so many chunks overlap in time that more than {} bytes would have to be kept",
                          limits_.open_bytes);
  if (problem || out->entries.empty()) {
    keep_spare(std::move(out));
    if (!problem) return;
    out = std::make_unique<Open>();
    out->place = piece.offset;
    out->problem = std::move(*problem);
    out->entries.push_back({piece.start_time, 0});
  }
  open_bytes_ += out->bytes;
  open_.push_back(std::move(out));
  std::ranges::push_heap(open_, kIsLater);
}

std::optional<std::string> Messages::load(const Piece& piece, Open& out) {
  const std::uint64_t most = piece.is_chunk ? most_chunk_length(limits_) : limits_.chunk_bytes + kRecordHead;
  if (piece.length > most)
    return fmt::format("a chunk of {} bytes, where {} are the most that is read", piece.length, most);
  const std::span<std::byte> bytes = out.file_bytes.of(static_cast<std::size_t>(piece.length));
  if (const int error = source_->read(piece.offset, bytes); error != 0) return read_problem(error);
  out.place = piece.offset;
  out.at = 0;
  if (!piece.is_chunk) return list(piece, bytes, out);
  Cursor cursor(bytes);
  const auto opcode = static_cast<Opcode>(cursor.number<std::uint8_t>());
  const auto length = cursor.number<std::uint64_t>();
  if (opcode != Opcode::kChunk || !cursor.is_good() || length != cursor.rest().size())
    return "no chunk stands here, though the summary says so";
  const auto chunk = decode_chunk(cursor.rest());
  if (!chunk) return "a chunk that is not whole";
  const auto records = records_of(*chunk, limits_, out.room);
  if (!records) return records.error();
  return list(piece, *records, out);
}

std::optional<std::string> Messages::list(const Piece& piece, std::span<const std::byte> records,
                                          Open& out) const {
  out.records = records;
  out.entries.clear();
  const auto& channels = contents_->summary.channels;
  auto problem = each_record(
      records,
      [&](Opcode opcode, std::span<const std::byte> content,
          std::size_t offset) -> std::optional<std::string> {
        if (opcode != Opcode::kMessage) return std::nullopt;
        const auto message = decode_message(content);
        if (!message) return "a message in it is not whole";
        const std::uint64_t time = message->log_time;
        if (time < piece.start_time || time > piece.end_time)
          return fmt::format("a message of time {} in a chunk that is said to hold those from {} to {}", time,
                             piece.start_time, piece.end_time);
        if (is_wanted(message->channel)) {
          if (time >= from_ && time <= to_) out.entries.push_back({time, static_cast<std::uint32_t>(offset)});
        } else if (!channels.contains(message->channel)) {
          return fmt::format("a message of channel {}, which nothing describes", message->channel.value);
        }
        return std::nullopt;
      });
  if (!std::ranges::is_sorted(out.entries, {}, &Open::Entry::log_time))
    std::ranges::stable_sort(out.entries, {}, &Open::Entry::log_time);
  return problem;
}

}  // namespace mlab::mcap
