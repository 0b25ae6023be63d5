#include "mlab/study/batch.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "mlab/base/random.h"
#include "mlab/base/testing/processor_time.h"
#include "mlab/base/testing/source_folder.h"
#include "mlab/study/failure_recordings.h"
#include "mlab/study/page.h"
#include "mlab/study/table.h"
#include "mlab/text/escape.h"

// Batches of a mission of ours, in this process.
namespace mlab::study {
namespace {

namespace fs = std::filesystem;
using Fields = std::vector<std::pair<std::string, std::string>>;

/// All that belongs to one batch.
struct Made {
  explicit Made(Fields fields, const std::string& mission = "patrol") {
    fields.emplace_back("mission", base::source_folder() + "/missions/" + mission + "/" + mission + ".mdl");
    for (const auto& [field, value] : fields) {
      const auto problem = take(definition, field, written_in_option("--" + field, value));
      EXPECT_FALSE(problem) << text::render(*problem);
    }
    EXPECT_FALSE(settle(definition));
    plan = std::make_unique<Plan>(definition);
    for (std::uint32_t version = 0; version < plan->versions(); ++version) {
      const Written& file = version == 0 ? definition.mission : definition.against;
      robot::ProgramSources sources;
      sources.folder = fs::path(file.text).parent_path().string();
      mdl::LoadOptions around;
      around.files = once.files();
      run::RunSettings manner;
      manner.executive.proceed_all = true;
      scenes.push_back(std::make_unique<Scene>(definition, *plan, file, around, sources, manner));
      text::Diagnostics sink;
      EXPECT_TRUE(scenes.back()->prepare(sink)) << text::render(sink);
    }
    begin(nullptr);
  }
  void begin(Keeper* kept) { batch = std::make_unique<Batch>(definition, *plan, scenes, kept); }
  Batch::End run(int threads, const std::function<bool()>& wants_end = [] { return false; }) {
    return batch->run(threads, wants_end, [](const Progress&) {});
  }
  std::string csv() const { return csv_of(*batch, summary_of(*batch, definition, *plan), definition, *plan); }

