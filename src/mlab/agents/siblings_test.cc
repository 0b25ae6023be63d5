#include "mlab/agents/siblings.h"

#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/agents/agent_process.h"

namespace mlab::agents {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

const std::string kOurs = "0123456789abcdef";

/// What agents keep, of those that are played by the test.
class SiblingsTest : public ::testing::Test {
 protected:
  SiblingsTest() { fs::create_directories(folder_); }
  ~SiblingsTest() override { fs::remove_all(folder_); }

  std::string stop_of(const std::string& name) const { return folder_ / ("alpha@" + name + ".stop"); }
  fs::path seen_of(const std::string& name) const { return folder_ / ("alpha@" + name + ".seen"); }
  void note(const std::string& name, const std::string& company = kOurs) const {
    std::ofstream(seen_of(name)) << "1795977437 " << company << "\n";
  }
  void keep(const std::string& name, const StopState& state) const {
    EXPECT_EQ(StopFile(stop_of(name)).write(state), std::nullopt);
  }
  static std::string names(const std::vector<Sibling>& all) {
    std::string out;
    for (const Sibling& one : all) out += one.name + (one.is_there ? " " : "? ");
    return out;
  }

  const fs::path folder_ = fs::temp_directory_path() / ("mlab-siblings-" + std::to_string(::getpid()));
};

TEST_F(SiblingsTest, AreThoseOfOneFleetAndCompanyThatHaveNotEnded) {
  for (const char* name : {"north", "south", "west"}) note(name);
  note("east", "fedcba9876543210");
  std::ofstream(folder_ / "beta@other.seen") << "1 " << kOurs;
  std::ofstream(folder_ / "alpha@no name.seen") << "1 " << kOurs;
  Siblings siblings(stop_of("north"), kOurs);
  EXPECT_EQ(names(siblings.look()), "south west ");
  fs::remove(seen_of("west"));
  EXPECT_EQ(names(siblings.look()), "south ");
  note("west");
  EXPECT_EQ(names(siblings.look()), "south west ");
  EXPECT_EQ(names(siblings.all()), "south west ");
}

TEST_F(SiblingsTest, TellWhatTheyKeepOfTheStop) {
  note("south");
  Siblings siblings(stop_of("north"), kOurs);
  EXPECT_FALSE(siblings.look().at(0).stop.is_engaged());
  StopState state;
  for (int i = 0; i < 20; ++i) {  // also what is written just after a look
    state = pulled(state, "ada");
    keep("south", state);
    EXPECT_EQ(siblings.look().at(0).stop.standing.size(), state.standing.size());
  }
  state = released(state, "ben");
  keep("south", state);
  EXPECT_EQ(siblings.look().at(0).stop.by(), "ben");
  std::ofstream(stop_of("south")) << "garbage";
  EXPECT_EQ(siblings.look().at(0).stop.by(), "ben") << "nothing is made of that";
  fs::remove(stop_of("south"));
  EXPECT_EQ(siblings.look().at(0).stop.number, 0U);
}

TEST_F(SiblingsTest, ThatNoteNothingAnyMoreAreMissed) {
  note("south");
  fs::last_write_time(seen_of("south"), fs::file_time_type::clock::now() - 60s);
  Siblings siblings(stop_of("north"), kOurs);
  EXPECT_EQ(names(siblings.look()), "south? ");
  const auto silent = Clock::now() - siblings.all().at(0).heard;
  EXPECT_GE(silent, 60s);
  EXPECT_LT(silent, 120s);
  note("south");
  const auto last = Clock::now() + 30s;
  while (!siblings.look().at(0).is_there && Clock::now() < last) std::this_thread::sleep_for(50ms);
  EXPECT_TRUE(siblings.all().at(0).is_there);
}

TEST_F(SiblingsTest, AreSeenByWhoIsNone) {
  for (const char* name : {"north", "south"}) note(name);
  std::ofstream(folder_ / "beta@other.seen") << "1 " << kOurs;
  EXPECT_EQ(names(Siblings(folder_, "alpha", kOurs).look()), "north south ");
  EXPECT_TRUE(Siblings(fs::path(), "alpha", kOurs).look().empty());
}

TEST_F(SiblingsTest, AreNoneOfWhoKeepsNothing) {
  note("south");
  EXPECT_TRUE(Siblings("", kOurs).look().empty());
  EXPECT_TRUE(Siblings(folder_ / "north", kOurs).look().empty());
}

TEST_F(SiblingsTest, KeepCompanyOnOneInterfaceAndUnderOneAuthority) {
  const dds::Network open{.fleet = "alpha", .interface_name = {}, .peers = {}};
  EXPECT_EQ(company_of(open), company_of(open));
  dds::Network other = open;
  other.interface_name = "lo";
  EXPECT_EQ(company_of(open), company_of(other)) << "whatever it is called";
  other.interface_name = "nosuch0";
  EXPECT_NE(company_of(open), company_of(other));
  dds::Network secured = open;
  secured.security = dds::Security{.authority = folder_ / "ours",
                                   .certificate = {},
                                   .key = {},
                                   .governance = {},
                                   .permissions = {},
                                   .withdrawn = {}};
  EXPECT_NE(company_of(open), company_of(secured)) << "also where the authority can't be read";
  std::ofstream(folder_ / "ours") << "ours";
  std::ofstream(folder_ / "theirs") << "theirs";
  dds::Network strange = secured;
  strange.security->authority = folder_ / "theirs";
  EXPECT_NE(company_of(strange), company_of(secured));
  strange.security->authority = folder_ / "ours";
  EXPECT_EQ(company_of(strange), company_of(secured));
}

/// An agent on a thread of this process.
class Agent {
 public:
  explicit Agent(AgentSettings settings)
      : settings_(std::move(settings)), thread_([this](const std::stop_token& stop) {
          EXPECT_EQ(serve_as_agent(settings_, stop), std::nullopt);
        }) {}
  bool tells(const std::string& words) const {
    for (const auto last = Clock::now() + 30s; Clock::now() < last;) {
      for (const robot::LogLine& line : settings_.log->lines()) {
        if (line.text.find(words) != std::string::npos) return true;
      }
      std::this_thread::sleep_for(20ms);
    }
    return false;
  }

