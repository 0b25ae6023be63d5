// Recordings: any bytes are refused with a sentence, or read to the end; and what is gone on with is whole
// afterwards, with every message that could be read before.

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>

#include "mlab/mcap/reader.h"
#include "mlab/mcap/writer.h"

namespace {

using namespace mlab;

// Steps that a reader of a small file never needs.
constexpr int kMany = 10'000'000;

std::uint64_t read_all(const mcap::Reader& reader, const mcap::Selection& selection) {
  std::uint64_t count = 0;
  std::uint64_t time = 0;
  mcap::Messages messages = reader.messages(selection);
  for (int step = 0;; ++step) {
    if (step == kMany) std::abort();
    const auto one = messages.next();
    if (!one) continue;
    if (*one == nullptr) return count;
    if ((*one)->log_time < time || !reader.summary().channels.contains((*one)->channel)) std::abort();
    time = (*one)->log_time;
    ++count;
  }
}

void look_at(const mcap::Reader& reader) {
  read_all(reader, {});
  const auto& channels = reader.summary().channels;
  if (!channels.empty()) {
    const std::uint64_t middle = reader.summary().start_time / 2 + reader.summary().end_time / 2;
    read_all(reader, {.topics = {channels.begin()->second.topic}, .from = middle});
  }
  for (const auto& one : reader.summary().attachments) {
    const auto is = reader.attachment(one);
    if (is && is->data.size() > reader.ending().file_bytes) std::abort();
  }
  for (const auto& one : reader.summary().metadata) {
    const auto is = reader.metadata(one);
    if (is && is->values.size() > reader.ending().file_bytes) std::abort();
  }
  static_cast<void>(reader.ending().sentence());
}

void go_on_with(const std::string& path) {
  const auto before = mcap::Reader::open(path);
  const std::uint64_t count = before && !before->ending().is_whole ? read_all(*before, {}) : 0;
  auto resumed = mcap::Writer::resume(path);
  if (!resumed) return;
  const auto channel = resumed->writer.add_channel({.topic = "/fuzz", .message_encoding = "json"});
  if (channel && !resumed->writer.write({.channel = *channel})) std::abort();
  if (!resumed->writer.close()) std::abort();
  const auto after = mcap::Reader::open(path);
  if (!after || !after->ending().is_whole) std::abort();
  if (read_all(*after, {}) < count + (channel ? 1 : 0)) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span<const std::byte> bytes = std::as_bytes(std::span(data, size));
  const mcap::Limits limits{.chunk_bytes = 1 << 20, .open_bytes = 4 << 20};
  if (const auto reader = mcap::Reader::over(mcap::source_of(bytes), "fuzz", limits)) look_at(*reader);
  const int file = ::memfd_create("recording", 0);
  if (file < 0) return 0;
  if (::write(file, data, size) == static_cast<ssize_t>(size))
    go_on_with("/proc/self/fd/" + std::to_string(file));
  ::close(file);
  return 0;
}