  Definition definition;
  ReadOnce once;
  std::unique_ptr<Plan> plan;
  std::vector<std::unique_ptr<Scene>> scenes;
  std::unique_ptr<Batch> batch;
};

const Fields kSome = {{"runs", "12"}, {"set", "base_velocity=3,5"}, {"set", "robot_radius=0.2..2"}};

std::string whole_table(const Fields& fields, int threads) {
  Made made(fields);
  EXPECT_EQ(made.run(threads), Batch::End::kDone);
  return made.csv();
}

class KeptFile : public ::testing::Test {
 protected:
  void TearDown() override { fs::remove(path_); }
  const std::string path_ =
      (fs::path(testing::TempDir()) / ("mlab_batch_" + std::to_string(getpid()))).string();
  const Identity identity_ = {{"mission", "patrol"}, {"runs", "12"}};
};

TEST(Batch, IsTheSameForAnyNumberOfThreads) {
  const std::string one = whole_table(kSome, 1);
  EXPECT_EQ(std::count(one.begin(), one.end(), '\n'), 1 + 24);
  EXPECT_EQ(whole_table(kSome, 4), one);
}

TEST(Batch, HasNoColumnThatCouldBeSetToo) {
  Made made(Fields{{"runs", "1"}, {"set", "base_velocity=3"}});
  ASSERT_EQ(made.run(1), Batch::End::kDone);
  const std::string all = made.csv();
  std::istringstream header(all.substr(0, all.find('\r')));
  std::size_t columns = 0;
  for (std::string name; std::getline(header, name, ','); ++columns)
    EXPECT_EQ(is_table_column(name), name != "base_velocity") << name;
  EXPECT_GT(columns, 10U);
}

TEST(Batch, CountsWhatWasDrawnAndSet) {
  Made made(kSome);
  ASSERT_EQ(made.run(2), Batch::End::kDone);
  const Summary summary = summary_of(*made.batch, made.definition, *made.plan);
  EXPECT_EQ(summary.runs, 24U);
  EXPECT_EQ(summary.failed, 0U);
  ASSERT_EQ(summary.cells.size(), 2U);
  // Who drives faster is done sooner, seed by seed.
  for (std::uint32_t run = 0; run < 12; ++run)
    EXPECT_GT(made.batch->cell(0, 0).rows[run][Number::kDuration],
              made.batch->cell(0, 1).rows[run][Number::kDuration]);
}

TEST_F(KeptFile, MakesAnInterruptedBatchTheSame) {
  const std::string whole = whole_table(kSome, 2);
  constexpr std::uint64_t kSeed = 4711;
  base::Random random(kSeed);
  for (int round = 0; round < (base::kIsSlowBuild ? 2 : 4); ++round) {
    fs::remove(path_);
    Batch::End end = Batch::End::kInterrupted;
    int sessions = 0;
    for (; end != Batch::End::kDone && sessions < 200; ++sessions) {
      auto opened = ResultsFile::open(path_, identity_, true);
      ASSERT_TRUE(opened) << opened.error();
      Made made(kSome);
      made.begin(opened->file.get());
      made.batch->take(std::move(opened->rows));
      std::atomic<std::int64_t> cycles = static_cast<std::int64_t>(5'000 + random.below(40'000));
      end = made.run(1 + static_cast<int>(random.below(3)), [&] { return --cycles < 0; });
      if (end == Batch::End::kDone) {
        EXPECT_EQ(made.csv(), whole) << "seed " << kSeed << ", round " << round;
      }
      opened->file.reset();
      // As if it had been killed in the middle of a line.
      const auto size = fs::file_size(path_);
      if (round % 2 == 1 && size > 400) fs::resize_file(path_, size - random.below(150));
    }
    EXPECT_EQ(end, Batch::End::kDone);
    EXPECT_GT(sessions, 1);
  }
}

TEST(Batch, SaysWhereAFileIsNamedThatIsNotThere) {
  Definition definition;
  const auto source = std::make_shared<const text::Source>("study.toml", "mission = \"none.mdl\"");
  definition.mission = {"none.mdl", {source, {11, 19}}};
  const Plan plan(definition);
  Scene scene(definition, plan, definition.mission, {}, {}, {});
  text::Diagnostics sink;
  EXPECT_FALSE(scene.prepare(sink));
  ASSERT_EQ(sink.items().size(), 1U);
  EXPECT_EQ(source->text(sink.items()[0].place.span), "none.mdl");
}

// A line may be damaged and a line all the same.
TEST(Batch, TakesNoRunOfAnotherSeed) {
  Made made(kSome);
  Row row;
  row.outcome = "done";
  row.seed = 2;
  made.batch->take({row});
  EXPECT_EQ(made.batch->progress().done, 0U);
  row.seed = 1;
  made.batch->take({row});
  EXPECT_EQ(made.batch->progress().done, 1U);
}

std::set<std::string> files_in(const std::string& folder) {
  std::set<std::string> out;
  for (const auto& entry : fs::directory_iterator(folder)) out.insert(entry.path().filename().string());
  return out;
}

TEST_F(KeptFile, MakesRecordingsThatWereInterruptedTheSame) {
  // A cause for each of three speeds.
  const Fields fields = {{"runs", "2"},
                         {"set", "base_velocity=0,3,5"},
                         {"success", "duration < 1 and contacts < 0"},
                         {"patience", "10"},
                         {"for", "40"}};
  const std::string folder = path_ + ".failures";
  Made made(fields);
  ASSERT_EQ(made.run(2), Batch::End::kDone);
  Summary whole = summary_of(*made.batch, made.definition, *made.plan);
  // Each of these runs has a cause of its own.
  whole.failures.resize(1);
  for (const RunKey key : {RunKey{0, 1, 0}, RunKey{0, 2, 0}}) {
    whole.failures.push_back(whole.failures.front());
    whole.failures.back().first = key;
  }
  const auto record = [&](Summary& summary, Keeper& kept, int asks) {
    return record_failures(*made.batch, summary, made.definition, *made.plan, made.scenes, folder, {}, &kept,
                           [&] { return --asks < 0; });
  };
  const std::set<std::string> names = {"combination-1-seed-1.mcap", "combination-2-seed-1.mcap",
                                       "combination-3-seed-1.mcap"};
  int interrupted = 0;
  for (const int asks : {0, 600, 1'000'000}) {
    auto opened = ResultsFile::open(path_, identity_, true);
    ASSERT_TRUE(opened) << opened.error();
    opened->file->append(made.batch->cell(0, 0).rows[0]);
    Summary summary = whole;
    const FailureRecordings out = record(summary, *opened->file, asks);
    EXPECT_EQ(out.made + out.missing, 3U);
    EXPECT_TRUE(out.problems.empty()) << out.problems[0];
    std::set<std::string> there = files_in(folder);
    there.erase("combination-3-seed-1.mcap.part");
    EXPECT_EQ(there.size(), out.made) << "a half one was left";
    if (out.missing > 0) {
      ++interrupted;
      // Killed while it was written, and just before it got its name.
      std::ofstream(folder + "/combination-3-seed-1.mcap.part") << "a half";
      opened->file->append_recording({0, 2, 0}, folder + "/combination-3-seed-1.mcap");
      continue;
    }
    EXPECT_EQ(files_in(folder), names);
    EXPECT_EQ(summary.failures[2].recording, folder + "/combination-3-seed-1.mcap");
  }
  EXPECT_EQ(interrupted, 2);
  fs::remove_all(folder);
}

TEST_F(KeptFile, IsLeftAloneWhereItIsOfAnotherBatchOrNone) {
  auto opened = ResultsFile::open(path_, identity_, false);
  ASSERT_TRUE(opened) << opened.error();
  EXPECT_EQ(ResultsFile::open(path_, identity_, true).error(), "is in use by another batch that runs now");
  Row row;
  row.seed = 77;
  row.outcome = "failed";
  row.cause = "step 1: \"so\" failed";
  EXPECT_TRUE(opened->file->append(row));
  opened->file.reset();

  const Identity other = {{"mission", "patrol"}, {"runs", "13"}};
  for (const Identity& identity : {identity_, other})
    EXPECT_NE(ResultsFile::open(path_, identity, false).error().find("--resume goes on"), std::string::npos);
  EXPECT_EQ(ResultsFile::open(path_, other, true).error(),
            "holds runs of another batch: its runs is `12`, here it is `13`");
  EXPECT_EQ(ResultsFile::kept_word(path_, "mission"), "patrol");
  const auto again = ResultsFile::open(path_, identity_, true);
  ASSERT_TRUE(again) << again.error();
  ASSERT_EQ(again->rows.size(), 1U);
  EXPECT_EQ(again->rows[0].cause, row.cause);
  EXPECT_EQ(again->rows[0].seed, row.seed);
}

// After a power failure, say.
TEST_F(KeptFile, CountsAsFarAsItCanBeRead) {
  Row row;
  row.outcome = "done";
  const std::string head = header_line(identity_);
  std::string lines;
  for (row.key.run = 0; row.key.run < 2; ++row.key.run) lines += row_line(row);
  const std::string all = head + lines + std::string(40, '\0') + "\n{\"key\":[0,0\n" + row_line(row);
  std::ofstream(path_) << all;
  auto opened = ResultsFile::open(path_, identity_, true);
  ASSERT_TRUE(opened) << opened.error();
  EXPECT_EQ(opened->rows.size(), 3U);
  EXPECT_EQ(fs::file_size(path_), all.size()) << "nothing of it is thrown away";
  EXPECT_EQ(opened->damage, std::vector<std::string>{path_ + ": 2 lines can't be read, the first of them "
                                                             "line 4: what stood there is done again"});
  opened->file.reset();
  const std::string part = rank_file(path_, 2);
  std::ofstream(part) << "{\"mlab_b\n" << lines;
  std::ofstream(path_) << head << lines;
  opened = ResultsFile::open(path_, identity_, true);
  ASSERT_TRUE(opened) << opened.error();
  EXPECT_EQ(opened->damage,
            std::vector<std::string>{part + ": line 1 can't be read, by which it is known of which batch it "
                                            "is: the runs in it are done again"});
  EXPECT_EQ(opened->rows.size(), 2U);
  opened->file.reset();
  fs::remove(part);
  std::ofstream(path_) << "{\"mlab_b\n" << lines;
  const auto refused = ResultsFile::open(path_, identity_, true);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().find("its first line is damaged"), std::string::npos) << refused.error();
  EXPECT_NE(refused.error().find("move it away"), std::string::npos) << refused.error();
}

