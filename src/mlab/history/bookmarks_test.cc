#include "mlab/history/bookmarks.h"

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "mlab/base/random.h"
#include "mlab/history/bookmark_file.h"
#include "mlab/history/recording_file.h"
#include "mlab/history/shelf.h"
#include "mlab/history/testing/written_run.h"

namespace mlab::history {
namespace {

namespace fs = std::filesystem;

Bookmark bookmark(std::uint64_t cycle, const std::string& note, const std::string& by = "Anna") {
  return {0, cycle, 0.1 * static_cast<double>(cycle), note, by};
}

TEST(Bookmarks, AreInTheOrderOfTheirMoments) {
  Bookmarks all;
  ASSERT_EQ(all.add(bookmark(300, "late")), 1U);
  ASSERT_EQ(all.add(bookmark(20, "early")), 2U);
  ASSERT_EQ(all.add(bookmark(20, "the same moment")), 3U);
  const std::vector<Bookmark> list = all.in_order();
  ASSERT_EQ(list.size(), 3U);
  EXPECT_EQ(list[0].note, "early");
  EXPECT_EQ(list[1].note, "the same moment");
  EXPECT_EQ(list[2].note, "late");
}

TEST(Bookmarks, OneThatWasRemovedComesBackAsItWas) {
  Bookmarks all;
  ASSERT_TRUE(all.add(bookmark(20, "early")));
  ASSERT_TRUE(all.add(bookmark(30, "later")));
  const Bookmarks before = all;
  EXPECT_EQ(all.remove(1), std::nullopt);
  EXPECT_EQ(all.all().size(), 1U);
  EXPECT_EQ(all.remove(1), "there is no bookmark 1");
  EXPECT_EQ(all.set_note(1, "x"), "there is no bookmark 1");
  EXPECT_EQ(all.take_back(1), std::nullopt);
  EXPECT_EQ(all.take_back(1), "bookmark 1 can't be brought back");
  EXPECT_EQ(all, before);
  EXPECT_EQ(all.add(bookmark(40, "")), 3U) << "no number is given twice";
}

TEST(Bookmarks, NotesAreOneLineOfTextAndNoLongerThanTheyMayBe) {
  EXPECT_EQ(plain_note("  two\nlines\tand \x1b[31mred\x7f  "), "two lines and [31mred");
  EXPECT_EQ(plain_note("<b>bold</b> & more"), "<b>bold</b> & more") << "whoever shows it shows it as text";
  EXPECT_EQ(plain_note("na\xc3\xafve\xc2\x85line\xe2\x80\xa8"
                       "end"),
            "na\xc3\xafve line end");
  EXPECT_EQ(plain_note("caf\xe9"), "caf\xc3\xa9") << "what is no UTF-8 is taken for Latin 1";
  EXPECT_EQ(plain_note(std::string(1000, 'x')).size(), Bookmarks::kMostNote);
  std::string umlauts;
  for (int i = 0; i < 600; ++i) umlauts += "\xc3\xbc";
  EXPECT_EQ(plain_note(umlauts).size(), 2 * Bookmarks::kMostNote) << "characters, not bytes";
  std::string words;
  for (int i = 0; i < 600; ++i) words += "a ";
  EXPECT_LE(plain_note(words).size(), Bookmarks::kMostNote);
}

TEST(Bookmarks, OfAMomentThatTheRunDoesNotHaveAreMovedIntoIt) {
  constexpr std::uint64_t kNone = std::numeric_limits<std::uint64_t>::max();
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  struct {
    double time;
    std::uint64_t cycle;
    double moved_time;
    std::uint64_t moved_cycle;
  } const kCases[] = {{1e300, kNone, 30.0, 300},  {1e300, 100, 10.0, 100}, {-5.0, kNone, 0.0, 0},
                      {-5.0, 100, 10.0, 100},     {kNaN, 100, 10.0, 100},  {kNaN, kNone, 0.0, 0},
                      {12.0, 100'000, 12.0, 120}, {30.5, 305, 30.0, 300}};
  for (const auto& one : kCases) {
    Bookmark moved{1, one.cycle, one.time, "note", ""};
    EXPECT_TRUE(move_into_run(moved, RunExtent{300, 30.0})) << one.time << " " << one.cycle;
    EXPECT_NEAR(moved.time, one.moved_time, 1e-9) << one.time << " " << one.cycle;
    EXPECT_EQ(moved.cycle, one.moved_cycle) << one.time << " " << one.cycle;
    EXPECT_EQ(moved.note, "note");
  }
  Bookmark good{1, 300, 30.0, "", ""};
  EXPECT_FALSE(move_into_run(good, RunExtent{300, 30.0}));
  EXPECT_FALSE(move_into_run(good, {})) << "nobody knows how far the run goes";
  Bookmark odd{1, kNone, -1.0, "", ""};
  EXPECT_TRUE(move_into_run(odd, {}));
  EXPECT_EQ(odd, (Bookmark{1, 0, 0.0, "", ""}));
}

TEST(Bookmarks, TooManyAndNoneAreRefused) {
  Bookmarks all;
  EXPECT_FALSE(all.add({0, 1, std::numeric_limits<double>::quiet_NaN(), "", ""}));
  EXPECT_FALSE(all.add({0, 1, -1.0, "", ""}));
  EXPECT_FALSE(all.put({0, 1, 1.0, "", ""})) << "ids begin with 1";
  EXPECT_FALSE(all.put({Bookmarks::kMostNumber + 1, 1, 1.0, "", ""}));
  for (std::size_t i = 0; i < Bookmarks::kMost; ++i) ASSERT_TRUE(all.add(bookmark(i, "")));
  EXPECT_EQ(all.add(bookmark(1, "")).error(), "there are 500 bookmarks already: remove one first");
  ASSERT_EQ(all.remove(7), std::nullopt);
  ASSERT_TRUE(all.add(bookmark(1, "")));
  EXPECT_EQ(all.take_back(7), "there are 500 bookmarks already: remove one first");
  Bookmarks last;
  ASSERT_TRUE(last.put({Bookmarks::kMostNumber, 1, 1.0, "", ""}));
  EXPECT_EQ(last.add(bookmark(1, "")).error(), "there is no number left for another bookmark");
}

class BookmarkFile : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(::testing::TempDir()) /
              fmt::format("mlab_bookmarks_{}_{}", ::getpid(),
                          ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    run_ = (folder_ / "run.mcap").string();
  }
  void TearDown() override { fs::remove_all(folder_); }

  // A run of two seconds, in the course of which `change` puts bookmarks into the recording.
  void record(const std::function<void(RecordingWriter&)>& change) const {
    testing::WrittenRun written("demo_c/demo_c.mdl", 1, true);
    written.run().post(mission::event::Execute{});
    for (int i = 0; i < 20; ++i) written.step();
    written.end();
    auto writer = RecordingWriter::create(run_, 1.5e9);
    ASSERT_TRUE(writer);
    const std::size_t half = written.entries().size() / 2;
    for (std::size_t i = 0; i < written.entries().size(); ++i) {
      if (i == half) change(**writer);
      (*writer)->put(written.entries()[i]);
    }
    (*writer)->close();
    ASSERT_EQ((*writer)->problem(), "");
  }
  static std::string bytes_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  static void write(const std::string& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
  }
  std::string beside() const { return bookmark_path(run_); }

  fs::path folder_;
  std::string run_;
};

TEST_F(BookmarkFile, ARecordingHoldsTheLastOfEachAndItsHistoryIsWhole) {
  record([](RecordingWriter& out) {
    EXPECT_TRUE(out.put_metadata(bookmark_record({1, 3, 0.3, "first", "Anna"})));
    EXPECT_TRUE(out.put_metadata(bookmark_record({2, 5, 0.5, "gone", "Ben"})));
    EXPECT_TRUE(out.put_metadata(bookmark_record({1, 3, 0.3, "first, mended", "Anna"})));
    EXPECT_TRUE(out.put_metadata(bookmark_record(2)));
  });
  const KeptBookmarks kept = read_bookmarks(run_);
  EXPECT_EQ(kept.problem, "");
  ASSERT_EQ(kept.bookmarks.all().size(), 1U);
  EXPECT_EQ(*kept.bookmarks.find(1), (Bookmark{1, 3, 0.3, "first, mended", "Anna"}));
  EXPECT_EQ(kept.recorded_to, 2U);
  const auto read = read_recording(run_);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->cut, "");
  EXPECT_TRUE(read->history->end());
}

TEST_F(BookmarkFile, ARecordingThatIsCutOffHasThoseBeforeTheCut) {
  record([](RecordingWriter& out) {
    for (std::uint64_t i = 1; i <= 3; ++i)
      out.put_metadata(bookmark_record({i, i, 0.1 * static_cast<double>(i), "note", ""}));
  });
  const std::string whole = bytes_of(run_);
  std::size_t most = 0;
  base::Random random(5);
  for (int i = 0; i < 60; ++i) {
    write(run_, whole.substr(0, random.below(static_cast<std::uint32_t>(whole.size()))));
    const KeptBookmarks kept = read_bookmarks(run_);
    EXPECT_LE(kept.bookmarks.all().size(), 3U);
    for (const auto& [id, one] : kept.bookmarks.all()) EXPECT_EQ(one.note, "note") << id;
    most = std::max(most, kept.bookmarks.all().size());
  }
  EXPECT_EQ(most, 3U);
}

TEST_F(BookmarkFile, WhatIsWrittenLaterIsBesideTheRecordingWhichStaysAsItIs) {
  record([](RecordingWriter& out) { out.put_metadata(bookmark_record({1, 3, 0.3, "first", "Anna"})); });
  const std::string recorded = bytes_of(run_);
  KeptBookmarks kept = read_bookmarks(run_);
  ASSERT_TRUE(kept.bookmarks.add(bookmark(12, "later \xc3\xbc <i>", "Ben")));
  ASSERT_EQ(kept.bookmarks.remove(1), std::nullopt);
  ASSERT_TRUE(write_bookmarks(run_, kept));
  EXPECT_EQ(bytes_of(run_), recorded);
  KeptBookmarks again = read_bookmarks(run_);
  EXPECT_EQ(again.problem, "");
  EXPECT_EQ(again.bookmarks, kept.bookmarks) << "what was removed stays away";
  ASSERT_TRUE(write_bookmarks(run_, again)) << "again and again";
  // Only these two files: nothing was left behind by replacing one.
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 2);
}

// Somebody else opened the recording while it was still being written.
TEST_F(BookmarkFile, WhatCameIntoTheRecordingSinceIsThereToo) {
  record([](RecordingWriter& out) {
    out.put_metadata(bookmark_record({1, 3, 0.3, "first", ""}));
    out.put_metadata(bookmark_record({2, 5, 0.5, "second", ""}));
  });
  write(
      beside(),
      R"({"format":1,"recorded_to":1,"bookmarks":[{"id":2,"cycle":9,"time":0.9,"note":"theirs","by":""}]})");
  const KeptBookmarks kept = read_bookmarks(run_);
  const std::vector<Bookmark> list = kept.bookmarks.in_order();
  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(list[0].note, "second");
  EXPECT_EQ(list[1].note, "theirs");
}

TEST_F(BookmarkFile, TwoWhoWriteDoNotLoseEachOthers) {
  record([](RecordingWriter&) {});
  KeptBookmarks mine = read_bookmarks(run_);
  KeptBookmarks theirs = read_bookmarks(run_);
  ASSERT_TRUE(mine.bookmarks.add(bookmark(1, "mine")));
  ASSERT_TRUE(theirs.bookmarks.add(bookmark(2, "theirs")));
  ASSERT_TRUE(write_bookmarks(run_, mine));
  const auto refused = write_bookmarks(run_, theirs);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().find("was written by another program meanwhile"), std::string::npos);
  EXPECT_EQ(read_bookmarks(run_).bookmarks, mine.bookmarks);
}