 private:
  AgentSettings settings_;
  std::jthread thread_;
};

bool comes_true(const std::function<bool()>& condition) {
  const auto last = Clock::now() + 30s;
  while (!condition() && Clock::now() < last) std::this_thread::sleep_for(20ms);
  return condition();
}

TEST_F(SiblingsTest, HearOfAStopAndItsReleaseFromEachOther) {
  AgentSettings settings;
  settings.network = {.fleet = "siblings-" + std::to_string(::getpid()), .interface_name = {}, .peers = {}};
  settings.name = "north";
  settings.stop_file = stop_of("north");
  settings.log = std::make_shared<AgentLog>(nullptr);
  const Agent north(settings);
  const std::string company = company_of(settings.network);
  note("south", company);
  note("gone", company);
  fs::last_write_time(seen_of("gone"), fs::file_time_type::clock::now() - 60s);
  keep("gone", pulled({}, "whoever stopped those of then"));
  const StopState stopped = pulled({}, "ada");
  keep("south", stopped);
  EXPECT_TRUE(north.tells("EMERGENCY STOP by ada: all robots here stand"));
  EXPECT_EQ(StopFile(stop_of("north")).read().standing.size(), 1U)
      << "nobody is there who says the other one";
  fs::remove(stop_of("gone"));
  fs::remove(seen_of("gone"));

  note("west", company);  // which hears of it as late as of the stop
  keep("west", stopped);
  keep("south", released(stopped, "ben"));
  EXPECT_TRUE(north.tells("the emergency stop was released by ben"));
  std::this_thread::sleep_for(1200ms);
  EXPECT_FALSE(StopFile(stop_of("north")).read().released.empty()) << "west has to learn of it";
  keep("west", released(stopped, "ben"));
  EXPECT_TRUE(comes_true([&] { return !StopFile(stop_of("north")).is_there(); }));
  keep("west", stopped);
  EXPECT_TRUE(comes_true([&] { return StopFile(stop_of("north")).is_there(); })) << "it is told again";
  EXPECT_FALSE(StopFile(stop_of("north")).read().is_engaged());
}

}  // namespace
}  // namespace mlab::agents
