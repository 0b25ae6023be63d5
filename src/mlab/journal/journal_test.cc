#include "mlab/journal/journal.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "mlab/journal/journal_folder.h"

namespace mlab::journal {
namespace {

namespace fs = std::filesystem;

wire::HistoryEntry text_entry(std::uint32_t id, const std::string& path, const std::string& content) {
  wire::HistoryEntry out;
  out.mutable_text()->set_id(id);
  out.mutable_text()->set_path(path);
  out.mutable_text()->set_content(content);
  return out;
}

wire::HistoryEntry beginning() {
  wire::HistoryEntry out;
  out.mutable_beginning()->set_format(history::History::kFormat);
  out.mutable_beginning()->mutable_mission()->set_path("m.mdl");
  out.mutable_beginning()->mutable_mission()->add_texts(1);
  return out;
}

wire::HistoryEntry execute(std::uint64_t cycle) {
  wire::HistoryEntry out;
  out.set_cycle(cycle);
  out.set_time(0.1 * static_cast<double>(cycle));
  out.mutable_input()->mutable_posted()->set_kind(wire::HistoryPosted::EXECUTE);
  return out;
}

// A run that has just been started.
Batch first_batch(const std::string& text = "a mission") {
  Batch out;
  for (const wire::HistoryEntry& entry : {text_entry(1, "m.mdl", text), beginning(), execute(0)})
    out.entries.push_back(entry.SerializeAsString());
  wire::JournalSession session;
  session.set_mission("m.mdl");
  session.set_speed(10.0);
  out.session = session.SerializeAsString();
  out.progress.emplace();
  return out;
}

// It has come on, and something was told.
Batch next_batch(std::uint64_t cycle) {
  Batch out;
  out.progress.emplace();
  out.progress->set_cycle(cycle);
  out.progress->set_time(0.1 * static_cast<double>(cycle));
  out.progress->set_written_at(1e9 + static_cast<double>(cycle));
  out.notes.push_back({cycle, fmt::format("note {}", cycle)});
  return out;
}

class JournalTest : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(::testing::TempDir()) /
              fmt::format("mlab_journal_{}_{}", ::getpid(),
                          ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void write(const std::string& name, int cycles) const {
    auto journal = Journal::create(path(name));
    ASSERT_TRUE(journal) << journal.error();
    ASSERT_TRUE((*journal)->write(first_batch(), Reach::kMachine));
    for (int i = 1; i <= cycles; ++i)
      ASSERT_TRUE((*journal)->write(next_batch(static_cast<std::uint64_t>(i))));
  }

  fs::path folder_;
};

TEST_F(JournalTest, GivesBackWhatWasWritten) {
  write("run.journal", 3);
  const auto kept = read_journal(path("run.journal"));
  ASSERT_TRUE(kept) << kept.error().why;
  EXPECT_EQ(kept->cut, "");
  EXPECT_EQ(kept->history->inputs().size(), 1U);
  EXPECT_EQ(kept->history->text(1)->text(), "a mission");
  EXPECT_EQ(kept->history->last_cycle(), 3U) << "it had come so far";
  EXPECT_EQ(kept->stand.session.mission(), "m.mdl");
  EXPECT_EQ(kept->stand.progress.cycle(), 3U);
  ASSERT_EQ(kept->notes.size(), 3U);
  EXPECT_EQ(kept->notes[1].bytes, "note 2");
}

TEST_F(JournalTest, KeepsTheNewestNotes) {
  auto journal = Journal::create(path("run.journal"));
  ASSERT_TRUE(journal);
  Batch batch = first_batch();
  for (std::uint64_t n = 1; n <= Journal::kMostNotes; ++n) batch.notes.push_back({n, "x"});
  ASSERT_TRUE((*journal)->write(batch));
  ASSERT_TRUE((*journal)->write(next_batch(Journal::kMostNotes + 5)));
  journal->reset();
  const auto kept = read_journal(path("run.journal"));
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->notes.front().number, 6U);
  EXPECT_EQ(kept->notes.back().number, Journal::kMostNotes + 5);
}

TEST_F(JournalTest, OutlivesAKillAtOnce) {
  const pid_t child = ::fork();
  if (child == 0) {
    auto journal = Journal::create(path("run.journal"));
    if (journal && (*journal)->write(first_batch()) && (*journal)->write(next_batch(7))) ::raise(SIGKILL);
    ::_exit(1);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
  const auto kept = read_journal(path("run.journal"));
  ASSERT_TRUE(kept) << kept.error().why;
  EXPECT_EQ(kept->stand.progress.cycle(), 7U);
}

TEST_F(JournalTest, IsHeldByOneProcess) {
  auto journal = Journal::create(path("run.journal"));
  ASSERT_TRUE(journal);
  ASSERT_TRUE((*journal)->write(first_batch()));
  const pid_t child = ::fork();
  if (child == 0) {
    const auto stand = read_stand(path("run.journal"));
    const JournalFolder::Found found = JournalFolder(folder_.string()).look();
    const bool is_left = found.runs.empty() && found.held == 1;
    ::_exit(!stand && stand.error().kind == Unreadable::Kind::kHeld && is_left ? 0 : 1);
  }
  int status = 1;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  EXPECT_TRUE((*journal)->write(next_batch(1))) << "and its writer goes on";
}

// No file of this process may be larger, as long as this is there.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

 private:
  void (*handler_)(int);
  rlimit before_{};
};

TEST_F(JournalTest, OnAFullDiskLosesNothingThatItSaidWasWritten) {
  for (rlim_t size : {0, 1000, 5000, 20'000, 40'000, 90'000, 200'000}) {
    const std::string name = fmt::format("{}.journal", size);
    std::uint64_t written = 0;
    std::uint64_t refused = 0;
    {
      std::unique_ptr<Journal> journal;
      {
        const SmallDisk disk(size);
        auto made = Journal::create(path(name));
        if (!made) {
          EXPECT_FALSE(fs::exists(path(name))) << "nothing is left behind";
          continue;
        }
        journal = std::move(*made);
        if (journal->write(first_batch())) {
          for (std::uint64_t i = 1; i <= 60; ++i) {
            Batch batch = next_batch(i);
            batch.notes.front().bytes += std::string(1000, 'x');
            (journal->write(batch) ? written : refused) = i;
            if (refused != 0) break;
          }
          EXPECT_NE(refused, 0U) << size;
        }
      }
      if (written == 0) continue;
      ASSERT_TRUE(journal->write(next_batch(refused))) << "there is room again";
    }
    const auto kept = read_journal(path(name));
    ASSERT_TRUE(kept) << kept.error().why;
    EXPECT_EQ(kept->notes.size(), refused);
    EXPECT_EQ(kept->stand.progress.cycle(), refused);
  }
}

std::string bytes_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST_F(JournalTest, ThatIsDamagedIsReadAsFarAsItIsWholeOrRefused) {
  write("run.journal", 20);
  for (const char* part : {"run.journal", "run.journal-wal"}) {
    if (!fs::exists(path(part))) continue;
    const std::string whole = bytes_of(path(part));
    for (std::size_t at = 0; at < whole.size(); at += 97) {
      for (const char* one : {"run.journal", "run.journal-wal"}) {
        if (fs::exists(path(one)))
          fs::copy_file(path(one), path(std::string("x") + one), fs::copy_options::overwrite_existing);
      }
      std::string damaged = whole;
      damaged[at] = static_cast<char>(damaged[at] ^ 0x55);
      if (at % 2 == 0) damaged.resize(at);
      std::ofstream(path(std::string("x") + part), std::ios::binary) << damaged;
      const auto kept = read_journal(path("xrun.journal"));
      if (!kept) {
        EXPECT_FALSE(kept.error().why.empty());
      } else if (kept->cut.empty()) {
        EXPECT_EQ(kept->history->text(1)->text(), "a mission") << at;
      }
    }
  }
}

TEST_F(JournalTest, FolderSetsAsideWhatIsNoJournalAndForgetsWhatIsOver) {
  write("a.journal", 2);
  write("b.journal", 5);
  {
    auto over = Journal::create(path("c.journal"));
    Batch batch = first_batch();
    batch.progress->set_is_over(true);
    ASSERT_TRUE((*over)->write(batch));
    ASSERT_TRUE(Journal::create(path("d.journal"))) << "killed before anything was written";
  }
  std::ofstream(path("e.journal")) << "of somebody";
  const JournalFolder folder(folder_.string());
  const JournalFolder::Found found = folder.look();
  ASSERT_EQ(found.runs.size(), 2U);
  EXPECT_EQ(found.runs[0].path, path("b.journal")) << "the newest first";
  ASSERT_EQ(found.set_aside.size(), 1U);
  EXPECT_EQ(bytes_of(path("e.journal.unreadable")), "of somebody");
  EXPECT_FALSE(fs::exists(path("c.journal")));
  EXPECT_FALSE(fs::exists(path("d.journal")));
  EXPECT_TRUE(folder.look().set_aside.empty());
}

TEST_F(JournalTest, FolderKeepsTheNewest) {
  for (std::size_t i = 0; i < JournalFolder::kMost + 3; ++i)
    write(fmt::format("{:02}.journal", i), static_cast<int>(i + 1));
  const JournalFolder folder(folder_.string());
  EXPECT_EQ(folder.look().runs.size(), JournalFolder::kMost);
  EXPECT_FALSE(fs::exists(path("02.journal")));
  EXPECT_TRUE(fs::exists(path("03.journal")));
}

}  // namespace
}  // namespace mlab::journal