TEST_F(BookmarkFile, OneThatCannotBeReadIsSaidAndPutAsideNotLost) {
  record([](RecordingWriter&) {});
  for (const char* bytes : {"", "{", "[]", "null", R"({"format":2,"bookmarks":[]})", R"({"format":1})",
                            R"({"format":1,"bookmarks":7})", "\xff\xfe\x00", "1e99999"}) {
    write(beside(), bytes);
    KeptBookmarks kept = read_bookmarks(run_);
    EXPECT_NE(kept.problem.find("it is no JSON of the form"), std::string::npos) << bytes;
    ASSERT_TRUE(kept.bookmarks.add(bookmark(1, "new")));
    ASSERT_TRUE(write_bookmarks(run_, kept)) << bytes;
    EXPECT_EQ(bytes_of(beside() + ".unreadable"), bytes);
    EXPECT_EQ(read_bookmarks(run_).bookmarks.all().size(), 1U);
  }
}

TEST_F(BookmarkFile, AStrangersHoldNoMoreThanTheyMay) {
  record([](RecordingWriter& out) {
    // Metadata that only has the name.
    out.put_metadata({"missionlab bookmark", {}});
    out.put_metadata({"missionlab bookmark", {{"id", "-1"}, {"cycle", "1"}, {"time", "1"}}});
    out.put_metadata({"missionlab bookmark", {{"id", "7"}, {"cycle", "1"}, {"time", "nan"}}});
    out.put_metadata(
        {"missionlab bookmark", {{"id", "8"}, {"cycle", "1"}, {"time", "1"}, {"note", "\x1b[2J\xff"}}});
    out.put_metadata({"missionlab bookmark", {{"id", "99999999999999999999"}, {"removed", ""}}});
  });
  const KeptBookmarks recorded = read_bookmarks(run_);
  ASSERT_EQ(recorded.bookmarks.all().size(), 2U);
  EXPECT_EQ(recorded.bookmarks.find(8)->note, "[2J\xc3\xbf");
  EXPECT_EQ(recorded.bookmarks.find(7)->time, 0.0);

  std::string many =
      R"({"format":1,"recorded_to":9,"bookmarks":[{"id":"x"},[],7,{"id":1,"cycle":1,"time":1e999})";
  for (int i = 1; i <= 700; ++i)
    many += fmt::format(R"(,{{"id":{},"cycle":{},"time":1.5,"note":"{}"}})", i, i, std::string(800, 'n'));
  write(beside(), many + "]}");
  const KeptBookmarks kept = read_bookmarks(run_);
  EXPECT_EQ(kept.bookmarks.all().size(), Bookmarks::kMost);
  EXPECT_EQ(kept.bookmarks.find(3)->note.size(), Bookmarks::kMostNote);
  EXPECT_NE(kept.problem.find("204 of its entries are left out"), std::string::npos) << kept.problem;

  // What was left out is not lost where another one is kept.
  const std::string all = bytes_of(beside());
  KeptBookmarks fewer = kept;
  ASSERT_FALSE(fewer.bookmarks.remove(3));
  ASSERT_TRUE(write_bookmarks(run_, fewer));
  EXPECT_EQ(bytes_of(beside() + ".unreadable"), all);
  EXPECT_EQ(read_bookmarks(run_).bookmarks.all().size(), Bookmarks::kMost - 1);

  write(beside(), std::string(std::size_t{5} << 20, ' '));
  EXPECT_NE(read_bookmarks(run_).problem.find("has more than"), std::string::npos);
  write(beside(), std::string(200'000, '['));
  EXPECT_NE(read_bookmarks(run_).problem, "");
}

TEST_F(BookmarkFile, NoNoteIsLostForTheTimeBesideIt) {
  record([](RecordingWriter& out) {
    out.put_metadata(
        {"missionlab bookmark", {{"id", "1"}, {"cycle", "-3"}, {"time", "1e300"}, {"note", "a"}}});
    out.put_metadata({"missionlab bookmark", {{"id", "2"}, {"time", "nan"}, {"note", "b"}}});
    out.put_metadata(bookmark_record({3, 10, 1.0, "c", ""}));
  });
  const RunExtent run{20, 2.0};
  const KeptBookmarks recorded = read_bookmarks(run_, run);
  EXPECT_EQ(recorded.problem, "");
  ASSERT_EQ(recorded.bookmarks.all().size(), 3U);
  EXPECT_EQ(*recorded.bookmarks.find(1), (Bookmark{1, 20, 2.0, "a", ""}));
  EXPECT_EQ(*recorded.bookmarks.find(2), (Bookmark{2, 0, 0.0, "b", ""}));
  EXPECT_EQ(
      recorded.moved,
      "2 were written at moments that the run doesn't have, and moved to its beginning, its end or their "
      "cycle: `a` (1e+300 s), `b` (no time)");

  const std::string written = R"({"format":1,"recorded_to":3,"bookmarks":[
    {"id":4,"cycle":5,"time":NaN,"note":"NaN, 1e999 and \"-Infinity\" are words here"},
    {"id":5,"cycle":5,"time":-Infinity,"note":"e"},{"id":6,"cycle":1e400,"time":1e999,"note":"f"},
    {"id":7,"cycle":5,"time":0.5,"note":"g"},{"id":8,"note":"h"},{"id":9,"cycle":900,"time":90,"note":"i"}]})";
  write(beside(), written);
  KeptBookmarks kept = read_bookmarks(run_, run);
  EXPECT_EQ(kept.problem, "");
  ASSERT_EQ(kept.bookmarks.all().size(), 6U);
  EXPECT_EQ(kept.bookmarks.find(4)->note, "NaN, 1e999 and \"-Infinity\" are words here");
  EXPECT_EQ(kept.bookmarks.find(4)->time, 0.5);
  EXPECT_EQ(kept.bookmarks.find(6)->note, "f");
  EXPECT_EQ(kept.bookmarks.find(9)->cycle, 20U);
  EXPECT_TRUE(kept.moved.starts_with("5 were written at moments")) << kept.moved;
  // What was written is put aside once another one takes its place.
  ASSERT_TRUE(kept.bookmarks.add(bookmark(1, "new")));
  ASSERT_TRUE(write_bookmarks(run_, kept));
  EXPECT_EQ(bytes_of(beside() + ".unreadable"), written);
  EXPECT_EQ(read_bookmarks(run_, run).moved, "");
  EXPECT_EQ(read_bookmarks(run_, run).bookmarks.all().size(), 7U);
}

