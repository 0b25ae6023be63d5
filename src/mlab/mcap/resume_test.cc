#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "mlab/mcap/encode.h"
#include "mlab/mcap/reader.h"
#include "mlab/mcap/testing/sample.h"
#include "mlab/mcap/writer.h"

namespace mlab::mcap {
namespace {

using testing::all;
using testing::bytes_of;
using testing::file_of;
using testing::reader_of;
using testing::ScratchFile;
using testing::script_of;

std::string refusal(const ScratchFile& file) {
  const Buffer before = file.bytes();
  const auto resumed = Writer::resume(file.path());
  EXPECT_EQ(file.bytes(), before) << "it is as it was";
  if (resumed) return "";
  EXPECT_EQ(resumed.error().code, EINVAL);
  std::string out = resumed.error().message;
  const std::string subject = "`" + file.path() + "` can't be continued: ";
  return out.starts_with(subject) ? out.substr(subject.size()) : out;
}

TEST(McapResume, RefusesWhatItWouldDestroy) {
  const ScratchFile file;
  file.put(bytes_of("my diary"));
  EXPECT_EQ(
      refusal(file),
      "it begins with `my diary`, and an MCAP file with `\\x89MCAP0\\x0d\\x0a`: it is another kind of file");
  Buffer foreign;
  append_magic(foreign);
  append(foreign, Header{});
  const std::size_t begin = foreign.size();
  append(foreign, ChunkHead{0, 0, 3, 0, "lz4"}, bytes_of("abc"));
  file.put(foreign);
  EXPECT_EQ(refusal(file),
            "a chunk compressed by `lz4`, and this program reads `zstd` and uncompressed ones");
  foreign.resize(begin);
  append(foreign, Channel{{7}, {}, "/t", "json", {}});
  append(foreign, Message{{7}, 0, 0, 0, {}});
  file.put(foreign);
  EXPECT_EQ(refusal(file), "a message outside of chunks stands at byte 56");
  const auto nowhere = Writer::resume(file.folder() + "/none.mcap");
  ASSERT_FALSE(nowhere);
  EXPECT_EQ(nowhere.error().code, ENOENT);
}

TEST(McapResume, KeepsTheNumbersOfChannelsThatAreThere) {
  const ScratchFile file;
  file.put(file_of(script_of(9)));
  auto resumed = Writer::resume(file.path());
  ASSERT_TRUE(resumed) << resumed.error().message;
  EXPECT_EQ(resumed->writer.summary().end_time, 1080U);
  EXPECT_EQ(resumed->writer.add_schema({{}, "text", "jsonschema", "{\"type\": \"string\"}"}), SchemaId{1});
  EXPECT_EQ(resumed->writer.add_channel({{}, {1}, "/log", "json", {{"unit", "m"}}}), ChannelId{3});
  EXPECT_EQ(resumed->writer.add_channel({{}, {}, "/log", "json", {}}), ChannelId{4});
}

TEST(McapResume, SaysWhatItCutOff) {
  const ScratchFile file;
  Buffer bytes = file_of(script_of(9));
  const ChunkIndex last = reader_of(bytes).summary().chunks.back();
  bytes.resize(last.offset + 20);
  file.put(bytes);
  auto resumed = Writer::resume(file.path());
  ASSERT_TRUE(resumed);
  EXPECT_EQ(resumed->cut_bytes, 20U);
  EXPECT_FALSE(resumed->is_begun_anew);
  EXPECT_NE(resumed->why.find("the file ends with 11 of the "), std::string::npos) << resumed->why;
  EXPECT_NE(resumed->why.find(" bytes of a chunk: it was cut off"), std::string::npos) << resumed->why;
}

// A power cut can leave a file longer than what of it reached the disk.
TEST(McapResume, CutsOffZerosAndChunksThatWereWrittenInPart) {
  const ScratchFile file;
  const Buffer whole = file_of(script_of(9));
  const ChunkIndex last = reader_of(whole).summary().chunks.back();
  Buffer bytes = whole;
  std::fill(bytes.begin() + static_cast<std::ptrdiff_t>(last.offset + last.length - 10), bytes.end(),
            std::byte{0});
  file.put(bytes);
  auto resumed = Writer::resume(file.path());
  ASSERT_TRUE(resumed);
  EXPECT_EQ(resumed->writer.summary().message_count, 6U);
  EXPECT_EQ(resumed->cut_bytes, whole.size() - last.offset);
}

// The writer is killed at moments of which it knows nothing.
TEST(McapResume, WhatAKilledProcessHadFlushedIsThere) {
  const ScratchFile file;
  std::size_t had = 0;
  for (int round = 0; round < 8; ++round) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    const pid_t child = ::fork();
    if (child == 0) {
      auto resumed = round == 0 ? Writer::resume("/nowhere") : Writer::resume(file.path());
      auto writer = resumed ? std::move(resumed->writer) : *Writer::create(file.path());
      const ChannelId channel = *writer.add_channel({{}, {}, "/t", "json", {}});
      for (std::size_t i = writer.summary().message_count;; ++i) {
        const std::string data = std::to_string(i);
        if (!writer.write({channel, 0, i, i, bytes_of(data)})) ::_exit(1);
        if (i % 5 != 4) continue;
        if (!writer.flush()) ::_exit(1);
        const std::size_t flushed = i + 1;
        if (::write(ends[1], &flushed, sizeof flushed) != sizeof flushed) ::_exit(1);
      }
    }
    ::close(ends[1]);
    std::size_t flushed = 0;
    ASSERT_EQ(::read(ends[0], &flushed, sizeof flushed), static_cast<ssize_t>(sizeof flushed));
    std::this_thread::sleep_for(std::chrono::microseconds(300 * round));
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status));
    while (::read(ends[0], &flushed, sizeof flushed) == static_cast<ssize_t>(sizeof flushed)) continue;
    ::close(ends[0]);
    const auto reader = Reader::open(file.path());
    ASSERT_TRUE(reader) << reader.error().message;
    const auto messages = all(*reader);
    ASSERT_GE(messages.size(), flushed);
    ASSERT_GT(messages.size(), had);
    had = messages.size();
    for (std::size_t i = 0; i < had; ++i) ASSERT_EQ(messages[i].data, std::to_string(i));
  }
}

}  // namespace
}  // namespace mlab::mcap
