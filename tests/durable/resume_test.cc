// A run is gone on with where a killed console left it: real consoles, killed under the hands of somebody who
// steers.

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "mlab/base/random.h"
#include "operator.h"
#include "server.h"

namespace mlab::durable {
namespace {

namespace fs = std::filesystem;
using console::Control;
using console::Status;

constexpr const char* kLongWay =
    "OVERLAY \"far.odl\"\nUNIT <pair> ROBOT ROBOT\nCOMMAND LIST:\n"
    "0. UNIT pair START 100 100 0 40\n1. UNIT pair MOVETO PP-Near\n2. UNIT pair MOVETO PP-Far\n";
constexpr const char* kWideMap =
    "MISSION-AREA 100000 1000\nCONTROL MEASURES:\nPP Near 300 100\nPP Far 99000 100\n";

std::uint64_t number_from(const char* name, std::uint64_t usual) {
  const char* text = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): a test program has one thread
  return text == nullptr ? usual : std::strtoull(text, nullptr, 10);
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class Resumed : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              fmt::format("mlab_resumed_{}_{}", ::getpid(),
                          testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder_);
    for (const char* name : {"project", "state"}) fs::create_directories(folder_ / name);
    write("far.mdl", kLongWay);
    write("far.odl", kWideMap);
  }
  void TearDown() override {
    if (!HasFailure()) fs::remove_all(folder_);
  }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / "project" / name) << text;
  }
  Server::Setup setup(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "run");
    return {std::move(arguments),
            (folder_ / "project").string(),
            {{"XDG_STATE_HOME", (folder_ / "state").string()}}};
  }
  Server::Setup resume() const { return setup({"--resume"}); }
  std::vector<fs::path> files(const std::string& extension) const {
    std::vector<fs::path> out;
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / "state")) {
      if (entry.path().extension() == extension) out.push_back(entry.path());
    }
    std::ranges::sort(out);
    return out;
  }
  // What `mlab replay` says of a recording; it ends with 0 where the run was computed again as it was
  // recorded.
  int replay(const fs::path& recording, const std::string& report = "") const {
    std::string command = fmt::format("{} replay --headless --quiet '{}' >'{}' 2>&1", MLAB_COMMAND,
                                      recording.string(), (folder_ / "replay.txt").string());
    if (!report.empty()) command += " --report '" + report + "'";
    const int status = std::system(command.c_str());  // NOLINT(concurrency-mt-unsafe,cert-env33-c)
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  fs::path folder_;
};

bool is_paused(const Operator& anna) {
  return anna.status().mode() == Status::PAUSED;
}

// All of a report that does not depend on when and how fast it ran, or on people who looked on.
std::string outcome_of(const fs::path& report) {
  std::string text = text_of(report);
  const std::size_t end = text.find("\"performance\"");
  return end == std::string::npos ? text : text.substr(0, end);
}

TEST_F(Resumed, ARunEndsAsIfNobodyHadKilledIt) {
  write("short.mdl",
        "OVERLAY \"far.odl\"\nUNIT <pair> ROBOT ROBOT\nCOMMAND LIST:\n"
        "0. UNIT pair START 100 100 0 40\n1. UNIT pair MOVETO PP-Near\n");
  const std::vector<std::string> alike = {"--seed", "5", "--start-time", "2026-01-01 12:00"};
  const auto with = [&](std::vector<std::string> words) {
    words.insert(words.end(), alike.begin(), alike.end());
    return setup(std::move(words));
  };
  {
    Server server(with({"short.mdl", "--speed", "max", "--report", "whole.json"}));
    ASSERT_NE(server.port(), 0) << server.printed();
    Operator anna(server);
    ASSERT_TRUE(anna.wait([&] { return anna.status().mode() == Status::READY; }));
    ASSERT_TRUE(anna.control(Control::EXECUTE));
    ASSERT_TRUE(anna.wait([&] { return anna.status().mode() == Status::ENDED; }));
    EXPECT_EQ(server.end(), 0) << server.printed();
  }
  EXPECT_TRUE(files(".journal").empty()) << "there is nothing to go on with";
  {
    Server server(with({"short.mdl", "--speed", "20"}));
    ASSERT_NE(server.port(), 0) << server.printed();
    Operator anna(server);
    ASSERT_TRUE(anna.wait([&] { return anna.status().mode() == Status::READY; }));
    ASSERT_TRUE(anna.control(Control::EXECUTE));
    ASSERT_TRUE(anna.wait([&] { return anna.status().time() > 15.0; }));
    server.kill();
  }
  {
    Server server(setup({"--resume", "--report", "resumed.json"}));
    ASSERT_NE(server.port(), 0) << server.printed();
    EXPECT_TRUE(server.prints("short.mdl goes on as it stood at")) << server.printed();
    Operator anna(server);
    ASSERT_TRUE(anna.wait([&] { return is_paused(anna); }));
    EXPECT_GT(anna.status().time(), 10.0);
    EXPECT_TRUE(anna.wait([&] { return anna.has_log("the run goes on as it stood at"); }));
    EXPECT_TRUE(anna.has_log("Anna: execute"));
    console::ToServer fast;
    fast.mutable_set_speed()->set_speed(0.0);
    ASSERT_TRUE(anna.ask(fast));
    ASSERT_TRUE(anna.control(Control::RESUME));
    ASSERT_TRUE(anna.wait([&] { return anna.status().mode() == Status::ENDED; }));
    EXPECT_EQ(server.end(), 0) << server.printed();
  }
  EXPECT_EQ(outcome_of(folder_ / "project/resumed.json"), outcome_of(folder_ / "project/whole.json"));
  EXPECT_TRUE(files(".journal").empty());
  const std::vector<fs::path> recordings = files(".mcap");
  ASSERT_EQ(recordings.size(), 2U) << "the killed run's was gone on with";
  for (const fs::path& one : recordings) EXPECT_EQ(replay(one), 0) << text_of(folder_ / "replay.txt");
}