// A bit of a line that has changed makes it no run, wherever it is; but in the name of the checksum, where
// the run is the one that was written.
TEST_F(KeptFile, NoticesEveryBitThatHasChanged) {
  Row row;
  row.seed = 12;
  row.outcome = "failed";
  row.cause = "step 1 failed";
  row.numbers[0] = 12.5;
  const std::string head = header_line(identity_);
  const std::string line = row_line(row);
  EXPECT_EQ(understand(head + line)->damaged, 0U);
  int unnoticed = 0;
  for (std::size_t bit = 0; bit < 8 * (line.size() - 1); ++bit) {
    std::string changed = line;
    changed[bit / 8] = static_cast<char>(changed[bit / 8] ^ (1 << (bit % 8)));
    const auto read = understand(head + changed + line);
    ASSERT_TRUE(read) << read.error();
    if (read->damaged > 0) continue;
    ++unnoticed;
    ASSERT_EQ(read->rows.size(), 2U) << changed;
    EXPECT_EQ(row_line(read->rows[0]), line) << changed;
  }
  EXPECT_LE(unnoticed, 8 * 3);
  std::string other = head;
  other[other.find("patrol")] = 'q';
  EXPECT_FALSE(understand(other + line)) << "nor is it taken for another batch";
}

TEST_F(KeptFile, OfAnEarlierVersionCountsWithoutChecksums) {
  std::ofstream(path_) << R"({"mlab_batch":1,"batch":{"mission":"patrol","runs":"12"}})" << '\n'
                       << R"({"key":[0,0,3],"seed":4,"success":true,"outcome":"done","numbers":)"
                       << nlohmann::json(std::vector<double>(kNumbers.size(), 1.5)).dump() << "}\n";
  auto opened = ResultsFile::open(path_, identity_, true);
  ASSERT_TRUE(opened) << opened.error();
  EXPECT_TRUE(opened->damage.empty());
  ASSERT_EQ(opened->rows.size(), 1U);
  EXPECT_TRUE(opened->file->append(opened->rows[0]));
  opened->file.reset();
  EXPECT_EQ(ResultsFile::open(path_, identity_, true)->rows.size(), 2U);
}

