#include "mlab/history/recording_file.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "mlab/cell/testing/permission.h"
#include "mlab/history/recorded_names.h"
#include "mlab/history/recorder.h"
#include "mlab/history/replay.h"
#include "mlab/history/shelf.h"
#include "mlab/history/testing/small_disk.h"
#include "mlab/history/testing/written_run.h"
#include "mlab/mcap/reader.h"

namespace mlab::history {
namespace {

namespace fs = std::filesystem;
using testing::SmallDisk;
using testing::WrittenRun;

class RecordingFile : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(::testing::TempDir()) /
              fmt::format("mlab_recording_{}_{}", ::getpid(),
                          ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  // Ten seconds of Demo C.
  static void carry_out(WrittenRun& written) {
    written.run().post(mission::event::Execute{});
    for (int i = 0; i < 100; ++i) written.step();
    written.run().set_emergency_stop(true);
    for (int i = 0; i < 5; ++i) written.step();
    written.end();
  }
  static void write(const WrittenRun& written, const std::string& file) {
    auto writer = RecordingWriter::create(file, 1.5e9);
    ASSERT_TRUE(writer);
    for (const wire::HistoryEntry& entry : written.entries()) (*writer)->put(entry);
    (*writer)->close();
    EXPECT_EQ((*writer)->problem(), "");
  }

  fs::path folder_;
};

TEST_F(RecordingFile, HoldsTheWholeHistory) {
  WrittenRun written("demo_c/demo_c.mdl", 4, true);
  carry_out(written);
  write(written, path("run.mcap"));
  const auto read = read_recording(path("run.mcap"));
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->cut, "");
  EXPECT_EQ(read->history->inputs().size(), 2U);
  EXPECT_EQ(read->history->poses().size(), written.history()->poses().size());
  EXPECT_EQ(read->history->events().size(), written.history()->events().size());
  ASSERT_TRUE(read->history->end());
  text::Diagnostics sink;
  const auto replay = Replay::make(read->history, {cell::testing::code_permitted()}, sink);
  ASSERT_NE(replay, nullptr) << text::render(sink);
  while (replay->step()) {
  }
  EXPECT_TRUE(replay->is_at_end());
  EXPECT_EQ(testing::all_of(replay->run()), written.values().back());
  const auto summary = summarize_recording(path("run.mcap"));
  ASSERT_TRUE(summary);
  EXPECT_EQ(summary->seed, 4U);
  EXPECT_NEAR(summary->length, written.run().time(), 1e-6);
  EXPECT_EQ(summary->outcome, "interrupted");
}

// A disk may go bad in the middle: what stands in front of that is a run, also where both begin at the same
// time.
TEST_F(RecordingFile, OfWhichAPieceIsBrokenIsTheRunInFrontOfIt) {
  WrittenRun written("demo_c/demo_c.mdl", 4, true);
  carry_out(written);
  write(written, path("run.mcap"));
  const auto reader = mcap::Reader::open(path("run.mcap"));
  ASSERT_TRUE(reader);
  const auto& chunks = reader->summary().chunks;
  ASSERT_GT(chunks.size(), 2U);
  EXPECT_EQ(chunks[0].start_time, chunks[1].start_time);
  std::ifstream stream(path("run.mcap"), std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  std::uint64_t known = 0;
  for (std::size_t i = 1; i < chunks.size(); ++i) {
    std::string broken = bytes;
    broken[chunks[i].offset + chunks[i].length / 2] ^= 0x10;
    std::ofstream(path("broken.mcap"), std::ios::binary) << broken;
    const auto read = read_recording(path("broken.mcap"));
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_TRUE(read->cut.starts_with(fmt::format("at byte {}: a chunk ", chunks[i].offset))) << read->cut;
    EXPECT_TRUE(read->is_damaged);
    EXPECT_GE(read->history->last_cycle(), known);
    known = read->history->last_cycle();
  }
}

// A process may be killed at any moment: what stands is a run, up to there, or says that it is none.
TEST_F(RecordingFile, ThatIsCutOffAnywhereIsTheRunUpToThere) {
  WrittenRun written("demo_c/demo_c.mdl", 4, true);
  auto writer = RecordingWriter::create(path("run.mcap"), 1.5e9);
  ASSERT_TRUE(writer);
  // Somebody does something again and again, which is on the disk at once.
  written.run().post(mission::event::Execute{});
  for (int i = 0; i < 40; ++i) {
    written.run().set_parameter({1}, "base_velocity", fmt::format("{}", 1 + i % 3));
    written.step();
  }
  for (const wire::HistoryEntry& entry : written.entries()) (*writer)->put(entry);
  (*writer)->close();
  std::ifstream stream(path("run.mcap"), std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  std::size_t most = 0;
  std::size_t runs = 0;
  for (std::size_t length = 0; length < bytes.size(); length += 97) {
    std::ofstream(path("cut.mcap"), std::ios::binary) << bytes.substr(0, length);
    const auto read = read_recording(path("cut.mcap"));
    if (!read) continue;
    EXPECT_NE(read->cut, "");
    EXPECT_FALSE(read->is_damaged) << "at byte " << length << ": " << read->cut;
    EXPECT_GE(read->history->inputs().size(), most) << "at byte " << length;
    most = read->history->inputs().size();
    ++runs;
    if (runs % 16 != 0) continue;
    text::Diagnostics sink;
    const auto replay = Replay::make(read->history, {cell::testing::code_permitted()}, sink);
    ASSERT_NE(replay, nullptr) << text::render(sink);
    while (replay->step())
      ASSERT_EQ(testing::all_of(replay->run()), written.values()[replay->run().cycle() - 1]);
    EXPECT_FALSE(replay->divergence());
  }
  EXPECT_GT(most, 30U);
  EXPECT_GT(runs, 20U);
}

TEST_F(RecordingFile, OnAFullDiskEndsAndTheRunGoesOn) {
  WrittenRun written("demo_c/demo_c.mdl", 4, true);
  Recorder recorder([this] { return path("run.mcap"); }, written.run(), {"test", {}, 5, 0.0});
  written.run().post(mission::event::Execute{});
  ASSERT_EQ(recorder.problem(), "");
  {
    const SmallDisk disk(fs::file_size(path("run.mcap")) + 100);
    for (int i = 0; i < 40; ++i) {
      written.run().set_parameter({1}, "base_velocity", fmt::format("{}", 1 + i % 3));
      ASSERT_EQ(written.run().step(), run::MissionRun::Progress::kStepped);
      recorder.note_cycle();
    }
  }
  EXPECT_NE(recorder.problem().find("does not go on"), std::string::npos) << recorder.problem();
  EXPECT_EQ(written.run().cycle(), 40U);
  const auto read = read_recording(path("run.mcap"));
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_GE(read->history->inputs().size(), 1U) << "what stood before can be read";
}

// A recording does not tell where on this machine its mission lay.
TEST_F(RecordingFile, NamesFilesFromWhereTheMissionLies) {
  for (const std::string mission : {"demo_c/demo_c.mdl", "forage/forage.mdl"}) {
    SCOPED_TRACE(mission);
    fs::remove(path("run.mcap"));
    WrittenRun written(mission, 4, true);
    ASSERT_TRUE(written.run().mission().source->name().starts_with("/"));
    {
      Recorder recorder([this] { return path("run.mcap"); }, written.run(), {"test", {}, 5, 0.0});
      written.run().post(mission::event::Execute{});
      for (int i = 0; i < 120; ++i) {
        written.run().step();
        recorder.note_cycle();
      }
      recorder.end("interrupted");
    }
    const auto read = read_recording(path("run.mcap"));
    ASSERT_TRUE(read) << read.error().message;
    const wire::HistoryMission& version = read->history->beginning().mission();
    EXPECT_EQ(version.path(), fs::path(mission).filename().string());
    EXPECT_EQ(version.folder() + version.program_folder(), "");
    for (const std::uint32_t id : version.texts())
      EXPECT_FALSE(read->history->text(id)->name().starts_with("/")) << read->history->text(id)->name();
    text::Diagnostics sink;
    const auto replay = Replay::make(read->history, {cell::testing::code_permitted()}, sink);
    ASSERT_NE(replay, nullptr) << text::render(sink);
    while (replay->step()) {
    }
    EXPECT_FALSE(replay->divergence());
    EXPECT_TRUE(replay->is_at_end());
  }
}

// Ten minutes of the four robots of Demo C, on their way all the time.
TEST_F(RecordingFile, IsSmall) {
  std::uintmax_t sizes[2] = {};
  for (const bool has_answers : {false, true}) {
    WrittenRun written("demo_c/demo_c.mdl", 4, true, has_answers);
    run::MissionRun& run = written.run();
    Recorder recorder([&] { return path(has_answers ? "answers.mcap" : "run.mcap"); }, run,
                      {"test", {}, 5, 0.0});
    run.post(mission::event::Execute{});
    while (run.cycle() < 6000) {
      if (run.step() != run::MissionRun::Progress::kStepped) {
        ASSERT_TRUE(run.is_over());
        run.post(mission::event::Rewind{});
        run.post(mission::event::Execute{});
        continue;
      }
      recorder.note_cycle();
    }
    recorder.end("interrupted");
    sizes[has_answers ? 1 : 0] = fs::file_size(recorder.path());
  }
  RecordProperty("bytes", std::to_string(sizes[0]));
  RecordProperty("bytes_with_answers", std::to_string(sizes[1]));
  EXPECT_LT(sizes[0], 1'000'000U);
  EXPECT_LT(sizes[1], 1'000'000U) << "with what robots in executables answer";
}

TEST(RecordedSources, AreFoundHoweverTextsCallThem) {
  const RecordedNames names("/anna/project/missions");
  RecordedSources sources;
  for (const char* path : {"/anna/project/missions/m.mdl", "/anna/project/missions/sub/../a.cdl",
                           "/anna/project/maps/map.odl", "/opt/shared/far.odl"}) {
    wire::HistoryEntry entry;
    entry.mutable_text()->set_path(path);
    const std::string name = names.in_recording(entry).text().path();
    EXPECT_EQ(name.find("anna"), std::string::npos) << name;
    sources.add(std::make_shared<const text::Source>(name, path));
  }
  const auto text_of = [&](const std::string& path) {
    const text::SourcePtr found = sources.find(path);
    return found ? std::string(found->text()) : "";
  };
  EXPECT_EQ(text_of("m.mdl"), "/anna/project/missions/m.mdl");
  EXPECT_EQ(text_of("./sub/../m.mdl"), "/anna/project/missions/m.mdl");
  EXPECT_EQ(text_of("a.cdl"), "/anna/project/missions/sub/../a.cdl");
  EXPECT_EQ(text_of("../maps/map.odl"), "/anna/project/maps/map.odl");
  EXPECT_EQ(text_of("/opt/shared/far.odl"), "/opt/shared/far.odl") << "as its text calls it";
  EXPECT_EQ(text_of("/anna/project/maps/map.odl"), "/anna/project/maps/map.odl");
  EXPECT_EQ(text_of("/etc/passwd"), "");
  EXPECT_EQ(text_of("../maps/other.odl"), "");
}

// A mission that was named by where it lies from here, and overlays of the installation by their whole path.
TEST(RecordedNames, AreNoWholePathsHoweverTheMissionWasNamed) {
  const fs::path here = fs::current_path();
  for (const auto& [folder, expected] : {std::pair("missions/patrol", "../../maps/map.odl"),
                                         std::pair("", "maps/map.odl"), std::pair(".", "maps/map.odl")}) {
    wire::HistoryBeginning beginning;
    beginning.add_overlay_folders((here / "maps").string());
    const RecordedNames names(folder);
    EXPECT_EQ(names.in_recording(beginning).overlay_folders(0) + "/map.odl", expected) << folder;
    wire::HistoryEntry entry;
    entry.mutable_text()->set_path((here / "maps" / "map.odl").string());
    EXPECT_EQ(names.in_recording(entry).text().path(), expected) << folder;
    entry.mutable_text()->set_path("patrol.mdl");
    EXPECT_FALSE(fs::path(names.in_recording(entry).text().path()).is_absolute());
  }
}

TEST_F(RecordingFile, IsNeverWrittenOver) {
  std::ofstream(path("run.mcap")) << "of somebody";
  const auto writer = RecordingWriter::create(path("run.mcap"), 0.0);
  ASSERT_FALSE(writer);
  EXPECT_NE(writer.error().message.find("never written over"), std::string::npos) << writer.error().message;
  EXPECT_EQ(fs::file_size(path("run.mcap")), 11U);
}

// A run that waits for its operator may be killed an hour later.
TEST_F(RecordingFile, HasAllOnceNoTimePasses) {
  WrittenRun written("demo_c/demo_c.mdl", 4, true);
  Recorder recorder([this] { return path("run.mcap"); }, written.run(), {"test", {}, 5, 0.0});
  written.run().post(mission::event::Execute{});
  for (int i = 0; i < 150; ++i) {
    written.run().step();
    recorder.note_cycle();
  }
  recorder.note_rest();
  const auto read = read_recording(path("run.mcap"));
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_GT(read->history->last_cycle(), 100U);
  EXPECT_GT(read->history->poses().size(), 10U);
}

TEST_F(RecordingFile, OfARunThatNobodyStartsIsNotMade) {
  WrittenRun written("demo_c/demo_c.mdl", 4, true);
  Recorder recorder([this] { return path("run.mcap"); }, written.run(), {"test", {}, 5, 0.0});
  written.run().set_parameter({1}, "base_velocity", "2");
  EXPECT_EQ(recorder.path(), "");
  EXPECT_FALSE(fs::exists(path("run.mcap")));
  written.run().post(mission::event::Execute{});
  EXPECT_EQ(recorder.path(), path("run.mcap"));
  for (int i = 0; i < 20; ++i) {
    written.run().step();
    recorder.note_cycle();
  }
  recorder.end("interrupted");
  const auto read = read_recording(path("run.mcap"));
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->history->inputs().size(), 2U) << "what came before the start counts, too";
}

TEST_F(RecordingFile, ThatIsNoneSaysSo) {
  std::ofstream(path("text.mcap")) << "MISSION NAME x\n";
  const auto text = read_recording(path("text.mcap"));
  ASSERT_FALSE(text);
  EXPECT_EQ(text.error().kind, "no-mcap");
  auto other = mcap::Writer::create(path("other.mcap"));
  ASSERT_TRUE(other && other->close());
  const auto read = read_recording(path("other.mcap"));
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().kind, "no-recording");
  EXPECT_FALSE(read_recording(path("nosuch.mcap")));
}

TEST_F(RecordingFile, AreKeptByNumberAndSizeAndMarksStay) {
  const Shelf shelf(path("runs"));
  std::string first;
  for (std::size_t i = 0; i < Shelf::kMostRuns + 10; ++i) {
    const auto place = shelf.place_for("some/where/far trip.mdl", 1.5e9 + static_cast<double>(i));
    ASSERT_TRUE(place) << place.error();
    std::ofstream(*place) << "x";
    if (i != 0) continue;
    first = *place;
    ASSERT_TRUE(Shelf::set_mark(first, true));
  }
  const std::vector<ShelvedRun> runs = shelf.runs();
  EXPECT_EQ(runs.size(), Shelf::kMostRuns + 1);
  EXPECT_EQ(runs.back().path, first);
  EXPECT_TRUE(runs.back().is_marked);
  EXPECT_NE(runs.front().name.find("far_trip"), std::string::npos) << runs.front().name;
  ASSERT_TRUE(Shelf::set_mark(first, false));
  ASSERT_TRUE(shelf.place_for("m.mdl", 1.6e9));
  EXPECT_FALSE(fs::exists(first));
  // A large one leaves room for nothing else.
  std::ofstream large(path("runs/2020-01-01 00.00.00 large.mcap"));
  large.close();
  fs::resize_file(path("runs/2020-01-01 00.00.00 large.mcap"), Shelf::kMostBytes + 1);
  ASSERT_TRUE(shelf.place_for("m.mdl", 1.6e9));
  EXPECT_LE(shelf.runs().size(), 1U);
  EXPECT_FALSE(Shelf("").place_for("m.mdl", 0.0));
  EXPECT_FALSE(Shelf("/proc/nowhere").place_for("m.mdl", 0.0));
}

}  // namespace
}  // namespace mlab::history
