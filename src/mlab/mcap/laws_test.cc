// What holds of every recording: it is read as it was written, also in part, also where it was damaged, and
// one that is gone on with is the one that was never cut.

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "mlab/base/testing/processor_time.h"
#include "mlab/mcap/reader.h"
#include "mlab/mcap/testing/sample.h"
#include "mlab/mcap/writer.h"

namespace mlab::mcap {
namespace {

using testing::all;
using testing::file_of;
using testing::in_order;
using testing::reader_of;
using testing::Said;
using testing::ScratchFile;
using testing::Script;
using testing::script_of;

Script any_script() {
  Script out;
  const auto count = *rc::gen::inRange<std::size_t>(0, 60);
  for (std::size_t i = 0; i < count; ++i) {
    const auto* const topic = *rc::gen::element("/poses", "/events", "/log");
    const auto time =
        *rc::gen::oneOf(rc::gen::inRange<std::uint64_t>(0, 20), rc::gen::arbitrary<std::uint64_t>());
    out.messages.push_back({topic, *rc::gen::arbitrary<std::uint32_t>(), time,
                            *rc::gen::arbitrary<std::uint64_t>(), *rc::gen::string<std::string>()});
  }
  out.per_flush = *rc::gen::inRange<std::size_t>(1, 30);
  out.options.chunk_bytes = *rc::gen::inRange<std::size_t>(0, 2000);
  out.options.is_compressed = *rc::gen::arbitrary<bool>();
  out.options.level = *rc::gen::inRange(-1, 22);
  return out;
}

Buffer cut(const Buffer& file, std::size_t size) {
  return {file.begin(), file.begin() + static_cast<std::ptrdiff_t>(size)};
}

/// How many messages stand in chunks that end in front of this byte.
std::size_t messages_before(const Summary& summary, const Script& script, std::uint64_t byte) {
  std::size_t out = 0;
  for (const ChunkIndex& chunk : summary.chunks) {
    if (chunk.offset + chunk.length <= byte) out += script.per_flush;
  }
  return std::min(out, script.messages.size());
}

TEST(McapLaws, WhatIsWrittenIsReadWithAnySizeOfChunks) {
  EXPECT_TRUE(rc::check("read(written(x)) == x", [] {
    const Script script = any_script();
    const Buffer file = file_of(script);
    const Reader reader = reader_of(file);
    RC_ASSERT(reader.ending().is_whole);
    RC_ASSERT(all(reader) == in_order(script.messages));
    RC_ASSERT(reader.summary().message_count == script.messages.size());
  }));
}

TEST(McapLaws, LookedThroughAFileSaysWhatItsSummarySays) {
  EXPECT_TRUE(rc::check("scan(x) == summary(x)", [] {
    const Script script = any_script();
    const Buffer file = file_of(script);
    const Reader whole = reader_of(file);
    const Reader open = reader_of(cut(file, file.size() - 1));
    RC_ASSERT(!open.ending().is_whole);
    RC_ASSERT(open.ending().damages.empty());
    Summary wanted = whole.summary();
    if (script.messages.empty()) {  // nothing needed them, so they stood in the summary alone
      wanted.schemas.clear();
      wanted.channels.clear();
    }
    RC_ASSERT(open.summary() == wanted);
    const Buffer shorter = cut(file, file.size() - 1);
    RC_ASSERT(all(reader_of(shorter)) == in_order(script.messages));
  }));
}

TEST(McapLaws, ASelectionIsWhatOneWouldPickByHand) {
  EXPECT_TRUE(rc::check("messages(selection) == pick(messages(), selection)", [] {
    const Script script = any_script();
    const Buffer file = file_of(script);
    Selection selection;
    selection.topics = *rc::gen::container<std::vector<std::string>>(
        rc::gen::element<std::string>("/poses", "/events", "/nobody"));
    selection.from = *rc::gen::inRange<std::uint64_t>(0, 30);
    selection.to = *rc::gen::inRange<std::uint64_t>(0, 30);
    std::vector<Said> wanted = in_order(script.messages);
    std::erase_if(wanted, [&](const Said& one) {
      const auto& topics = selection.topics;
      return one.log_time < selection.from || one.log_time > selection.to ||
             (!topics.empty() && std::ranges::find(topics, one.topic) == topics.end());
    });
    RC_ASSERT(all(reader_of(file), selection) == wanted);
    const Buffer open = cut(file, file.size() - 1);
    RC_ASSERT(all(reader_of(open), selection) == wanted);
  }));
}

TEST(McapLaws, CutAnywhereItHasTheMessagesOfAllWholeChunks) {
  for (const bool is_compressed : {true, false}) {
    Script script = script_of(20);
    script.options.is_compressed = is_compressed;
    const Buffer file = file_of(script);
    const Summary summary = reader_of(file).summary();
    for (std::size_t size = 0; size < file.size(); ++size) {
      const Buffer part = cut(file, size);
      const auto reader = Reader::over(source_of(part), "run.mcap");
      std::vector<Said> wanted = script.messages;
      wanted.resize(messages_before(summary, script, size));
      if (!reader) {
        ASSERT_TRUE(wanted.empty());
        ASSERT_LT(size, 40U) << "only what has no header is refused: " << reader.error().message;
        continue;
      }
      ASSERT_FALSE(reader->ending().is_whole);
      ASSERT_LE(reader->ending().readable_bytes, size);
      ASSERT_FALSE(reader->ending().why.empty());
      ASSERT_TRUE(reader->ending().damages.empty()) << reader->ending().sentence();
      ASSERT_EQ(all(*reader), in_order(wanted)) << "cut at " << size;
    }
  }
}

TEST(McapLaws, GoneOnWithItIsTheFileThatWasNeverCut) {
  const Script script = script_of(20);
  const Buffer file = file_of(script);
  const Summary summary = reader_of(file).summary();
  const ScratchFile scratch;
  for (std::size_t size = file.size() % base::kNextExample; size <= file.size(); size += base::kNextExample) {
    scratch.put(cut(file, size));
    auto resumed = Writer::resume(scratch.path(), script.options);
    ASSERT_TRUE(resumed) << size << ": " << resumed.error().message;
    const std::size_t kept = messages_before(summary, script, size);
    ASSERT_EQ(resumed->writer.summary().message_count, kept) << size;
    ASSERT_LE(resumed->cut_bytes, size);
    ASSERT_EQ(resumed->why.empty(), size == file.size()) << resumed->why;
    ASSERT_TRUE(testing::play(resumed->writer, script, kept));
    ASSERT_TRUE(resumed->writer.close());
    ASSERT_EQ(scratch.bytes(), file) << "cut at " << size;
  }
}

// Cut again and again, at any place, with more and more messages.
TEST(McapLaws, GoneOnWithManyTimesNothingThatWasFlushedIsLost) {
  const ScratchFile scratch;
  EXPECT_TRUE(rc::check("resume(cut(resume(cut(x))))", [&] {
    Script script = any_script();
    script.has_extras = *rc::gen::arbitrary<bool>();
    scratch.put({});
    std::size_t kept = 0;
    for (int round = 0; round < 4; ++round) {
      auto resumed = Writer::resume(scratch.path(), script.options);
      RC_ASSERT(resumed.has_value());
      kept = resumed->writer.summary().message_count;
      RC_ASSERT(testing::play(resumed->writer, script, kept).has_value());
      RC_ASSERT(resumed->writer.close().has_value());
      const Buffer file = scratch.bytes();
      RC_ASSERT(all(reader_of(file)) == in_order(script.messages));
      scratch.put(cut(file, *rc::gen::inRange<std::size_t>(0, file.size() + 1)));
    }
  }));
}

/// Whether `is` is `whole` with some left out, and none changed.
bool is_left_of(const std::vector<Said>& is, const std::vector<Said>& whole) {
  auto at = whole.begin();
  return std::ranges::all_of(is, [&](const Said& one) {
    at = std::find(at, whole.end(), one);
    return at++ != whole.end();
  });
}

TEST(McapLaws, AByteThatWasChangedNeverMakesAnotherMessage) {
  Script script = script_of(9);
  for (const bool is_compressed : {true, false}) {
    script.options.is_compressed = is_compressed;
    const Buffer file = file_of(script);
    const std::vector<Said> whole = in_order(script.messages);
    for (std::size_t at = 0; at < file.size(); at += base::kNextExample) {
      for (const unsigned char flip : {0x01, 0xff}) {
        Buffer changed = file;
        changed[at] ^= static_cast<std::byte>(flip);
        for (const bool is_open : {false, true}) {
          if (is_open) changed.pop_back();
          const auto reader = Reader::over(source_of(changed), "run.mcap");
          if (!reader) continue;
          std::size_t broken = 0;
          ASSERT_TRUE(is_left_of(all(*reader, {}, &broken), whole)) << "byte " << at;
          const auto attachment = reader->attachment("mission.mdl");
          ASSERT_TRUE(!attachment || attachment->data == "UNIT scouts MOVETO ATK-AP1\n");
        }
      }
    }
  }
}

TEST(McapLaws, ManyChangedBytesNeitherStopItNorMakeOtherMessages) {
  const Script script = script_of(40);
  const Buffer file = file_of(script);
  const std::vector<Said> whole = in_order(script.messages);
  const ScratchFile scratch;
  EXPECT_TRUE(rc::check("flips", [&] {
    Buffer changed = file;
    const auto count = *rc::gen::inRange(1, 20);
    for (int i = 0; i < count; ++i) {
      const auto at = *rc::gen::inRange<std::size_t>(30, file.size());
      changed[at] = static_cast<std::byte>(*rc::gen::arbitrary<std::uint8_t>());
    }
    changed.resize(*rc::gen::inRange<std::size_t>(40, file.size() + 1));
    const Reader reader = reader_of(changed);
    std::size_t broken = 0;
    const std::vector<Said> is = all(reader, {}, &broken);
    RC_ASSERT(is_left_of(is, whole));
    // Going on with it loses nothing of what could be read.
    scratch.put(changed);
    auto resumed = Writer::resume(scratch.path(), script.options);
    if (!resumed) {
      RC_ASSERT(scratch.bytes() == changed);
      return;
    }
    const Reader before = reader_of(changed);
    RC_ASSERT(resumed->writer.close().has_value());
    const Buffer after = scratch.bytes();
    const Reader reopened = reader_of(after);
    RC_ASSERT(reopened.ending().sentence() == "");
    RC_ASSERT(before.ending().is_whole || all(reopened, {}, &broken) == is);
  }));
}

}  // namespace
}  // namespace mlab::mcap
