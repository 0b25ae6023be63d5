#include "mlab/mcap/testing/sample.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <utility>

#include <stdlib.h>
#include <unistd.h>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace mlab::mcap::testing {
namespace {

constexpr std::array<const char*, 3> kTopics = {"/poses", "/events", "/log"};

Attachment mission() {
  return {"mission.mdl", "text/plain", 5, 4, "UNIT scouts MOVETO ATK-AP1\n"};
}
Metadata versions() {
  return {"versions", {{"library", "3"}, {"seed", "7"}}};
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const Said& said) {
  return out << fmt::format("{} #{} at {} ({}): {}", said.topic, said.sequence, said.log_time,
                            said.publish_time, said.data);
}

int MemorySink::append(std::span<const std::byte> bytes) {
  const std::size_t fits = std::min(bytes.size(), room_ - std::min(room_, bytes_->size()));
  bytes_->insert(bytes_->end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(fits));
  return fits == bytes.size() ? 0 : error_;
}

int MemorySink::cut(std::uint64_t size) {
  if (size > bytes_->size()) return EINVAL;
  bytes_->resize(static_cast<std::size_t>(size));
  return 0;
}

std::span<const std::byte> bytes_of(std::string_view text) {
  return std::as_bytes(std::span(text));
}

Script script_of(std::size_t messages) {
  Script out;
  for (std::size_t i = 0; i < messages; ++i) {
    const std::uint64_t time = 1000 + 10 * i - (i % 4 == 3 ? 35 : 0);
    out.messages.push_back({kTopics[(i + i / 4) % kTopics.size()], static_cast<std::uint32_t>(i), time,
                            time - 1, fmt::format("message {}", i)});
  }
  return out;
}

Written play(Writer& writer, const Script& script, std::size_t from) {
  const auto schema = writer.add_schema({{}, "text", "jsonschema", "{\"type\": \"string\"}"});
  if (!schema) return std::unexpected(schema.error());
  std::map<std::string, ChannelId> channels;
  for (const char* topic : kTopics) {
    const auto channel = writer.add_channel({{}, *schema, topic, "json", {{"unit", "m"}}});
    if (!channel) return std::unexpected(channel.error());
    channels.emplace(topic, *channel);
  }
  for (std::size_t i = from; i <= script.messages.size(); ++i) {
    Written written;
    if (i > 0 && i % script.per_flush == 0) written = writer.flush();
    const std::size_t flushes = i / script.per_flush;
    const bool is_at_flush = i % script.per_flush == 0 && script.has_extras;
    if (written && is_at_flush && flushes == 1 && writer.summary().attachments.empty())
      written = writer.attach(mission());
    if (written && is_at_flush && flushes == 2 && writer.summary().metadata.empty())
      written = writer.add(versions());
    if (written && i < script.messages.size()) {
      const Said& one = script.messages[i];
      written = writer.write(
          {channels.at(one.topic), one.sequence, one.log_time, one.publish_time, bytes_of(one.data)});
    }
    if (!written) return written;
  }
  return {};
}

Buffer file_of(const Script& script) {
  const auto bytes = std::make_shared<Buffer>();
  auto writer = Writer::onto(std::make_unique<MemorySink>(bytes), script.options);
  EXPECT_TRUE(writer);
  EXPECT_TRUE(play(*writer, script));
  EXPECT_TRUE(writer->close());
  return *bytes;
}

Reader reader_of(const Buffer& bytes, const Limits& limits) {
  auto reader = Reader::over(source_of(bytes), "run.mcap", limits);
  EXPECT_TRUE(reader) << reader.error().message;
  return *std::move(reader);
}

std::vector<Said> all(const Reader& reader, const Selection& selection, std::size_t* broken) {
  std::vector<Said> out;
  Messages messages = reader.messages(selection);
  for (;;) {
    const auto one = messages.next();
    if (!one && broken != nullptr) {
      ++*broken;
      continue;
    }
    EXPECT_TRUE(one) << one.error().message;
    if (!one || *one == nullptr) return out;
    const Message& is = **one;
    out.push_back({reader.summary().channels.at(is.channel).topic, is.sequence, is.log_time, is.publish_time,
                   std::string(reinterpret_cast<const char*>(is.data.data()), is.data.size())});
  }
}

std::vector<Said> in_order(std::vector<Said> messages) {
  std::multimap<std::uint64_t, Said> sorted;  // equal ones as they came
  for (Said& one : messages) sorted.emplace(one.log_time, std::move(one));
  messages.clear();
  for (auto& [time, one] : sorted) messages.push_back(std::move(one));
  return messages;
}

ScratchFile::ScratchFile() {
  // In memory where there is such a place: thousands of files are cut, and no disk is meant.
  const std::filesystem::path memory = "/dev/shm";
  const auto where = ::access(memory.c_str(), W_OK) == 0 ? memory : std::filesystem::temp_directory_path();
  std::string name = (where / "mcap-XXXXXX").string();
  folder_ = ::mkdtemp(name.data()) == nullptr ? "" : name;
  path_ = folder_ + "/run.mcap";
}

ScratchFile::~ScratchFile() {
  std::error_code ignored;
  if (!folder_.empty()) std::filesystem::remove_all(folder_, ignored);
}

void ScratchFile::put(std::span<const std::byte> bytes) const {
  std::ofstream file(path_, std::ios::binary | std::ios::trunc);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

Buffer ScratchFile::bytes() const {
  std::ifstream file(path_, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(file), {});
  const auto bytes = bytes_of(text);
  return {bytes.begin(), bytes.end()};
}

}  // namespace mlab::mcap::testing
