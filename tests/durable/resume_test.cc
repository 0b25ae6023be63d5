// A run is gone on with where a killed console left it: real consoles, killed under the hands of somebody who
// steers.

#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
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
#include "small_disk.h"

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

/// A machine that carries robots: another process here. Ends with this.
class Agent {
 public:
  Agent(const std::string& fleet, const fs::path& state) : process_(::fork()) {
    if (process_ != 0) return;
    ::setenv("XDG_STATE_HOME", state.c_str(), 1);  // NOLINT(concurrency-mt-unsafe)
    ::execl(MLAB_COMMAND, "mlab", "agent", "--fleet", fleet.c_str(), "--name", "north", nullptr);
    ::_exit(127);
  }
  Agent(const Agent&) = delete;
  Agent& operator=(const Agent&) = delete;
  ~Agent() {
    if (process_ < 0) return;
    ::kill(process_, SIGTERM);
    ::waitpid(process_, nullptr, 0);
  }

 private:
  pid_t process_;
};

bool is_paused(const Operator& anna) {
  return anna.status().mode() == Status::PAUSED;
}

// The mission that is open, for a second.
void start(const Server& server) {
  Operator anna(server);
  ASSERT_TRUE(anna.wait([&] { return anna.status().mode() == Status::READY; }));
  ASSERT_TRUE(anna.control(Control::EXECUTE));
  ASSERT_TRUE(anna.wait([&] { return anna.status().time() > 1.0; }));
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
    Server server(with({"short.mdl", "--speed", "10"}));
    ASSERT_NE(server.port(), 0) << server.printed();
    Operator anna(server);
    ASSERT_TRUE(anna.wait([&] { return anna.status().mode() == Status::READY; }));
    ASSERT_TRUE(anna.control(Control::EXECUTE));
    ASSERT_TRUE(anna.wait([&] { return anna.status().time() > 25.0; }));
    server.kill();
  }
  {
    Server server(setup({"short.mdl"}));
    ASSERT_NE(server.port(), 0) << server.printed();
    EXPECT_TRUE(server.prints("A run of short.mdl that did not end stands at")) << server.printed();
    EXPECT_EQ(server.end(), 0) << server.printed();
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

TEST_F(Resumed, ARunInRealTimeIsNotSaidToGoOn) {
  const std::string fleet = fmt::format("resumed-{}", ::getpid());
  const Agent agent(fleet, folder_ / "state");
  {
    Server server(setup({"far.mdl", "--robots", "fleet", "--fleet", fleet, "--real-time"}));
    ASSERT_NE(server.port(), 0) << server.printed();
    Operator anna(server);
    ASSERT_TRUE(anna.wait([&] { return anna.status().mode() == Status::READY; }));
    ASSERT_TRUE(anna.control(Control::EXECUTE));
    ASSERT_TRUE(anna.wait([&] { return anna.status().time() > 1.0; }));
    server.kill();
  }
  const std::string truth =
      "its robots were elsewhere, in real time: what they would do next is not known here";
  {
    Server server(setup({"far.mdl"}));
    ASSERT_NE(server.port(), 0) << server.printed();
    EXPECT_TRUE(server.prints("and does not go on: " + truth)) << server.printed();
    EXPECT_EQ(server.end(), 0) << server.printed();
  }
  {
    Server server(setup({}));
    ASSERT_NE(server.port(), 0) << server.printed();
    Operator anna(server);
    ASSERT_TRUE(anna.wait([&] { return anna.journal().unfinished_size() == 1; }));
    EXPECT_EQ(anna.journal().unfinished(0).why_not(), truth);
    EXPECT_EQ(server.end(), 0) << server.printed();
  }
  Server server(resume());
  ASSERT_NE(server.port(), 0) << server.printed();
  EXPECT_TRUE(server.prints("and that run does not go on: " + truth)) << server.printed();
  Operator anna(server);
  EXPECT_TRUE(anna.wait([&] { return anna.status().mode() == Status::READY; }));
  EXPECT_TRUE(anna.has_log("Anna: execute"));
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

TEST_F(Resumed, ARunThatAnotherConsoleHasIsSaidToBeHeld) {
  Server server(setup({"far.mdl"}));
  ASSERT_NE(server.port(), 0) << server.printed();
  start(server);
  for (const Server::Setup& words : {resume(), setup({"--resume", "far.mdl"})}) {
    Server beside(words);
    EXPECT_EQ(beside.port(), 0);
    EXPECT_TRUE(beside.prints("that did not end, but another process has one of this project"))
        << beside.printed();
  }
}

TEST_F(Resumed, ARunWhoseMissionIsGoneIsNotSaidToGoOn) {
  {
    Server server(setup({"far.mdl"}));
    ASSERT_NE(server.port(), 0) << server.printed();
    start(server);
    server.kill();
  }
  fs::rename(folder_ / "project" / "far.mdl", folder_ / "far.mdl");
  {
    Server server(resume());
    ASSERT_NE(server.port(), 0) << server.printed();
    EXPECT_TRUE(server.prints("can't go on, because `far.mdl` is not there")) << server.printed();
    EXPECT_TRUE(server.prints("without a mission")) << server.printed();
    EXPECT_EQ(server.printed().find("goes on as it stood"), std::string::npos) << server.printed();
    Operator anna(server);
    ASSERT_TRUE(anna.wait([&] { return anna.journal().unfinished_size() == 1; }));
    EXPECT_EQ(anna.journal().unfinished(0).why_not(), "`far.mdl` is not there");
    EXPECT_EQ(server.end(), 0) << server.printed();
  }
  fs::rename(folder_ / "far.mdl", folder_ / "project" / "far.mdl");
  Server server(resume());
  ASSERT_NE(server.port(), 0) << server.printed();
  EXPECT_TRUE(server.prints("far.mdl goes on as it stood at about ")) << server.printed();
  EXPECT_TRUE(server.prints("Nothing moves before Resume")) << server.printed();
  Operator anna(server);
  EXPECT_TRUE(anna.wait([&] { return is_paused(anna); }));
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
    breakpoint.set_sentence("robot 1 nearer than 2 m to PP-Nowhere");
    ASSERT_TRUE(anna.ask(stop));
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
  ASSERT_EQ(anna.breakpoints().breakpoints_size(), 2);
  EXPECT_EQ(anna.breakpoints().breakpoints(1).sentence(), "robot 1 nearer than 2 m to PP-Nowhere");
  EXPECT_TRUE(anna.wait(
      [&] { return anna.breakpoints().breakpoints(1).error() == "the map has no place `PP-Nowhere`"; }));
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
  /// @param meanwhile  is done before each of the orders
  void steer(Operator& anna, const std::function<void()>& meanwhile) {
    const int orders = static_cast<int>(random_.below(6));
    waiting_.clear();
    for (int i = 0; i < orders; ++i) {
      anna.listen(random_.uniform() * 0.08);
      if (meanwhile) meanwhile();
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

/// What goes wrong besides the kills; what is empty does not.
struct Trouble {
  std::function<void(Server::Setup& next)> before_start = {};  ///< of each console but the first
  std::function<void()> meanwhile = {};                        ///< before each order
};

class Kills : public Resumed {
 protected:
  // Kills consoles under somebody's hands, and looks what the next one has.
  void try_kills(const Trouble& trouble = {}) {
    const std::uint64_t kills = number_from("MLAB_KILLS", 10);
    fmt::print("{} kills, MLAB_KILL_SEED={}\n", kills, seed_);
    Helmsman helmsman(seed_);
    for (std::uint64_t kill = 0; kill <= kills; ++kill) {
      Server::Setup next = kill == 0 ? setup({"far.mdl", "--speed", "20"}) : resume();
      if (kill != 0 && trouble.before_start) trouble.before_start(next);
      try_kill(kill, next, helmsman, trouble);
      if (HasFatalFailure()) return;
    }
    fmt::print("{} orders were acknowledged as saved, {} as not saved; at most {:.2f} s until all was back\n",
               helmsman.saved(), helmsman.not_saved(), slowest_);
    EXPECT_GT(helmsman.saved(), 0U);
  }

  const std::uint64_t seed_ = number_from("MLAB_KILL_SEED", 1);
  base::Random random_{seed_ + 1};

 private:
  void try_kill(std::uint64_t kill, const Server::Setup& next, Helmsman& helmsman, const Trouble& trouble) {
    const std::string which = fmt::format("kill {} of seed {}", kill, seed_);
    Server server(next);
    ASSERT_NE(server.port(), 0) << which << "\n" << server.printed();
    Operator anna(server);
    const auto began = std::chrono::steady_clock::now();
    const auto wanted = kill == 0 ? Status::READY : Status::PAUSED;
    ASSERT_TRUE(anna.wait([&] { return anna.status().mode() == wanted; })) << which << server.printed();
    ASSERT_TRUE(kill == 0 || anna.wait([&] { return anna.has_log("the run goes on as it stood"); }));
    slowest_ =
        std::max(slowest_, std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count());
    ASSERT_EQ(helmsman.look(anna), "") << "after " << which;
    const auto executed = anna.control(Control::EXECUTE);
    ASSERT_TRUE(executed && executed->ok()) << executed->error();
    ASSERT_TRUE(kill != 0 || executed->not_saved().empty()) << executed->not_saved();
    helmsman.steer(anna, kill == 0 ? std::function<void()>() : trouble.meanwhile);
    server.kill();
    const std::vector<fs::path> recordings = files(".mcap");
    ASSERT_FALSE(recordings.empty());
    for (const fs::path& one : recordings)
      ASSERT_EQ(replay(one), 0) << one << " after " << which << "\n" << text_of(folder_ / "replay.txt");
  }

  double slowest_ = 0.0;
};

TEST_F(Kills, NothingAcknowledgedIsLost) {
  try_kills();
}

TEST_F(Kills, NothingAcknowledgedAsSavedIsLostWhereFilesMustNotGrow) {
  try_kills({.before_start = [this](Server::Setup& next) {
    if (random_.below(2) != 0) return;
    next.before = [size = 2000 + random_.below(300'000)] {
      const rlimit small{size, size};
      return std::signal(SIGXFSZ, SIG_IGN) != SIG_ERR && ::setrlimit(RLIMIT_FSIZE, &small) == 0;
    };
  }});
}

TEST_F(Kills, NothingAcknowledgedAsSavedIsLostOnAFullDisk) {
  const std::string state = (folder_ / "state").string();
  if (!get_small_disk(state, 65'536)) GTEST_SKIP() << "no file system can be mounted here";
  const CrowdedDisk disk(state);
  // Of three times full to the brim, nearly full, or with room for all.
  const auto crowd = [&] {
    const std::uint64_t kind = random_.below(3);
    ASSERT_TRUE(kind == 0   ? disk.leave(0)
                : kind == 1 ? disk.leave(random_.below(200'000))
                            : disk.make_room());
  };
  try_kills({.before_start = [&](Server::Setup&) { crowd(); },
             .meanwhile =
                 [&] {
                   if (random_.below(3) == 0) crowd();
                 }});
  if (HasFailure()) {  // the disk goes with this process
    fs::copy(state, folder_ / "left", fs::copy_options::recursive);
    fs::remove(folder_ / "left/of_others");
  }
  ::umount2(state.c_str(), MNT_DETACH);
}

}  // namespace
}  // namespace mlab::durable
