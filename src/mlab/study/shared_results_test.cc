#include "mlab/study/shared_results.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

// The files that several processes keep one batch in. What they do together is tried by tests/cli.
namespace mlab::study {
namespace {

namespace fs = std::filesystem;

class SharedFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("mlab_shared_" + std::to_string(getpid()));
    fs::create_directories(folder_);
    path_ = (folder_ / "t \"1\".csv.runs").string();
  }
  void TearDown() override { fs::remove_all(folder_); }

  static Share share_of(std::uint32_t rank, const std::string& job) {
    Share out;
    out.rank = out.number = rank;
    out.count = 3;
    out.job = job;
    return out;
  }
  std::expected<SharedResults::Joined, std::string> join(std::uint32_t rank, const std::string& job = "a",
                                                         bool resumes = false) const {
    return SharedResults::join(path_, {{"mission", "m.mdl"}, {"start-time", ""}},
                               "now " + std::to_string(rank), share_of(rank, job), resumes);
  }
  static Identity whole(const std::string& start_time, const std::string& texts = "77") {
    return {{"mission", "m.mdl"}, {"start-time", start_time}, {"texts", texts}};
  }
  static Row row_of(std::uint32_t run) {
    Row out;
    out.key.run = run;
    out.outcome = "done";
    return out;
  }
  fs::path folder_;
  std::string path_;
};

TEST_F(SharedFiles, HaveOneClockAndTellOthersWhatWasDone) {
  auto first = join(0);
  ASSERT_TRUE(first) << first.error();
  auto second = join(1);
  ASSERT_TRUE(second) << second.error();
  EXPECT_EQ(first->start_time, "now 0");
  EXPECT_EQ(second->start_time, "now 0");
  EXPECT_EQ(first->results->begin(whole("now 0")), std::nullopt);
  EXPECT_EQ(second->results->begin(whole("now 0")), std::nullopt);
  EXPECT_TRUE(second->results->news().empty());
  ASSERT_TRUE(first->results->append(row_of(3)));
  ASSERT_TRUE(first->results->append(row_of(4)));
  const std::vector<Row> news = second->results->news();
  ASSERT_EQ(news.size(), 2U);
  EXPECT_EQ(news[1].key.run, 4U);
  EXPECT_TRUE(second->results->news().empty());
  EXPECT_FALSE(second->results->is_over());
  first->results->finish(false);
  EXPECT_TRUE(second->results->is_over());
  EXPECT_TRUE(rank_files(path_).empty());
  const auto late = join(2);
  ASSERT_TRUE(late) << late.error();
  EXPECT_EQ(late->results, nullptr) << "it has nothing to do any more";
  EXPECT_NE(join(2, "b")->results, nullptr) << "another start of the same batch";
}

TEST_F(SharedFiles, TellWhatCantBeReadAndLeaveItOut) {
  {
    const auto first = join(0);
    ASSERT_TRUE(first) << first.error();
    EXPECT_EQ(first->results->begin(whole("now 0")), std::nullopt);
    ASSERT_TRUE(first->results->append(row_of(3)));
  }
  const std::string row = row_line(row_of(4));
  std::ofstream(rank_file(path_, 0), std::ios::app) << row.substr(0, row.size() - 4) << "x\"}\n";
  std::ofstream(rank_file(path_, 1)) << "{\"mlab_b\n" << row_line(row_of(5));
  const auto third = join(2, "a", true);
  ASSERT_TRUE(third) << third.error();
  EXPECT_EQ(
      third->damage,
      (std::vector<std::string>{
          rank_file(path_, 0) + ": 1 line can't be read: line 3: what stood there is done again",
          rank_file(path_, 1) + ": line 1 can't be read, by which it is known of which batch it is: the "
                                "runs in it are done again"}));
  EXPECT_EQ(third->results->begin(whole("now 0")), std::nullopt);
  const std::vector<Row> news = third->results->news();
  ASSERT_EQ(news.size(), 1U);
  EXPECT_EQ(news[0].key.run, 3U);
  auto second = join(1, "a", true);
  ASSERT_TRUE(second) << second.error();
  const std::string why = second->results->begin(whole("now 0")).value_or("");
  EXPECT_NE(why.find(".rank-1, and that is no file of a batch's results"), std::string::npos) << why;
}

TEST_F(SharedFiles, RefuseThoseThatReadOtherTexts) {
  auto first = join(0);
  auto second = join(1);
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->results->begin(whole("now 0")), std::nullopt);
  EXPECT_EQ(second->results->begin(whole("now 0", "78")),
            "holds runs of another batch: the mission, or a file that it takes, has changed since");
}

TEST_F(SharedFiles, AreOfOneJobOrGoneOnWithWhereSomebodySaysSo) {
  {
    auto first = join(0);
    ASSERT_TRUE(first);
    EXPECT_EQ(first->results->begin(whole("now 0")), std::nullopt);
    ASSERT_TRUE(first->results->append(row_of(0)));
    EXPECT_EQ(join(0).error(), kResultsInUse) << "the same rank twice";
    EXPECT_EQ(join(1, "b").error(), kResultsInUse);
  }
  // As after a kill: in the middle of a line.
  std::ofstream(rank_file(path_, 0), std::ios::app) << R"({"key":[0,0,)";
  EXPECT_NE(join(1, "b").error().find("holds 1 runs of a batch that was interrupted"), std::string::npos);
  {
    auto again = join(1, "b", true);
    ASSERT_TRUE(again) << again.error();
    EXPECT_EQ(again->start_time, "now 0");
    EXPECT_EQ(again->results->begin(whole("now 0")), std::nullopt);
    EXPECT_EQ(again->results->news().size(), 1U);
    ASSERT_TRUE(again->results->append(row_of(1)));
  }
  // Who was killed comes back under the same job.
  auto back = join(0, "a");
  ASSERT_TRUE(back) << back.error();
  EXPECT_EQ(back->results->begin(whole("now 0")), std::nullopt);
  EXPECT_EQ(back->results->news().size(), 2U);
  back->results.reset();
  // One process alone takes over what several have begun.
  EXPECT_FALSE(ResultsFile::open(path_, whole("now 0"), false));
  auto alone = ResultsFile::open(path_, whole("now 0"), true);
  ASSERT_TRUE(alone) << alone.error();
  EXPECT_EQ(alone->rows.size(), 2U);
  alone->file->finish();
  EXPECT_TRUE(rank_files(path_).empty());
}

TEST_F(SharedFiles, LeaveAloneWhatIsNoneOfTheirs) {
  std::ofstream(path_) << "my diary\n";
  EXPECT_FALSE(join(0));
  EXPECT_FALSE(join(0, "a", true));
  fs::remove(path_);
  fs::create_directory(path_);
  EXPECT_FALSE(join(0));
  fs::remove(path_);
  fs::create_directory(rank_file(path_, 0));
  EXPECT_FALSE(join(0));
  fs::create_directory(rank_file(path_, 1));
  std::ofstream(path_ + ".rank-2x") << "{}";
  EXPECT_EQ(rank_files(path_).size(), 2U);
  EXPECT_FALSE(SharedResults::join("/no/such/folder/file", {}, "now", share_of(0, "a"), false));
}

}  // namespace
}  // namespace mlab::study