TEST_F(Resumed, ThereIsNothingToGoOnWithWhereNothingWasStarted) {
  {
    Server server(setup({"far.mdl"}));
    ASSERT_NE(server.port(), 0) << server.printed();
    Operator anna(server);
    server.kill();
  }
  Server server(resume());
  EXPECT_EQ(server.port(), 0);
  EXPECT_TRUE(server.prints("that did not end")) << server.printed();
}

TEST_F(Resumed, PeopleSpeedAndBreakpointsAreAsTheyWereAndAnEditIsFollowed) {
  {
    Server server(setup({"far.mdl", "--speed", "20"}));
    ASSERT_NE(server.port(), 0) << server.printed();
    Operator anna(server);
    ASSERT_TRUE(anna.wait([&] { return anna.status().mode() == Status::READY; }));
    ASSERT_TRUE(anna.control(Control::EXECUTE));
    console::ToServer speed;
    speed.mutable_set_speed()->set_speed(7.0);
    ASSERT_TRUE(anna.ask(speed));
    console::ToServer stop;
    console::Breakpoint& breakpoint = *stop.mutable_set_breakpoint()->mutable_breakpoint();
    breakpoint.mutable_transition()->set_sequence("no_such");
    const auto set = anna.ask(stop);
    ASSERT_TRUE(set && set->ok()) << set->error();
    server.kill();
  }
  write("far.odl", std::string(kWideMap) + "PP Extra 500 500\n");
  Server server(resume());
  ASSERT_NE(server.port(), 0) << server.printed();
  Operator anna(server);
  ASSERT_TRUE(anna.wait([&] { return is_paused(anna); }));
  EXPECT_EQ(anna.id(), 1U) << "she is who she was";
  EXPECT_EQ(anna.clients().operator_(), 1U);
  EXPECT_DOUBLE_EQ(anna.status().speed(), 7.0);
  EXPECT_EQ(anna.breakpoints().breakpoints_size(), 1);
  EXPECT_TRUE(anna.wait([&] { return anna.has_log("the mission was changed meanwhile"); }));
  const auto typed = anna.type("UNIT pair MOVETO PP-Extra");
  ASSERT_TRUE(typed);
  EXPECT_EQ(typed->error(), "");
}

// ---- kills

/// Steers until it is time to kill, and knows what was acknowledged as saved.
class Helmsman {
 public:
  explicit Helmsman(std::uint64_t seed) : random_(seed) {}

  /// @return  what is not as it was acknowledged; empty: all is
  std::string look(Operator& anna) {
    for (const std::string& line : saved_) {
      if (!anna.has_log(line)) return fmt::format("`{}` is not in the log", line);
    }
    if (anna.status().time() + 1e-6 < saved_time_)
      return fmt::format("it stands at {} s, though {} s were acknowledged", anna.status().time(),
                         saved_time_);
    return "";
  }
  /// Does something for as long as it pleases.
  void steer(Operator& anna) {
    const int orders = static_cast<int>(random_.below(6));
    waiting_.clear();
    for (int i = 0; i < orders; ++i) {
      anna.listen(random_.uniform() * 0.08);
      order(anna);
    }
    anna.listen(random_.uniform() * 0.25);
    for (const Order& one : waiting_) take(anna, one);
  }
  std::size_t saved() const { return saved_.size(); }
  std::size_t not_saved() const { return not_saved_; }