TEST_F(KeptFile, RefusesWhatIsNoneOfOurs) {
  for (const char* text :
       {"my diary\n", "my diary", "{\"mlab_batch\":1}\n", "{}\n[]\n", "\n", "mission,seed\r\n1,2\r\n"}) {
    std::ofstream(path_) << text;
    EXPECT_FALSE(ResultsFile::open(path_, identity_, true)) << text;
    std::ostringstream now;
    now << std::ifstream(path_).rdbuf();
    EXPECT_EQ(now.str(), text);
  }
  EXPECT_FALSE(ResultsFile::open("/no/such/folder/file", identity_, true));
}

// What a device gives has no end.
TEST_F(KeptFile, IsNoDevice) {
  const auto opened = ResultsFile::open("/dev/full", Identity{}, false);
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error(), "is no ordinary file");
}

TEST(Batch, StopsEarlyAtTheSameRunWhateverTheThreads) {
  const Fields fields = {{"runs", "400"}, {"require", "success >= 0.5 @ 0.95"}, {"until", "decided"}};
  Made one(fields);
  ASSERT_EQ(one.run(1), Batch::End::kDone);
  const statistics::Count count = one.batch->cell(0, 0).successes;
  EXPECT_LT(count.trials, 30U);
  EXPECT_GT(statistics::confidence_sequence(count, 0.95).low, 0.5);
  EXPECT_LT(statistics::confidence_sequence({count.successes - 1, count.trials - 1}, 0.95).low, 0.5);
  Made other(fields);
  ASSERT_EQ(other.run(4), Batch::End::kDone);
  EXPECT_EQ(one.csv(), other.csv());
  EXPECT_TRUE(summary_of(*one.batch, one.definition, *one.plan).are_all_met());
}

