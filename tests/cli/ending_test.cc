// How the command ends where nobody takes what it prints, and where somebody wants it to end.

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace mlab {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr const char* kWideMap =
    "SITE Test\nMISSION-AREA 3000 3000\nCONTROL MEASURES:\nPP Here 100 100\nPP There 2900 2900\n";
constexpr const char* kShortMission =
    "MISSION NAME Short\nOVERLAY map.odl\nUNIT <u> ROBOT\nCOMMAND LIST:\n0. UNIT u START Here\n";
constexpr const char* kLongMission =
    "MISSION NAME Long\nOVERLAY map.odl\nUNIT <u> ROBOT\nCOMMAND LIST:\n0. UNIT u START Here\n1. UNIT u "
    "MOVETO There\n";

constexpr const char* kScout = "robot Scout is Rover {\n  movement = Noise();\n}\n";
constexpr const char* kHistoric =
    "bindArch AuRA;\ninstBP <1,1>|R| $R1 from vehicle( bound_to = one:SPIDER( $W ) );\n"
    "instBP $W from movement( v = RAMBLE() );\n";

class Ending : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              ("mlab_ending_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    std::ofstream(folder_ / "map.odl") << kWideMap;
    std::ofstream(folder_ / "short.mdl") << kShortMission;
    std::ofstream(folder_ / "long.mdl") << kLongMission;
    std::ofstream(folder_ / "scout.cdl") << kScout;
    std::ofstream(folder_ / "old.cdl") << kHistoric;
    std::ofstream lsp(folder_ / "lsp.txt");
    for (const std::string message :
         {R"({"jsonrpc":"2.0","id":1,"method":"initialize","params":{}})",
          R"({"jsonrpc":"2.0","id":2,"method":"shutdown"})", R"({"jsonrpc":"2.0","method":"exit"})"})
      lsp << "Content-Length: " << message.size() << "\r\n\r\n" << message;
  }
  void TearDown() override { fs::remove_all(folder_); }

  // Its exit status; what it says about that is in err.txt.
  int shell(const std::string& line) const {
    const std::string whole = "cd '" + folder_.string() + "' && { " + line + "; } 2> err.txt < /dev/null";
    // NOLINTNEXTLINE(concurrency-mt-unsafe): a test program has one thread
    const int status = std::system(whole.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  std::string text_of(const std::string& file) const {
    std::ifstream stream(folder_ / file);
    return (std::ostringstream() << stream.rdbuf()).str();
  }
  // The outcome that a report tells; empty: there is none, or half of one.
  std::string outcome(const std::string& file) const {
    const auto report = nlohmann::json::parse(text_of(file), nullptr, false);
    return report.is_object() ? report.value("outcome", "") : "";
  }

  fs::path folder_;
};

TEST_F(Ending, AWriteErrorOnStandardOutputIsStatusOneForEveryCommand) {
  const std::string mlab = std::string("'") + MLAB_COMMAND + "' ";
  for (const char* arguments :
       {"--help", "--version", "run --help", "check short.mdl", "check --format json short.mdl", "describe",
        "describe --format json", "describe Noise", "describe robot", "run --headless short.mdl",
        "run --headless --quiet short.mdl", "bench --robots 2 --cycles 1", "fmt - < short.mdl",
        "import old.cdl", "build --emit cnl scout.cdl", "build --emit cpp scout.cdl",
        "build --emit formula scout.cdl", "build --emit graph scout.cdl", "lsp < lsp.txt"}) {
    EXPECT_EQ(shell(mlab + arguments + " > /dev/full"), 1) << arguments;
    EXPECT_NE(text_of("err.txt").find("standard output could not be written: No space left on device"),
              std::string::npos)
        << arguments << ": " << text_of("err.txt");
    EXPECT_EQ(shell(mlab + arguments + " > out.txt"), 0) << arguments << ": " << text_of("err.txt");
    EXPECT_NE(text_of("out.txt"), "") << arguments;
  }
}

TEST_F(Ending, AReaderWhoLeavesOrNeverWasIsAWriteErrorAndNoSignal) {
  const std::string mlab = std::string("'") + MLAB_COMMAND + "' ";
  EXPECT_EQ(shell(mlab + "describe --format json >&-"), 1);
  // The reader is gone for sure before a word is written.
  const std::string gone = "mkfifo gone; { sleep 0.2 < gone & }; exec 3> gone; wait; ";
  EXPECT_EQ(shell(gone + mlab + "describe --format json >&3"), 1);
  EXPECT_EQ(text_of("err.txt"), "") << "who closes a pager knows it";
}

TEST_F(Ending, TheReportIsWrittenWhereNobodyReadsWhatIsPrinted) {
  EXPECT_EQ(shell(std::string("'") + MLAB_COMMAND + "' run --headless short.mdl --report r.json > /dev/full"),
            1);
  EXPECT_EQ(outcome("r.json"), "done");
}

/// A command that takes long, as a process of its own: at first a run of a mission that takes hours.
class LongRun {
 public:
  LongRun(const fs::path& folder, int output,
          std::vector<std::string> words = {"run", "--headless", "long.mdl", "--speed", "1", "--report",
                                            "r.json"}) {
    words.insert(words.begin(), MLAB_COMMAND);
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    process_ = ::fork();
    if (process_ != 0) return;
    ::dup2(output, STDOUT_FILENO);
    const int nothing = ::open("/dev/null", O_RDWR);
    ::dup2(nothing, STDIN_FILENO);
    if (::chdir(folder.c_str()) != 0) ::_exit(98);
    const int errors = ::open("err.txt", O_WRONLY | O_CREAT | O_TRUNC, 0600);
    ::dup2(errors, STDERR_FILENO);
    ::execv(MLAB_COMMAND, arguments.data());
    ::_exit(99);
  }
  void signal(int number) const { ::kill(process_, number); }
  // Until it takes signals itself, as it does from its first word on.
  void wait_until_it_listens() const {
    for (int tries = 0; tries < 3000; ++tries, std::this_thread::sleep_for(std::chrono::milliseconds(20))) {
      std::ifstream status("/proc/" + std::to_string(process_) + "/status");
      for (std::string line; std::getline(status, line);) {
        if (line.starts_with("SigCgt:") &&
            (std::stoull(line.substr(7), nullptr, 16) >> (SIGTERM - 1) & 1U) != 0)
          return;
      }
    }
    ADD_FAILURE() << "it never listens to SIGTERM";
  }
  /// @return  its exit status; -1: a signal ended it
  int wait() const {
    int status = 0;
    ::waitpid(process_, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  pid_t process_ = -1;
};

class Interrupted : public Ending, public testing::WithParamInterface<int> {
 protected:
  void SetUp() override {
    Ending::SetUp();
    ASSERT_EQ(::pipe2(pipe_, O_CLOEXEC), 0);
  }
  void TearDown() override {
    for (const int end : pipe_) ::close(end);
    Ending::TearDown();
  }
  // Reads until the run says that it goes.
  void wait_for_start() {
    std::string seen;
    char block[512];
    while (seen.find("step 1") == std::string::npos) {
      const ssize_t n = ::read(pipe_[0], block, sizeof block);
      ASSERT_GT(n, 0) << seen;
      seen.append(block, static_cast<std::size_t>(n));
    }
  }
  // The pipe takes no more.
  void fill() {
    ::fcntl(pipe_[1], F_SETFL, O_NONBLOCK);
    const std::string block(4096, '\n');
    while (::write(pipe_[1], block.data(), block.size()) > 0) {
    }
    ::fcntl(pipe_[1], F_SETFL, 0);
  }
  // With summary and report, within 2 s on a machine that has nothing else to do.
  void expect_end(const LongRun& run, Clock::time_point asked) {
    EXPECT_EQ(run.wait(), 1) << "it did not come to its end";
    EXPECT_LT(Clock::now() - asked, std::chrono::seconds(10));
    EXPECT_EQ(outcome("r.json"), "interrupted");
  }

  int pipe_[2] = {-1, -1};
};

TEST_P(Interrupted, ARunEndsWithSummaryAndReportOnOneSignalOrOneKeyThatComesTwice) {
  for (const int times : {1, 2}) {
    const LongRun run(folder_, pipe_[1]);
    wait_for_start();
    const auto asked = Clock::now();
    for (int i = 0; i < times; ++i) run.signal(GetParam());
    expect_end(run, asked);
    fs::remove(folder_ / "r.json");
    char block[8192];
    const ssize_t n = ::read(pipe_[0], block, sizeof block);
    EXPECT_NE(std::string(block, static_cast<std::size_t>(std::max<ssize_t>(n, 0))).find("interrupted after"),
              std::string::npos);
  }
}

TEST_P(Interrupted, ARunEndsWithItsReportWhereTheReaderTakesNothing) {
  fill();
  const LongRun run(folder_, pipe_[1]);
  run.wait_until_it_listens();
  const auto asked = Clock::now();
  run.signal(GetParam());
  expect_end(run, asked);
}

// Nor does it wait for code that sleeps, in a cell or as an executable.
TEST_P(Interrupted, ARunEndsWhileRobotsWithCodeOfTheirOwnAreAwaited) {
  std::ofstream(folder_ / "sleeper.cnl") << "init\n#include <unistd.h>\niend\n"
                                            "procedure Vector Sleep with\nheader\nbody\n  if (time > 1.0) "
                                            "for (;;) sleep(1000);\n  output = {1, 0, 0};\npend\n"
                                            "node go is Sleep with nend\nnode wheels is Drive with v = go; "
                                            "base_velocity = 1; max_velocity = 1; nend\n";
  std::ofstream(folder_ / "long.mdl")
      << "OVERLAY map.odl\nNEW-ROBOT s \"sleeper.cnl\"\nUNIT <u> s s s\nCOMMAND LIST:\n"
         "0. UNIT u START Here\n1. UNIT u MOVETO There\n";
  const LongRun run(folder_, pipe_[1]);
  wait_for_start();
  std::this_thread::sleep_for(std::chrono::seconds(3));  // it sleeps by then
  const auto asked = Clock::now();
  run.signal(GetParam());
  expect_end(run, asked);
}

// What looks at a recorded run says how far it came, and what there is of what was asked for.
TEST_P(Interrupted, ALookAtARecordingSaysHowFarItCame) {
  std::ofstream many(folder_ / "many.mdl");
  many << "OVERLAY map.odl\nUNIT <u>";
  for (int i = 0; i < 40; ++i) many << " ROBOT";
  many << "\nCOMMAND LIST:\n0. UNIT u START Here\n1. UNIT u MOVETO There\n";
  many.close();
  ASSERT_EQ(shell(std::string("'") + MLAB_COMMAND +
                  "' run --headless many.mdl --limit 800 --quiet --record run.mcap > out.txt"),
            1);
  struct Case {
    std::vector<std::string> words;
    std::vector<std::string> said;
  };
  const int nobody = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  for (const auto& [words, said] :
       {Case{{"replay", "--headless", "run.mcap", "--report", "r.json", "--record", "again.mcap"},
             {"mlab replay: interrupted after ", " of 800.0 s; ", "the report r.json is not written",
              "the recording again.mcap ends there"}},
        Case{{"trace", "run.mcap", "--robot", "1", "--ports", "*"},
             {"mlab trace: interrupted after ", " of 800.0 s; "}},
        Case{{"trace", "run.mcap", "--robot", "99", "--ports", "*"},
             {"mlab trace: interrupted while looking for robots that come later; no row is written"}},
        Case{{"compare", "run.mcap", "run.mcap", "--quiet", "--html", "c.html"},
             {"mlab compare: interrupted after ", " % of the two runs; ", "also in c.html"}}}) {
    const LongRun run(folder_, nobody, words);
    run.wait_until_it_listens();
    run.signal(GetParam());
    EXPECT_EQ(run.wait(), 1) << words.front();
    for (const std::string& part : said)
      EXPECT_NE(text_of("err.txt").find(part), std::string::npos) << part << ": " << text_of("err.txt");
  }
  ::close(nobody);
  EXPECT_FALSE(fs::exists(folder_ / "r.json"));
  EXPECT_EQ(shell(std::string("'") + MLAB_COMMAND + "' replay --headless again.mcap > out.txt"), 0)
      << "what was recorded up to there is a run";
}

// A pipe without a reader is waited for; who wants an end does not wait with it.
TEST_P(Interrupted, ABatchEndsWhoseTableNobodyReads) {
  ASSERT_EQ(::mkfifo((folder_ / "t.csv").c_str(), 0600), 0);
  const int nobody = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  const LongRun run(folder_, nobody, {"batch", "short.mdl", "--runs", "2", "--table", "t.csv", "--quiet"});
  run.wait_until_it_listens();
  std::this_thread::sleep_for(std::chrono::seconds(1));  // the runs are done by then
  const auto asked = Clock::now();
  run.signal(GetParam());
  EXPECT_EQ(run.wait(), 1);
  EXPECT_LT(Clock::now() - asked, std::chrono::seconds(10));
  EXPECT_NE(text_of("err.txt").find("the table t.csv could not be written: nobody reads it"),
            std::string::npos)
      << text_of("err.txt");
  // What was done is not lost.
  EXPECT_EQ(shell("cat t.csv > got.csv & '" MLAB_COMMAND
                  "' batch short.mdl --runs 2 --table t.csv --quiet --resume > out.txt; wait"),
            0)
      << text_of("err.txt");
  EXPECT_NE(text_of("got.csv"), "");
  ::close(nobody);
}

INSTANTIATE_TEST_SUITE_P(Signals, Interrupted, testing::Values(SIGINT, SIGTERM));

}  // namespace
}  // namespace mlab
