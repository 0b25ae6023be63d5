#include "mlab/mcap/reader.h"

#include <zstd.h>

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "mlab/mcap/encode.h"
#include "mlab/mcap/testing/sample.h"

namespace mlab::mcap {
namespace {

using testing::all;
using testing::bytes_of;
using testing::file_of;
using testing::reader_of;
using testing::Said;
using testing::ScratchFile;
using testing::script_of;

Message message(std::uint32_t channel, std::uint64_t time, std::string_view data = "x") {
  return {{channel}, 0, time, time, bytes_of(data)};
}

std::vector<std::uint64_t> times(const std::vector<Said>& messages) {
  std::vector<std::uint64_t> out;
  for (const Said& one : messages) out.push_back(one.log_time);
  return out;
}

std::string problem_with(std::string_view bytes) {
  const auto reader = Reader::over(source_of(bytes_of(bytes)), "run.mcap");
  return reader ? "" : reader.error().message;
}

/// The beginning of a file, as somebody else writes it.
Buffer beginning() {
  Buffer out;
  append_magic(out);
  append(out, Header{"", "somebody"});
  append(out, Channel{{7}, {}, "/t", "json", {}});
  return out;
}

Buffer records_of(std::initializer_list<Message> messages) {
  Buffer out;
  for (const Message& one : messages) append(out, one);
  return out;
}

void append_chunk(Buffer& out, std::span<const std::byte> records, std::string_view compression,
                  std::uint64_t uncompressed_size, std::uint32_t crc = 0) {
  append(out, ChunkHead{0, 100, uncompressed_size, crc, compression}, records);
}

/// What looking through it says of its only damage.
std::string damage_of(const Buffer& file) {
  const Reader reader = reader_of(file);
  EXPECT_TRUE(all(reader).empty());
  if (reader.ending().damages.size() != 1) return reader.ending().sentence();
  return reader.ending().damages.front().what;
}

TEST(McapReader, SaysWhatAFileIsInsteadOfMcap) {
  EXPECT_EQ(problem_with(""), "`run.mcap`: it is empty");
  EXPECT_EQ(
      problem_with("#ROSBAG V2.0\n"),
      "`run.mcap`: it begins with `#ROSBAG `, and an MCAP file with `\\x89MCAP0\\x0d\\x0a`: it is another "
      "kind of file");
  EXPECT_EQ(problem_with("\x89MCAP1\r\n"),
            "`run.mcap`: it is MCAP of version `1`, and this program reads version `0`");
  EXPECT_EQ(problem_with("\x89MCA"),
            "`run.mcap`: it ends before its header does: it was cut off before anything was recorded");
  EXPECT_EQ(problem_with(std::string("\x89MCAP0\r\n\x05\x02\0\0\0\0\0\0\0ab", 19)),
            "`run.mcap`: a record of kind 0x05 with 2 bytes stands first, and should be a header");
  const auto nowhere = Reader::open("/nowhere/run.mcap");
  ASSERT_FALSE(nowhere);
  EXPECT_EQ(nowhere.error().message, "`/nowhere/run.mcap` can't be read: No such file or directory");
}

TEST(McapReader, SaysWhatTheFileDoesNotHave) {
  const Buffer file = file_of(script_of(5));
  const Reader reader = reader_of(file);
  EXPECT_EQ(reader.attachment("overlay.odl").error().message,
            "`run.mcap`: it has no attachment `overlay.odl`");
  EXPECT_EQ(reader.metadata("people").error().message, "`run.mcap`: it has no metadata `people`");
  EXPECT_TRUE(all(reader, {.topics = {"/nobody"}}).empty());
}

TEST(McapReader, GivesTheLastOfSeveralAttachmentsWithOneName) {
  const auto bytes = std::make_shared<Buffer>();
  auto writer = Writer::onto(std::make_unique<testing::MemorySink>(bytes));
  ASSERT_TRUE(writer->attach({"a", "", 1, 1, "old"}) && writer->attach({"a", "", 2, 2, "new"}));
  ASSERT_TRUE(writer->add(Metadata{"m", {{"k", "old"}}}) && writer->add(Metadata{"m", {{"k", "new"}}}));
  ASSERT_TRUE(writer->close());
  const Reader reader = reader_of(*bytes);
  EXPECT_EQ(reader.attachment("a")->data, "new");
  EXPECT_EQ(reader.attachment(reader.summary().attachments.front())->data, "old");
  EXPECT_EQ(reader.metadata("m")->values.at("k"), "new");
}

TEST(McapReader, ReadsOnlyTheChunksThatMayHaveWhatIsWanted) {
  /// Counts what is read.
  class Counted final : public Source {
   public:
    explicit Counted(const Buffer& bytes) : bytes_(bytes), inner_(source_of(bytes)) {}
    std::uint64_t size() const override { return bytes_.size(); }
    int read(std::uint64_t offset, std::span<std::byte> out) const override {
      count += out.size();
      return inner_->read(offset, out);
    }
    mutable std::uint64_t count = 0;

   private:
    const Buffer& bytes_;
    std::shared_ptr<const Source> inner_;
  };
  testing::Script script = script_of(30'000);
  script.per_flush = 100;
  const Buffer file = file_of(script);
  const auto source = std::make_shared<Counted>(file);
  const auto reader = Reader::over(source, "run.mcap");
  ASSERT_TRUE(reader && reader->ending().is_whole);
  EXPECT_LT(source->count, file.size() / 8) << "the summary";
  source->count = 0;
  EXPECT_EQ(all(*reader, {.from = 100'000, .to = 101'000}).size(), 101U);
  EXPECT_LT(source->count, file.size() / 100) << "two or three of 300 chunks";
}

TEST(McapReader, PutsMessagesOfChunksThatOverlapInOrder) {
  Buffer file = beginning();
  for (const Buffer& records :
       {records_of({message(7, 30), message(7, 10, "a"), message(7, 20, "a")}),
        records_of({message(7, 20, "b"), message(7, 5), message(7, 25)}), records_of({message(7, 20, "c")}),
        records_of({message(7, 40), message(7, 10, "d")})})
    append_chunk(file, records, "", records.size(), crc32(records));
  const std::vector<Said> is = all(reader_of(file));
  EXPECT_EQ(times(is), (std::vector<std::uint64_t>{5, 10, 10, 20, 20, 20, 25, 30, 40}));
  std::string equal;
  for (const Said& one : is) equal += one.log_time % 10 == 0 && one.log_time < 30 ? one.data : "";
  EXPECT_EQ(equal, "adabc") << "those of one time in the order of the file";
}

TEST(McapReader, ReadsMessagesOutsideOfChunks) {
  Buffer file = beginning();
  for (const std::uint64_t time : {3, 1, 2}) append(file, message(7, time));
  append(file, Metadata{"between", {}});
  append(file, message(7, 0));
  const std::size_t whole = file.size();
  append_data_end(file, 0);
  Summary summary;
  summary.message_count = 4;
  append_end(file, summary, file.size());
  const Reader reader = reader_of(file);
  EXPECT_EQ(times(all(reader)), (std::vector<std::uint64_t>{0, 1, 2, 3}));
  EXPECT_EQ(reader.ending().why, "its summary is broken: its messages stand outside of chunks");
  file.resize(whole);
  const Reader open = reader_of(file);
  EXPECT_EQ(times(all(open, {.from = 1, .to = 2})), (std::vector<std::uint64_t>{1, 2}));
  EXPECT_EQ(open.summary().messages_of.at({7}), 4U);
}

TEST(McapReader, TakesNoMessageOutsideOfChunksBehindAChunk) {
  Buffer file = beginning();
  const Buffer records = records_of({message(7, 1)});
  append_chunk(file, records, "", records.size());
  append(file, message(7, 2));
  const Reader reader = reader_of(file);
  EXPECT_EQ(all(reader).size(), 1U);
  EXPECT_EQ(reader.ending().damages.at(0).what,
            "a message outside of chunks, in a file that has its messages in chunks");
}

TEST(McapReader, SkipsRecordsThatItDoesNotKnowAndFieldsBehindThoseItKnows) {
  Buffer file = beginning();
  for (const unsigned char opcode : {0x10, 0x7f, 0x80, 0xff}) {
    Buffer unknown;
    append(unknown, Metadata{"unknown", {}});
    unknown.front() = static_cast<std::byte>(opcode);
    file.insert(file.end(), unknown.begin(), unknown.end());
  }
  Buffer records = records_of({message(7, 1)});
  Buffer longer;
  append(longer, Channel{{8}, {}, "/u", "json", {}});
  longer.push_back(std::byte{0xee});
  longer[1] = static_cast<std::byte>(std::to_integer<unsigned>(longer[1]) + 1);
  records.insert(records.end(), longer.begin(), longer.end());
  append(records, message(8, 2));
  append_chunk(file, records, "", records.size());
  const Reader reader = reader_of(file);
  EXPECT_TRUE(reader.ending().damages.empty()) << reader.ending().sentence();
  EXPECT_EQ(all(reader).size(), 2U);
  EXPECT_TRUE(reader.summary().metadata.empty());
}

TEST(McapReader, RefusesChunksThatItCanNotDecompressByTheirName) {
  Buffer file = beginning();
  append_chunk(file, bytes_of("abc"), "lz4", 3);
  EXPECT_EQ(damage_of(file),
            "a chunk compressed by `lz4`, and this program reads `zstd` and uncompressed ones");
}

TEST(McapReader, BelievesNoSizeThatAChunkSays) {
  const Buffer records = records_of({message(7, 1)});
  const auto damage = [&](std::span<const std::byte> bytes, std::string_view compression,
                          std::uint64_t size) {
    Buffer file = beginning();
    append_chunk(file, bytes, compression, size);
    return damage_of(file);
  };
  EXPECT_EQ(damage(records, "", records.size() + 1),
            "a chunk that says it has 33 bytes uncompressed, and has 32");
  EXPECT_EQ(damage(records, "", UINT64_MAX),
            "a chunk of 18446744073709551615 bytes, where 67108864 are the most that is read");
  EXPECT_EQ(damage(bytes_of("tiny"), "zstd", std::uint64_t{60} << 20),
            "a chunk that says it has 62914560 bytes, which never come out of 4");
  // A bomb: 32 MiB of zeros, which says it has none of them.
  const std::string zeros(std::size_t{32} << 20, '\0');
  Buffer bomb(ZSTD_compressBound(zeros.size()));
  bomb.resize(ZSTD_compress(bomb.data(), bomb.size(), zeros.data(), zeros.size(), 1));
  ASSERT_LT(bomb.size(), 20'000U);
  EXPECT_EQ(damage(bomb, "zstd", 100),
            "a chunk that can't be decompressed by zstd: Destination buffer is too small");
  Buffer file = beginning();
  append_chunk(file, bomb, "zstd", zeros.size());
  EXPECT_EQ(reader_of(file, {.chunk_bytes = 1 << 20}).ending().damages.at(0).what,
            "a chunk of 33554432 bytes, where 1048576 are the most that is read");
}

TEST(McapReader, SaysWhatIsWrongInsideOfAChunk) {
  const auto damage = [](const Buffer& records, std::uint32_t crc = 0) {
    Buffer file = beginning();
    append_chunk(file, records, "", records.size(), crc);
    return damage_of(file);
  };
  Buffer records = records_of({message(7, 1)});
  EXPECT_EQ(damage(records, crc32(records) ^ 1U),
            "a chunk whose checksum differs: it was changed, or written in part");
  EXPECT_EQ(damage(records_of({message(6, 1)})),
            "a chunk that is broken: a message of channel 6, which nothing in front of it describes");
  records.pop_back();
  EXPECT_EQ(damage(records), "a chunk that is broken: a record in it is longer than what is left");
  Buffer other;
  append(other, Channel{{7}, {}, "/other", "json", {}});
  EXPECT_EQ(damage(other), "a chunk that is broken: a schema or channel 7 that differs from the one before");
}

TEST(McapReader, GoesOnBehindAChunkThatIsBroken) {
  testing::Script script = script_of(12);
  script.has_extras = false;
  Buffer file = file_of(script);
  const ChunkIndex second = reader_of(file).summary().chunks.at(1);
  file[second.offset + 30] ^= std::byte{0x40};
  const Reader reader = reader_of(file);
  EXPECT_TRUE(reader.ending().is_whole) << "it is opened by its summary";
  Messages messages = reader.messages();
  std::vector<std::string> said;
  for (auto one = messages.next(); !one || *one != nullptr; one = messages.next())
    said.push_back(one ? "" : one.error().message);
  ASSERT_EQ(said.size(), 10U);
  EXPECT_EQ(std::ranges::count(said, ""), 9);
  EXPECT_EQ(
      std::ranges::count_if(said,
                            [&](const std::string& one) {
                              return one.starts_with(fmt::format("at byte {}: a chunk ", second.offset));
                            }),
      1);
}

TEST(McapReader, ASummaryThatNamesPlacesOutsideOfTheFileIsNotFollowed) {
  testing::Script script = script_of(6);
  script.has_extras = false;
  const Buffer file = file_of(script);
  Summary summary = reader_of(file).summary();
  const std::vector<Said> whole = all(reader_of(file));
  const auto with = [&](const Summary& one) {
    Buffer out = file;
    const ChunkIndex& last = summary.chunks.back();
    out.resize(last.offset + last.length + last.message_index_length);
    append_data_end(out, 0);
    append_end(out, one, out.size());
    return out;
  };
  Summary far = summary;
  far.chunks.back().offset = UINT64_MAX - 5;
  Summary large = summary;
  large.chunks.back().length = UINT64_MAX - 5;
  Summary fewer = summary;
  fewer.chunks.pop_back();
  fewer.channels.clear();
  for (const Summary& one : {far, large, fewer}) {
    const Buffer changed = with(one);
    const Reader reader = reader_of(changed);
    EXPECT_FALSE(reader.ending().is_whole);
    EXPECT_NE(reader.ending().why.find("its summary is broken: "), std::string::npos) << reader.ending().why;
    EXPECT_EQ(all(reader), whole);
  }
  Summary elsewhere = summary;
  ++elsewhere.chunks.back().offset;
  const Buffer changed = with(elsewhere);
  std::size_t broken = 0;
  EXPECT_EQ(reader_of(changed).ending().sentence(), "");
  EXPECT_EQ(all(reader_of(changed), {}, &broken).size(), 3U);
  EXPECT_EQ(broken, 1U);
}

TEST(McapReader, KeepsNoMoreOverlappingChunksThanItMay) {
  Buffer file = beginning();
  Buffer records = records_of({message(7, 1), message(7, 50, std::string(100'000, 'x')), message(7, 100)});
  for (int i = 0; i < 50; ++i) append_chunk(file, records, "", records.size());
  std::size_t broken = 0;
  EXPECT_EQ(all(reader_of(file), {}, &broken).size(), 150U);
  EXPECT_EQ(broken, 0U);
  const std::size_t some = all(reader_of(file, {.open_bytes = 1'000'000}), {}, &broken).size();
  EXPECT_GT(some, 3U);
  EXPECT_EQ(some + 3 * broken, 150U);
}

TEST(McapReader, KeepsNoMoreSchemasThanItMay) {
  Buffer file;
  append_magic(file);
  append(file, Header{});
  const std::string data(100'000, 's');
  for (std::uint32_t id = 1; id <= 20; ++id) append(file, Schema{{id}, "many", "json", data});
  const Reader reader = reader_of(file, {.definition_bytes = 1'000'000});
  EXPECT_EQ(reader.summary().schemas.size(), 9U);
  EXPECT_EQ(reader.ending().damages.size(), 11U);
  EXPECT_EQ(reader.ending().damages.front().what, "more than 1000000 bytes of schemas and channels");
}

TEST(McapReader, AFileThatIsShortenedMeanwhileIsAnErrorAndNoSignal) {
  const ScratchFile file;
  const Buffer bytes = file_of(script_of(12));
  file.put(bytes);
  const auto reader = Reader::open(file.path());
  ASSERT_TRUE(reader);
  file.put(std::span(bytes).first(50));
  std::size_t broken = 0;
  EXPECT_TRUE(all(*reader, {}, &broken).empty());
  EXPECT_EQ(broken, 4U);
  EXPECT_EQ(reader->attachment("mission.mdl").error().message,
            "`" + file.path() + "`: the attachment `mission.mdl`: it has become shorter while it was read");
}

}  // namespace
}  // namespace mlab::mcap