TEST(Batch, GroupsFailuresByCauseAndSaysHowToRepeatThem) {
  Made made(
      {{"runs", "10"}, {"set", "base_velocity=3,5"}, {"success", "outcome == done and duration < 100"}});
  ASSERT_EQ(made.run(2), Batch::End::kDone);
  const Summary summary = summary_of(*made.batch, made.definition, *made.plan);
  ASSERT_EQ(summary.failures.size(), 1U);
  const FailureGroup& group = summary.failures[0];
  EXPECT_EQ(group.cause, "not so: duration < 100");
  EXPECT_EQ(group.count, summary.failed);
  EXPECT_NE(group.command.find("patrol.mdl --headless --proceed --seed 1 --set base_velocity=3"),
            std::string::npos)
      << group.command;
}

TEST(Batch, ComparesTwoVersionsInPairs) {
  Made made({{"runs", "10"}, {"against", base::source_folder() + "/missions/patrol/patrol.mdl"}});
  ASSERT_EQ(made.run(2), Batch::End::kDone);
  const Summary summary = summary_of(*made.batch, made.definition, *made.plan);
  ASSERT_EQ(summary.comparisons.size(), 1U);
  EXPECT_EQ(summary.comparisons[0].pairs, 10U);
  EXPECT_EQ(summary.comparisons[0].p, 1.0);
  // The same mission with the same seeds is the same.
  for (const Comparison::Difference& difference : summary.comparisons[0].differences)
    EXPECT_EQ(difference.ranks.pairs, 0U);
}

TEST(Tables, QuoteWhatNeedsIt) {
  Made made({{"runs", "2"}, {"set", "formation_spacing=5"}, {"success", "outcome == aborted"}});
  made.definition.dimensions[0].name.text = "a \"b\", c";
  Row row;
  row.seed = 1;
  row.outcome = "failed";
  row.cause = "line\nbreak";
  made.batch->take({row});
  const std::string csv = made.csv();
  EXPECT_NE(csv.find("mission,combination,\"a \"\"b\"\", c\",seed,"), std::string::npos) << csv;
  EXPECT_NE(csv.find(",\"line\nbreak\","), std::string::npos) << csv;
  EXPECT_TRUE(csv.ends_with("\r\n"));
}

TEST(Tables, AndPagesSayTheSame) {
  Made made({{"runs", "6"}, {"set", "base_velocity=3,5"}, {"success", "duration < 100"}});
  ASSERT_EQ(made.run(2), Batch::End::kDone);
  const Summary summary = summary_of(*made.batch, made.definition, *made.plan);
  const auto json = nlohmann::json::parse(json_of(*made.batch, summary, made.definition, *made.plan, "0.0"));
  EXPECT_EQ(json["runs"].size(), 12U);
  EXPECT_EQ(json["runs"][0]["base_velocity"], "3");
  EXPECT_EQ(json["summary"]["combinations"].size(), 2U);
  EXPECT_EQ(json["summary"]["combinations"][0]["runs"], 6);
  const std::string page =
      page_of(*made.batch, summary, made.definition, *made.plan, {"A <b> & \"c\"", "p.html", "0.0"});
  EXPECT_NE(page.find("<title>Batch: A &lt;b&gt; &amp; &quot;c&quot;</title>"), std::string::npos);
  EXPECT_EQ(page.find("<script"), std::string::npos);
  EXPECT_EQ(page.find("http:"), std::string::npos);
  EXPECT_EQ(page.find("https:"), std::string::npos);
  EXPECT_NE(page.find(text::markup(summary.failures[0].command)), std::string::npos);
}

}  // namespace
}  // namespace mlab::study
