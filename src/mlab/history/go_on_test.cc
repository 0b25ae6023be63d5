#include <unistd.h>

#include <expected>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "mlab/cell/testing/permission.h"
#include "mlab/history/recorder.h"
#include "mlab/history/recording_file.h"
#include "mlab/history/replay.h"
#include "mlab/history/testing/small_disk.h"
#include "mlab/history/testing/written_run.h"
#include "mlab/mcap/reader.h"
#include "mlab/mcap/writer.h"

namespace mlab::history {
namespace {

namespace fs = std::filesystem;
using testing::SmallDisk;
using testing::WrittenRun;

// A recording that was ended before its run was: by Ctrl-C.
class GoOn : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(::testing::TempDir()) /
              fmt::format("mlab_go_on_{}_{}", ::getpid(),
                          ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    file_ = (folder_ / "run.mcap").string();
    WrittenRun ended("demo_c/demo_c.mdl", 5, true);
    carry_out(ended, 130);
    ended.end();
    write(ended.entries());
    carry_out(whole_, 250);
  }
  void TearDown() override { fs::remove_all(folder_); }

  static void carry_out(WrittenRun& run, int cycles) {
    run.run().post(mission::event::Execute{});
    for (int i = 0; i < cycles; ++i) run.step();
  }
  /// With a bookmark before the run's end.
  void write(const std::vector<wire::HistoryEntry>& entries) const {
    auto writer = RecordingWriter::create(file_, 1.5e9);
    ASSERT_TRUE(writer);
    for (const wire::HistoryEntry& entry : entries) {
      if (entry.has_end()) {
        ASSERT_TRUE((*writer)->put_metadata({"note", {{"by", "Anna"}}}));
      }
      (*writer)->put(entry);
    }
    (*writer)->close();
    ASSERT_EQ((*writer)->problem(), "");
  }
  std::string bytes() const {
    std::ifstream in(file_, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  }
  /// Nothing of the file has changed.
  std::string why_not(const std::vector<wire::HistoryEntry>& entries) const {
    const std::string before = bytes();
    const auto gone_on = RecordingWriter::go_on(file_, 1.5e9, entries);
    EXPECT_FALSE(gone_on);
    EXPECT_EQ(bytes(), before);
    return gone_on ? "" : gone_on.error().message;
  }

  fs::path folder_;
  std::string file_;
  WrittenRun whole_{"demo_c/demo_c.mdl", 5, true};
};

TEST_F(GoOn, TakesTheEndOutAndIsTheRecordingOfTheWholeRun) {
  ASSERT_TRUE(read_recording(file_)->history->end());
  auto gone_on = RecordingWriter::go_on(file_, 1.5e9, whole_.entries());
  ASSERT_TRUE(gone_on) << gone_on.error().message;
  EXPECT_EQ((*gone_on)->problem(), "");
  EXPECT_TRUE((*gone_on)->has_begun());
  // A kill now leaves all of it.
  const auto killed = read_recording(file_);
  ASSERT_TRUE(killed);
  EXPECT_EQ(killed->history->last_cycle(), 250U);
  whole_.end();
  (*gone_on)->put(whole_.entries().back());
  (*gone_on)->close();
  const auto reader = mcap::Reader::open(file_);
  ASSERT_TRUE(reader);
  EXPECT_TRUE(reader->ending().is_whole) << reader->ending().why;
  EXPECT_EQ(reader->summary().message_count, whole_.entries().size());
  EXPECT_EQ(reader->metadata("note")->values.at("by"), "Anna");
  const auto recording = read_recording(file_);
  ASSERT_TRUE(recording);
  EXPECT_EQ(recording->cut, "");
  text::Diagnostics sink;
  const auto replay = Replay::make(recording->history, {cell::testing::code_permitted()}, sink);
  ASSERT_NE(replay, nullptr) << text::render(sink);
  while (replay->step())
    ASSERT_EQ(testing::all_of(replay->run()), whole_.values()[replay->run().cycle() - 1]);
  EXPECT_TRUE(replay->is_at_end());
  EXPECT_FALSE(replay->divergence());
}

TEST_F(GoOn, AFileToWhichNothingCanBeWrittenIsNotThere) {
  const SmallDisk full(4);
  const std::string path = (folder_ / "new.mcap").string();
  const auto writer = RecordingWriter::create(path, 1.5e9);
  ASSERT_FALSE(writer);
  EXPECT_NE(writer.error().message.find("File too large"), std::string::npos) << writer.error().message;
  EXPECT_FALSE(fs::exists(path));
}

// Its writer was killed within the index behind the last chunk, which has to be written anew.
TEST_F(GoOn, WhereOnlyRoomIsMissingNoOtherFileIsBegunAndTheNextTimeItGoesOn) {
  const std::string killed = (folder_ / "killed.mcap").string();
  const auto record = [&](bool is_held, const Recorder::Place& place, const auto& then) {
    WrittenRun written("demo_c/demo_c.mdl", 5, true);
    Recorder recorder(place, written.run(), {"test", {}, 5, 1.5e9}, {}, is_held);
    written.run().post(mission::event::Execute{});
    for (int i = 0; i < 120; ++i) {
      ASSERT_EQ(written.run().step(), run::MissionRun::Progress::kStepped);
      recorder.note_cycle();
    }
    then(recorder);
  };
  record(
      false, [this] { return (folder_ / "first.mcap").string(); },
      [&](Recorder& recorder) {
        recorder.note_rest();
        fs::copy_file(folder_ / "first.mcap", killed);
      });
  const std::uint64_t known = read_recording(killed)->history->last_cycle();
  ASSERT_GT(known, 100U);
  fs::resize_file(killed, fs::file_size(killed) - 5);
  const auto nowhere = []() -> std::expected<std::string, std::string> {
    ADD_FAILURE() << "no place is asked for";
    return std::unexpected("there is none");
  };
  record(true, nowhere, [&](Recorder& recorder) {
    const SmallDisk full(fs::file_size(killed));
    recorder.go_on(killed);
    EXPECT_EQ(recorder.path(), killed);
    EXPECT_FALSE(recorder.is_recording());
    EXPECT_NE(recorder.problem().find("File too large"), std::string::npos) << recorder.problem();
  });
  EXPECT_EQ(read_recording(killed)->history->last_cycle(), known) << "what stood there can be read";
  record(true, nowhere, [&](Recorder& recorder) {
    recorder.go_on(killed);
    EXPECT_TRUE(recorder.is_same_file());
    EXPECT_EQ(recorder.problem(), "");
  });
}

TEST_F(GoOn, AsOftenAsTheRunIsCutOff) {
  const std::vector<wire::HistoryEntry>& all = whole_.entries();
  for (const std::size_t share : {3U, 2U, 1U}) {
    const std::vector<wire::HistoryEntry> known(all.begin(),
                                                all.end() - static_cast<std::ptrdiff_t>(share * 4));
    auto gone_on = RecordingWriter::go_on(file_, 1.5e9, known);
    ASSERT_TRUE(gone_on) << gone_on.error().message;
    wire::HistoryEntry end;
    end.set_cycle(known.back().cycle());
    end.set_time(known.back().time());
    end.mutable_end()->set_outcome("interrupted");
    (*gone_on)->put(end);
    (*gone_on)->close();
    const auto reader = mcap::Reader::open(file_);
    ASSERT_TRUE(reader && reader->ending().is_whole);
    EXPECT_EQ(reader->summary().message_count, known.size() + 1);
  }
}

TEST_F(GoOn, SaysWhyItDoesNot) {
  const std::vector<wire::HistoryEntry>& all = whole_.entries();
  std::vector<wire::HistoryEntry> newer = all;
  for (wire::HistoryEntry& entry : newer) {
    if (entry.has_beginning()) entry.mutable_beginning()->set_version("99.1");
  }
  EXPECT_NE(why_not(newer).find("of missionlab, and this is 99.1"), std::string::npos) << why_not(newer);
  std::vector<wire::HistoryEntry> other = all;
  other[other.size() / 4].set_cycle(1'000'000);
  EXPECT_NE(why_not(other).find("is not the beginning of this run"), std::string::npos) << why_not(other);
  const std::vector<wire::HistoryEntry> shorter(all.begin(), all.begin() + 5);
  EXPECT_NE(why_not(shorter).find("is not the beginning of this run"), std::string::npos);
  auto added = mcap::Writer::resume(file_);
  ASSERT_TRUE(added && added->writer.add(mcap::Metadata{"note", {}}) && added->writer.close());
  EXPECT_NE(why_not(all).find("something was added to"), std::string::npos) << why_not(all);
  fs::remove(file_);
  EXPECT_FALSE(RecordingWriter::go_on(file_, 1.5e9, all));
}

TEST_F(GoOn, SaysWhereItIsDamaged) {
  std::string damaged = bytes();
  const mcap::ChunkIndex chunk = mcap::Reader::open(file_)->summary().chunks.front();
  const std::size_t at = chunk.offset + chunk.length / 2;
  damaged[at] = static_cast<char>(damaged[at] ^ 0x55);
  std::ofstream(file_, std::ios::binary) << damaged;
  EXPECT_NE(why_not(whole_.entries()).find("checksum"), std::string::npos) << why_not(whole_.entries());
}

}  // namespace
}  // namespace mlab::history