 private:
  struct Order {
    std::uint32_t request = 0;
    std::string line;   // as the log has it; empty: no matter
    double time = 0.0;  // of the run, as far as he had been told
  };
  void take(const Operator& anna, const Order& one) {
    const auto found = anna.replies().find(one.request);
    if (found == anna.replies().end() || !found->second.ok()) return;
    if (!found->second.not_saved().empty()) {
      ++not_saved_;
      return;
    }
    if (!one.line.empty()) saved_.push_back(one.line);
    saved_time_ = std::max(saved_time_, one.time);
  }
  void order(Operator& anna) {
    console::ToServer message;
    std::string line;
    switch (random_.below(6)) {
      case 0:
        message.mutable_control()->set_action(Control::PAUSE);
        break;
      case 1:
      case 2:
        message.mutable_control()->set_action(Control::EXECUTE);
        break;
      case 3:
        line = fmt::format("OBSTACLE {} 900 1", 1000 + ++number_ * 5);
        break;
      case 4:
        message.mutable_set_speed()->set_speed(5.0 + static_cast<double>(random_.below(40)));
        break;
      default:
        line = fmt::format("ROBOT 2 MOVETO {} {}", 1000 + ++number_, 100 + random_.below(300));
    }
    if (!line.empty()) message.mutable_typed()->set_line(line);
    waiting_.push_back({anna.send(message), line, anna.status().time()});
  }

  base::Random random_;
  std::uint64_t number_ = 0;
  std::vector<Order> waiting_;
  std::vector<std::string> saved_;
  double saved_time_ = 0.0;
  std::size_t not_saved_ = 0;
};

class Kills : public Resumed {
 protected:
  // Kills consoles under somebody's hands, and looks what the next one has.
  // @param most_bytes  of a file, in some of the consoles: as on a full disk; 0: there is room
  void try_kills(std::uint64_t most_bytes) {
    const std::uint64_t kills = number_from("MLAB_KILLS", 10);
    const std::uint64_t seed = number_from("MLAB_KILL_SEED", 1);
    fmt::print("{} kills, MLAB_KILL_SEED={}\n", kills, seed);
    Helmsman helmsman(seed);
    base::Random random(seed + 1);
    double slowest = 0.0;
    for (std::uint64_t kill = 0; kill <= kills; ++kill) {
      Server::Setup next = kill == 0 ? setup({"far.mdl", "--speed", "20"}) : resume();
      if (most_bytes != 0 && kill != 0 && random.below(2) == 0) {
        next.before = [size = 2000 + random.below(most_bytes)] {
          const rlimit small{size, size};
          return std::signal(SIGXFSZ, SIG_IGN) != SIG_ERR && ::setrlimit(RLIMIT_FSIZE, &small) == 0;
        };
      }
      Server server(next);
      ASSERT_NE(server.port(), 0) << "kill " << kill << " of seed " << seed << "\n" << server.printed();
      Operator anna(server);
      const auto began = std::chrono::steady_clock::now();
      const auto wanted = kill == 0 ? Status::READY : Status::PAUSED;
      ASSERT_TRUE(anna.wait([&] { return anna.status().mode() == wanted; })) << server.printed();
      ASSERT_TRUE(kill == 0 || anna.wait([&] { return anna.has_log("the run goes on as it stood"); }));
      slowest =
          std::max(slowest, std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count());
      ASSERT_EQ(helmsman.look(anna), "") << "after kill " << kill << " of seed " << seed;
      const auto executed = anna.control(Control::EXECUTE);
      ASSERT_TRUE(executed && executed->ok()) << executed->error();
      ASSERT_TRUE(kill != 0 || executed->not_saved().empty()) << executed->not_saved();
      helmsman.steer(anna);
      server.kill();
      const std::vector<fs::path> recordings = files(".mcap");
      ASSERT_FALSE(recordings.empty());
      for (const fs::path& one : recordings)
        ASSERT_EQ(replay(one), 0) << one << " after kill " << kill << "\n" << text_of(folder_ / "replay.txt");
    }
    fmt::print("{} orders were acknowledged as saved, {} as not saved; at most {:.2f} s until all was back\n",
               helmsman.saved(), helmsman.not_saved(), slowest);
    EXPECT_GT(helmsman.saved(), 0U);
  }
};

TEST_F(Kills, NothingAcknowledgedIsLost) {
  try_kills(0);
}

TEST_F(Kills, NothingAcknowledgedAsSavedIsLostOnAFullDisk) {
  try_kills(300'000);
}

}  // namespace
}  // namespace mlab::durable
