#include "mlab/mcap/writer.h"

#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/base/testing/count_allocations.h"
#include "mlab/mcap/reader.h"
#include "mlab/mcap/testing/sample.h"

namespace mlab::mcap {
namespace {

using testing::all;
using testing::bytes_of;
using testing::file_of;
using testing::in_order;
using testing::MemorySink;
using testing::reader_of;
using testing::ScratchFile;
using testing::script_of;

Message message(ChannelId channel, std::uint64_t time, std::string_view data) {
  return {channel, 0, time, time, bytes_of(data)};
}

Writer writer_into(const std::shared_ptr<Buffer>& bytes, const WriterOptions& options = {}) {
  return *Writer::onto(std::make_unique<MemorySink>(bytes), options);
}

TEST(McapWriter, WhatItWritesIsRead) {
  const testing::Script script = script_of(20);
  const Buffer file = file_of(script);
  const Reader reader = reader_of(file);
  EXPECT_TRUE(reader.ending().is_whole) << reader.ending().sentence();
  EXPECT_EQ(reader.header(), (Header{"", "missionlab"}));
  EXPECT_EQ(all(reader), in_order(script.messages));
  EXPECT_EQ(reader.summary().message_count, 20U);
  EXPECT_EQ(reader.summary().start_time, 995U);
  EXPECT_EQ(reader.summary().end_time, 1180U);
  EXPECT_EQ(reader.summary().chunks.size(), 7U);
  const Channel& channel = reader.summary().channels.at({1});
  EXPECT_EQ(channel, (Channel{{1}, {1}, "/poses", "json", {{"unit", "m"}}}));
  EXPECT_EQ(reader.summary().schemas.at({1}), (Schema{{1}, "text", "jsonschema", "{\"type\": \"string\"}"}));
  const auto attachment = reader.attachment("mission.mdl");
  ASSERT_TRUE(attachment) << attachment.error().message;
  EXPECT_EQ(*attachment, (Attachment{"mission.mdl", "text/plain", 5, 4, "UNIT scouts MOVETO ATK-AP1\n"}));
  const auto metadata = reader.metadata("versions");
  ASSERT_TRUE(metadata) << metadata.error().message;
  EXPECT_EQ(*metadata, (Metadata{"versions", {{"library", "3"}, {"seed", "7"}}}));
}

TEST(McapWriter, KnowsWhatItsSummarySays) {
  const auto bytes = std::make_shared<Buffer>();
  const testing::Script script = script_of(11);
  Writer writer = writer_into(bytes, script.options);
  ASSERT_TRUE(testing::play(writer, script));
  ASSERT_TRUE(writer.close());
  EXPECT_EQ(reader_of(*bytes).summary(), writer.summary());
}

TEST(McapWriter, AFileWithoutMessagesIsWhole) {
  const auto bytes = std::make_shared<Buffer>();
  Writer writer = writer_into(bytes);
  ASSERT_TRUE(writer.add_channel({{}, {}, "/never", "json", {}}));
  ASSERT_TRUE(writer.close());
  const Reader reader = reader_of(*bytes);
  EXPECT_TRUE(reader.ending().is_whole) << reader.ending().sentence();
  EXPECT_EQ(reader.summary().channels.at({1}).topic, "/never");
  EXPECT_TRUE(all(reader).empty());
}

TEST(McapWriter, GivesWhatSaysTheSameTheSameNumber) {
  const auto bytes = std::make_shared<Buffer>();
  Writer writer = writer_into(bytes);
  const Schema schema{{}, "a", "jsonschema", "{}"};
  EXPECT_EQ(writer.add_schema(schema), SchemaId{1});
  EXPECT_EQ(writer.add_schema({{}, "a", "jsonschema", "{ }"}), SchemaId{2});
  EXPECT_EQ(writer.add_schema(schema), SchemaId{1});
  EXPECT_EQ(writer.add_channel({{}, {1}, "/t", "json", {}}), ChannelId{1});
  EXPECT_EQ(writer.add_channel({{}, {2}, "/t", "json", {}}), ChannelId{2});
  EXPECT_EQ(writer.add_channel({{99}, {1}, "/t", "json", {}}), ChannelId{1});
  EXPECT_EQ(writer.summary().channels.size(), 2U);
}

TEST(McapWriter, RefusesWhatCanNotBeWrittenAndGoesOn) {
  const auto bytes = std::make_shared<Buffer>();
  Writer writer = writer_into(bytes);
  const auto nobody = writer.write(message(ChannelId{3}, 1, "x"));
  ASSERT_FALSE(nobody);
  EXPECT_EQ(nobody.error().code, EINVAL);
  EXPECT_EQ(nobody.error().message, "`recording`: a message of the channel 3, which nobody added");
  const auto orphan = writer.add_channel({{}, {5}, "/t", "json", {}});
  ASSERT_FALSE(orphan);
  EXPECT_EQ(orphan.error().message, "`recording`: the channel `/t` names the schema 5, which nobody added");
  const ChannelId channel = *writer.add_channel({{}, {}, "/t", "json", {}});
  const std::string large(kMostRecordBytes + 1, 'x');
  const auto refused = writer.write(message(channel, 1, large));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message, "`recording`: a message of 16777217 bytes, where 16777216 are the most");
  EXPECT_FALSE(writer.add_schema({{}, "a", "b", large}));
  EXPECT_EQ(writer.failure(), nullptr);
  ASSERT_TRUE(writer.write(message(channel, 2, std::string_view(large).substr(1))));
  ASSERT_TRUE(writer.close());
  const auto closed = writer.write(message(channel, 3, "x"));
  ASSERT_FALSE(closed);
  EXPECT_EQ(closed.error().message, "`recording`: it is closed");
  EXPECT_TRUE(writer.close());
  const Reader reader = reader_of(*bytes);
  ASSERT_EQ(all(reader).size(), 1U);
  EXPECT_TRUE(reader.ending().is_whole);
}

TEST(McapWriter, HasNumbersFor65535Channels) {
  const auto bytes = std::make_shared<Buffer>();
  Writer writer = writer_into(bytes);
  for (int i = 0; i < 65'535; ++i) ASSERT_TRUE(writer.add_channel({{}, {}, std::to_string(i), "json", {}}));
  const auto last = writer.add_channel({{}, {}, "one too many", "json", {}});
  ASSERT_FALSE(last);
  EXPECT_EQ(last.error().message, "`recording`: more than 65535 of a kind");
  ASSERT_TRUE(writer.write(message(ChannelId{65'535}, 1, "x")));
  ASSERT_TRUE(writer.close());
  EXPECT_EQ(reader_of(*bytes).summary().channels.size(), 65'535U);
}

TEST(McapWriter, WritesAMessageWithoutHeap) {
  const auto bytes = std::make_shared<Buffer>();
  bytes->reserve(std::size_t{1} << 22);
  Writer writer = writer_into(bytes);
  const ChannelId channel = *writer.add_channel({{}, {}, "/t", "json", {}});
  const std::string data(50, 'x');
  const auto second = [&] {
    bool is_good = true;
    for (std::uint64_t i = 0; i < 1000; ++i) is_good = is_good && writer.write(message(channel, i, data));
    return is_good;
  };
  ASSERT_TRUE(second() && writer.flush() && second() && writer.flush());
  const std::size_t before = base::allocation_count();
  ASSERT_TRUE(second());
  EXPECT_EQ(base::allocation_count(), before);
  ASSERT_TRUE(writer.flush());
  EXPECT_LE(base::allocation_count() - before, 3U) << "a chunk's index";
}

TEST(McapWriter, IsReadUpToTheLastFlushWhileItIsAtWork) {
  const ScratchFile file;
  auto writer = Writer::create(file.path());
  ASSERT_TRUE(writer) << writer.error().message;
  const ChannelId channel = *writer->add_channel({{}, {}, "/t", "json", {}});
  ASSERT_TRUE(writer->write(message(channel, 1, "kept")) && writer->sync());
  ASSERT_TRUE(writer->write(message(channel, 2, "not yet")));
  const auto reader = Reader::open(file.path());
  ASSERT_TRUE(reader) << reader.error().message;
  EXPECT_EQ(all(*reader).size(), 1U);
  const std::uint64_t size = std::filesystem::file_size(file.path());
  EXPECT_EQ(reader->ending().sentence(),
            "readable up to byte " + std::to_string(size) + " of " + std::to_string(size) +
                ": the file ends without a footer: it was cut off, or is still being written");
}

TEST(McapWriter, ClosesWhatNobodyClosed) {
  const ScratchFile file;
  {
    auto writer = Writer::create(file.path());
    ASSERT_TRUE(writer);
    ASSERT_TRUE(writer->write(message(*writer->add_channel({{}, {}, "/t", "json", {}}), 1, "x")));
  }
  const auto reader = Reader::open(file.path());
  ASSERT_TRUE(reader);
  EXPECT_TRUE(reader->ending().is_whole);
  EXPECT_EQ(all(*reader).size(), 1U);
}

TEST(McapWriter, ReplacesAFileButNoneThatIsBeingWritten) {
  const ScratchFile file;
  file.put(bytes_of("something else that is longer than an empty recording"));
  std::optional<Writer> first(*Writer::create(file.path()));
  const auto second = Writer::create(file.path());
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().code, EWOULDBLOCK);
  EXPECT_EQ(second.error().message, "`" + file.path() + "` can't be written: another process is writing it");
  EXPECT_FALSE(Writer::resume(file.path()));
  ASSERT_TRUE(first->close());
  first.reset();
  EXPECT_TRUE(Reader::open(file.path())->ending().is_whole);
}

TEST(McapWriter, TakesOrdinaryFilesOnly) {
  const ScratchFile file;
  const std::string pipe = file.folder() + "/pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  for (const std::string& path : {pipe, std::string("/dev/null")}) {
    const auto writer = Writer::create(path);
    ASSERT_FALSE(writer) << path;
    EXPECT_EQ(writer.error().message, "`" + path + "` can't be written: it is no ordinary file");
    const auto reader = Reader::open(path);
    ASSERT_FALSE(reader) << path;
    EXPECT_EQ(reader.error().message, "`" + path + "` can't be read: it is no ordinary file");
  }
  const auto nowhere = Writer::create(file.folder() + "/no/run.mcap");
  ASSERT_FALSE(nowhere);
  EXPECT_EQ(nowhere.error().code, ENOENT);
}

}  // namespace
}  // namespace mlab::mcap
