// Recordings between this project and others: what is written here, readers of somebody else's read, by its
// indexes and as a stream, with all checksums; and the other way round.

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "mlab/base/testing/source_folder.h"
#include "mlab/mcap/protobuf_schema.h"
#include "mlab/mcap/reader.h"
#include "mlab/mcap/testing/sample.h"
#include "mlab/mcap/writer.h"
#include "mlab/percepts_file.pb.h"

namespace mlab::mcap {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using testing::Said;

Json json_of(const Said& one) {
  return {{"topic", one.topic},
          {"sequence", one.sequence},
          {"log_time", one.log_time},
          {"publish_time", one.publish_time},
          {"data", one.data}};
}

Json json_of(const std::vector<Said>& messages) {
  Json out = Json::array();
  for (const Said& one : messages) out.push_back(json_of(one));
  return out;
}

class McapPeers : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!fs::is_directory(fs::path(MLAB_MCAP_FOLDER) / "node_modules"))
      GTEST_SKIP() << "no MCAP readers in " << MLAB_MCAP_FOLDER << ": ./mlab test --only e2e installs them";
  }

  // What a script beside this file prints; empty where it fails, which the test then says.
  static std::string printed(const std::string& script, const std::string& arguments) {
    const std::string command = fmt::format(
        "node '{}' '{}' {} 2>&1", (fs::path(base::source_folder()) / "tests/mcap" / script).string(),
        MLAB_MCAP_FOLDER, arguments);
    FILE* const pipe = ::popen(command.c_str(), "r");
    std::string out;
    std::array<char, 4096> buffer{};
    while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe))
      out.append(buffer.data(), n);
    const int status = ::pclose(pipe);
    EXPECT_EQ(status, 0) << out;
    return status == 0 ? out : "";
  }
  Json read_by_others() const {
    return Json::parse(printed("read.mjs", fmt::format("'{}'", scratch.path())), nullptr, false);
  }
  void write_by_others(const testing::Script& script, bool use_chunks) const {
    const std::string file = scratch.folder() + "/script.json";
    const Json said = {{"messages", json_of(script.messages)},
                       {"chunk_size", script.options.chunk_bytes},
                       {"is_compressed", script.options.is_compressed},
                       {"use_chunks", use_chunks}};
    std::ofstream(file) << said.dump();
    printed("write.mjs", fmt::format("'{}' '{}'", file, scratch.path()));
  }
  // What others read of what the script has become.
  void expect_read(const testing::Script& script) const {
    const Json is = read_by_others();
    ASSERT_TRUE(is.is_object());
    const std::vector<Said>& messages = script.messages;
    const std::size_t count = messages.size();
    EXPECT_EQ(is["header"], (Json{{"profile", ""}, {"library", "missionlab"}}));
    EXPECT_EQ(is["statistics"]["messages"], count);
    EXPECT_EQ(is["statistics"]["chunks"], (count + script.per_flush - 1) / script.per_flush);
    EXPECT_EQ(is["summary_groups"], Json({0x03, 0x04, 0x08, 0x0a, 0x0b, 0x0d}));
    EXPECT_NE(is["data_crc"], 0);
    EXPECT_EQ(is["indexed"], json_of(testing::in_order(messages)));
    EXPECT_EQ(is["backwards"].size(), count);
    EXPECT_EQ(is["streamed"], json_of(messages));
    const auto reader = Reader::open(scratch.path());
    ASSERT_TRUE(reader);
    const std::uint64_t start = reader->summary().start_time;
    const std::uint64_t end = reader->summary().end_time;
    const auto middle = testing::all(
        *reader, {.topics = {"/poses", "/log"}, .from = (2 * start + end) / 3, .to = (start + 2 * end) / 3});
    EXPECT_FALSE(middle.empty());
    EXPECT_EQ(is["middle"], json_of(middle));
    EXPECT_EQ(is["attachments"],
              Json::parse(R"([{"name": "mission.mdl", "media_type": "text/plain", "log_time": 5,
                                                  "data": "UNIT scouts MOVETO ATK-AP1\n"}])"));
    EXPECT_EQ(is["metadata"],
              Json::parse(R"([{"name": "versions", "values": {"library": "3", "seed": "7"}}])"));
    EXPECT_EQ(is["channels"],
              Json::parse(R"([["/poses", "json", "m"], ["/events", "json", "m"], ["/log", "json", "m"]])"));
  }

  testing::ScratchFile scratch;
};

testing::Script large_script(bool is_compressed) {
  testing::Script out = testing::script_of(3000);
  out.per_flush = 200;
  out.options.is_compressed = is_compressed;
  return out;
}

