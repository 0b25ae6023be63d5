#include "mlab/history/recording_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/core.h>
#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include "mlab/mcap/protobuf_schema.h"
#include "mlab/mcap/reader.h"
#include "mlab/text/shown.h"

namespace mlab::history {
namespace {

constexpr std::string_view kTopics = "/mlab/";
constexpr std::chrono::seconds kFlushed{1};  // apart, at most

// `input`, `poses`, ...; empty where it is of a kind that this program does not know.
std::string kind_of(const wire::HistoryEntry& entry) {
  const auto* field = wire::HistoryEntry::descriptor()->FindFieldByNumber(entry.body_case());
  return field == nullptr ? "" : field->name();
}

text::Diagnostic problem_with(const char* kind, std::string message) {
  return {text::Severity::kError, kind, std::move(message), {}, {}, {}, {}};
}

std::unexpected<text::Diagnostic> no_recording(const std::string& path, const std::string& why) {
  return std::unexpected(
      problem_with("no-recording", fmt::format("`{}` is no recording of a run: {}", text::shown(path), why)));
}

// It may be otherwise the next time.
bool is_for_want_of_room(int code) {
  return code == ENOSPC || code == EDQUOT || code == EFBIG;
}

bool parse(const mcap::Message& message, wire::HistoryEntry& out) {
  return message.data.size() <= mcap::kMostRecordBytes &&
         out.ParseFromArray(message.data.data(), static_cast<int>(message.data.size()));
}

}  // namespace

RecordingWriter::RecordingWriter(std::string path, double started_at, mcap::Writer writer)
    : path_(std::move(path)),
      started_at_(started_at),
      writer_(std::move(writer)),
      flushed_(std::chrono::steady_clock::now()) {}

text::Result<std::unique_ptr<RecordingWriter>> RecordingWriter::create(const std::string& path,
                                                                       double started_at) {
  const int made = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (made < 0)
    return std::unexpected(problem_with(
        "can-not-write",
        errno == EEXIST
            ? fmt::format("`{}` is there already, and a recording is never written over", text::shown(path))
            : fmt::format("`{}` can't be written: {}", text::shown(path),
                          std::generic_category().message(errno))));
  ::close(made);
  auto writer = mcap::Writer::create(path);
  if (!writer) {
    ::unlink(path.c_str());  // nobody could read what there is of it
    return std::unexpected(
        problem_with("can-not-write",
                     fmt::format("`{}` can't be written: {}", text::shown(path), writer.error().message)));
  }
  return std::unique_ptr<RecordingWriter>(new RecordingWriter(path, started_at, std::move(*writer)));
}

namespace {

// What a file holds of a run.
struct Held {
  std::size_t entries = 0;
  std::uint64_t bytes = UINT64_MAX;  // that may stay: beyond them the run was ended
};

std::unexpected<text::Diagnostic> other_run(const std::string& path) {
  return std::unexpected(problem_with(
      "other-run", fmt::format("what is in `{}` is not the beginning of this run", text::shown(path))));
}

// Why a message is none of a run of which this entry stands there.
// @param found  what the message says
text::Diagnostic difference(const std::string& path, const wire::HistoryEntry& wanted,
                            const wire::HistoryEntry& found) {
  const bool is_of_another_version = wanted.has_beginning() && found.has_beginning() &&
                                     wanted.beginning().version() != found.beginning().version();
  if (!is_of_another_version) return other_run(path).error();
  return problem_with(
      "other-version",
      fmt::format("`{}` was written by version {} of missionlab, and this is {}", text::shown(path),
                  text::shown(found.beginning().version(), 60), wanted.beginning().version()));
}

// The end of a run stands in the last chunk, and all that would go with it is known: messages are written
// again.
text::Result<Held> without_end(const std::string& path, const mcap::Summary& summary, std::size_t entries) {
  if (summary.chunks.empty()) return other_run(path);
  const std::uint64_t last = summary.chunks.back().offset;
  const auto is_behind = [last](const auto& index) { return index.offset > last; };
  if (std::ranges::any_of(summary.metadata, is_behind) || std::ranges::any_of(summary.attachments, is_behind))
    return std::unexpected(problem_with(
        "added-to", fmt::format("something was added to `{}` behind the end of the run", text::shown(path))));
  return Held{entries, last};
}

// @errors  it holds something else
text::Result<Held> held_of(const std::string& path, const std::vector<wire::HistoryEntry>& entries) {
  auto reader = mcap::Reader::open(path);
  if (!reader) return std::unexpected(reader.error());
  std::size_t count = 0;
  std::size_t last = 0;
  std::size_t end = 0;  // number of the message that ends the run; 0: there is none
  mcap::Messages messages = reader->messages();
  wire::HistoryEntry found;
  for (auto one = messages.next();; one = messages.next()) {
    if (!one) return std::unexpected(one.error());
    if (*one == nullptr) break;
    const std::size_t number = (**one).sequence;
    const bool is_known = number > 0 && number <= entries.size();
    const std::string wanted = is_known ? entries[number - 1].SerializeAsString() : std::string();
    ++count;
    last = std::max(last, number);
    if (is_known && std::ranges::equal(std::as_bytes(std::span(wanted)), (**one).data)) continue;
    if (number == 0 || end != 0 || !parse(**one, found)) return other_run(path);
    if (!found.has_end())
      return is_known ? std::unexpected(difference(path, entries[number - 1], found)) : other_run(path);
    end = number;
  }
  if (count != last || (end != 0 && end != last)) return other_run(path);
  return end == 0 ? text::Result<Held>(Held{count}) : without_end(path, reader->summary(), count - 1);
}

}  // namespace

text::Result<std::unique_ptr<RecordingWriter>> RecordingWriter::go_on(
    const std::string& path, double started_at, const std::vector<wire::HistoryEntry>& entries) {
  const auto held = held_of(path, entries);
  if (!held) return std::unexpected(held.error());
  auto resumed = mcap::Writer::resume(path, {}, held->bytes);
  if (!resumed && is_for_want_of_room(resumed.error().code))
    return std::unexpected(problem_with(kNoRoom, resumed.error().message));
  const std::uint64_t stands = resumed ? resumed->writer.summary().message_count : 0;
  if (!resumed || (held->bytes == UINT64_MAX ? stands != held->entries : stands > held->entries))
    return std::unexpected(
        problem_with("can-not-write", fmt::format("`{}` can't be gone on with{}", text::shown(path),
                                                  resumed ? "" : ": " + resumed.error().message)));
  std::unique_ptr<RecordingWriter> out(new RecordingWriter(path, started_at, std::move(resumed->writer)));
  out->count_ = static_cast<std::uint32_t>(stands);
  out->has_begun_ =
      std::ranges::any_of(entries.begin(), entries.begin() + static_cast<std::ptrdiff_t>(stands),
                          &wire::HistoryEntry::has_beginning);
  for (std::size_t i = stands; i < entries.size(); ++i) out->put(entries[i]);
  out->flush();
  return out;
}

std::uint64_t RecordingWriter::time_of(double time) const {
  return static_cast<std::uint64_t>(std::max(0.0, started_at_ + time) * 1e9);
}

mcap::ChannelId RecordingWriter::channel_of(const wire::HistoryEntry& entry) {
  mcap::ChannelId& channel = channels_[entry.body_case()];
  if (channel.value == 0) channel = channel_of(std::string(kTopics) + kind_of(entry), entry);
  return channel;
}

mcap::ChannelId RecordingWriter::channel_of(const std::string& topic,
                                            const google::protobuf::Message& message) {
  const auto schema = writer_.add_schema(mcap::protobuf_schema(*message.GetDescriptor()));
  if (!schema) {
    note(schema.error());
    return {};
  }
  const auto added = writer_.add_channel({.schema = *schema, .topic = topic, .message_encoding = "protobuf"});
  if (added) return *added;
  note(added.error());
  return {};
}

void RecordingWriter::note(const mcap::WriteError& error) {
  if (!problem_.empty()) return;
  problem_ = fmt::format("`{}` does not go on: {}", text::shown(path_), error.message);
}

void RecordingWriter::put(const wire::HistoryEntry& entry) {
  if (!problem_.empty()) return;
  const mcap::ChannelId channel = channel_of(entry);
  if (!problem_.empty()) return;
  bytes_.clear();
  entry.AppendToString(&bytes_);
  write(channel, entry.time());
  if (entry.has_input() || entry.has_beginning() || std::chrono::steady_clock::now() >= flushed_ + kFlushed)
    flush();
  has_begun_ = has_begun_ || (entry.has_beginning() && problem_.empty());
}

void RecordingWriter::put_beside(const std::string& topic, const google::protobuf::Message& message,
                                 double time) {
  if (!problem_.empty()) return;
  mcap::ChannelId& channel = beside_[topic];
  if (channel.value == 0) channel = channel_of(topic, message);
  if (!problem_.empty()) return;
  bytes_.clear();
  message.AppendToString(&bytes_);
  write(channel, time);
}

bool RecordingWriter::put_metadata(const mcap::Metadata& metadata) {
  if (!problem_.empty()) return false;
  if (const auto added = writer_.add(metadata); !added) note(added.error());
  is_flushed_ = false;
  flush();
  return problem_.empty();
}

void RecordingWriter::write(mcap::ChannelId channel, double time) {
  const std::uint64_t at = time_of(time);
  const auto written =
      writer_.write({channel, ++count_, at, at, std::as_bytes(std::span(bytes_.data(), bytes_.size()))});
  if (!written) {
    note(written.error());
    return;
  }
  is_flushed_ = false;
}

void RecordingWriter::flush() {
  if (is_flushed_ || !problem_.empty()) return;
  is_flushed_ = true;
  flushed_ = std::chrono::steady_clock::now();
  if (const auto flushed = writer_.flush(); !flushed) note(flushed.error());
}

void RecordingWriter::close() {
  if (const auto closed = writer_.close(); !closed) note(closed.error());
}

text::Result<RecordingSummary> summarize_recording(const std::string& path) {
  auto reader = mcap::Reader::open(path);
  if (!reader) return std::unexpected(reader.error());
  RecordingSummary out;
  bool has_begun = false;
  mcap::Messages messages = reader->messages({.topics = {"/mlab/beginning", "/mlab/end"}});
  wire::HistoryEntry entry;
  for (auto one = messages.next(); one && *one != nullptr; one = messages.next()) {
    if (!parse(**one, entry)) continue;
    if (entry.has_end()) out.outcome = entry.end().outcome();
    if (!entry.has_beginning()) continue;
    has_begun = true;
    out.mission = entry.beginning().mission().path();
    out.version = entry.beginning().version();
    out.seed = entry.beginning().seed();
    out.started_at = entry.beginning().started_at();
  }
  if (!has_begun) return no_recording(path, "it has no channel `/mlab/beginning`");
  const mcap::Summary& summary = reader->summary();
  out.length = static_cast<double>(summary.end_time - std::min(summary.start_time, summary.end_time)) * 1e-9;
  return out;
}

text::Result<Recording> read_recording(const std::string& path) {
  auto reader = mcap::Reader::open(path);
  if (!reader) return std::unexpected(reader.error());
  const auto history = std::make_shared<History>();
  Recording out{history, reader->ending().sentence(),
                reader->ending().is_broken || !reader->ending().damages.empty()};
  mcap::Selection wanted;
  for (const auto& [id, channel] : reader->summary().channels) {
    if (channel.topic.starts_with(kTopics)) wanted.topics.push_back(channel.topic);
  }
  if (wanted.topics.empty()) return no_recording(path, "it has no channel `/mlab/beginning`");
  mcap::Messages messages = reader->messages(wanted);
  wire::HistoryEntry entry;
  for (auto one = messages.next();; one = messages.next()) {
    // What comes behind a gap can't be told from what would have come.
    if (!one) {
      out.cut = one.error().message;
      out.is_damaged = true;
      break;
    }
    if (*one == nullptr) break;
    const std::optional<std::string> problem =
        parse(**one, entry) ? history->add(entry) : "a message can't be understood";
    if (!problem) continue;
    if (!history->has_begun()) return no_recording(path, *problem);
    out.cut = fmt::format("readable up to cycle {}: {}", history->last_cycle(), *problem);
    out.is_damaged = true;
    break;
  }
  if (!history->has_begun()) return no_recording(path, out.cut.empty() ? "nothing is in it" : out.cut);
  return out;
}

}  // namespace mlab::history