TEST_F(BookmarkFile, AnyBytesAreReadToAnEnd) {
  record([](RecordingWriter&) {});
  KeptBookmarks kept = read_bookmarks(run_);
  for (std::uint64_t i = 0; i < 5; ++i) ASSERT_TRUE(kept.bookmarks.add(bookmark(i, "note")));
  ASSERT_TRUE(write_bookmarks(run_, kept));
  const std::string whole = bytes_of(beside());
  base::Random random(7);
  for (int i = 0; i < 300; ++i) {
    std::string bytes = whole.substr(0, random.below(static_cast<std::uint32_t>(whole.size())) + 1);
    bytes[random.below(static_cast<std::uint32_t>(bytes.size()))] = static_cast<char>(random.below(256));
    write(beside(), bytes);
    EXPECT_LE(read_bookmarks(run_).bookmarks.all().size(), 5U);
  }
}

TEST_F(BookmarkFile, WhereNothingCanBeWrittenItIsSaid) {
  record([](RecordingWriter&) {});
  KeptBookmarks kept = read_bookmarks(run_);
  ASSERT_TRUE(kept.bookmarks.add(bookmark(1, "new")));
  const auto refused = write_bookmarks((folder_ / "nowhere" / "run.mcap").string(), kept);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().find("can't be written: No such file or directory"), std::string::npos);
  EXPECT_EQ(kept.written, "") << "it can be tried again";
  fs::create_directories(beside());  // a folder has its name
  EXPECT_NE(read_bookmarks(run_).problem.find("is no file"), std::string::npos);
}

TEST_F(BookmarkFile, GoesWithItsRecordingFromTheShelf) {
  const Shelf shelf(folder_.string());
  for (std::size_t i = 0; i < Shelf::kMostRuns; ++i) {
    const std::string run = (folder_ / fmt::format("2026-01-01 00.00.{:02} a.mcap", i)).string();
    write(run, "x");
    write(bookmark_path(run), "{}");
  }
  ASSERT_TRUE(shelf.place_for("b.mdl", 1.8e9));
  EXPECT_EQ(shelf.runs().size(), Shelf::kMostRuns - 1);
  EXPECT_FALSE(fs::exists(folder_ / "2026-01-01 00.00.00 a.mcap.bookmarks"));
  EXPECT_TRUE(fs::exists(folder_ / "2026-01-01 00.00.01 a.mcap.bookmarks"));
}

}  // namespace
}  // namespace mlab::history