TEST_F(McapPeers, OthersReadWhatIsWrittenHere) {
  for (const bool is_compressed : {true, false}) {
    const testing::Script script = large_script(is_compressed);
    scratch.put(testing::file_of(script));
    expect_read(script);
  }
}

TEST_F(McapPeers, OthersReadWhatWasCutAndGoneOnWith) {
  const testing::Script script = large_script(true);
  Buffer file = testing::file_of(script);
  const ChunkIndex chunk = testing::reader_of(file).summary().chunks.at(7);
  file.resize(chunk.offset + chunk.length + chunk.message_index_length / 2);
  scratch.put(file);
  auto resumed = Writer::resume(scratch.path(), script.options);
  ASSERT_TRUE(resumed) << resumed.error().message;
  ASSERT_TRUE(testing::play(resumed->writer, script, 8 * script.per_flush));
  ASSERT_TRUE(resumed->writer.close());
  expect_read(script);
}

TEST_F(McapPeers, OthersDecodeMessagesByTheirSchema) {
  auto writer = Writer::create(scratch.path());
  ASSERT_TRUE(writer);
  const auto schema = writer->add_schema(protobuf_schema(*wire::RecordedEntry::descriptor()));
  ASSERT_TRUE(schema);
  const auto channel = writer->add_channel({{}, *schema, "/entries", "protobuf", {}});
  ASSERT_TRUE(channel);
  wire::RecordedEntry entry;
  entry.mutable_head()->set_mission("demo.mdl");
  entry.mutable_head()->set_format(3);
  const std::string bytes = entry.SerializeAsString();
  ASSERT_TRUE(writer->write({*channel, 0, 1, 1, testing::bytes_of(bytes)}));
  ASSERT_TRUE(writer->close());
  const Json is = read_by_others();
  ASSERT_TRUE(is.is_object());
  EXPECT_EQ(Json::parse(is["indexed"][0]["data"].get<std::string>()),
            Json::parse(R"({"head": {"mission": "ZGVtby5tZGw=", "format": 3}})"))
      << "bytes are base64 there";
}

TEST_F(McapPeers, WhatOthersWriteIsReadHere) {
  for (const bool use_chunks : {true, false}) {
    for (const bool is_compressed : {true, false}) {
      testing::Script script = testing::script_of(2000);
      script.options.is_compressed = is_compressed;
      script.options.chunk_bytes = 5000;
      write_by_others(script, use_chunks);
      const auto reader = Reader::open(scratch.path());
      ASSERT_TRUE(reader) << reader.error().message;
      EXPECT_EQ(reader->ending().is_whole, use_chunks) << reader->ending().sentence();
      EXPECT_TRUE(reader->ending().damages.empty()) << reader->ending().sentence();
      EXPECT_EQ(reader->summary().chunks.size() > 10, use_chunks);
      EXPECT_EQ(reader->header().library.find("somebody else's"), 0U);
      EXPECT_EQ(testing::all(*reader), testing::in_order(script.messages));
      EXPECT_EQ(reader->attachment("mission.mdl")->data, "theirs");
      EXPECT_EQ(reader->metadata("versions")->values, (Pairs{{"seed", "7"}}));
    }
  }
}

TEST_F(McapPeers, WhatOthersWroteCanBeGoneOnWith) {
  testing::Script script = testing::script_of(300);
  script.options.chunk_bytes = 5000;
  write_by_others(script, true);
  auto resumed = Writer::resume(scratch.path());
  ASSERT_TRUE(resumed) << resumed.error().message;
  Writer& writer = resumed->writer;
  const auto schema = writer.add_schema({{}, "text", "jsonschema", R"({"type": "string"})"});
  ASSERT_TRUE(schema);
  const auto channel = writer.add_channel({{}, *schema, "/log", "json", {{"unit", "m"}}});
  ASSERT_TRUE(channel);
  EXPECT_EQ(writer.summary().channels.size(), 3U) << "it had the channel";
  ASSERT_TRUE(writer.write({*channel, 300, 9000, 8999, testing::bytes_of("ours")}));
  ASSERT_TRUE(writer.close());
  script.messages.push_back({"/log", 300, 9000, 8999, "ours"});
  EXPECT_EQ(testing::all(*Reader::open(scratch.path())), testing::in_order(script.messages));
  const Json is = read_by_others();
  EXPECT_EQ(is["indexed"], json_of(testing::in_order(script.messages)));
  EXPECT_EQ(is["streamed"], json_of(script.messages));
}

}  // namespace
}  // namespace mlab::mcap
