// What was acknowledged is never lost: real servers, killed under the hands of somebody who edits; and what
// is said where nothing can be kept.

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "author.h"
#include "server.h"
#include "small_disk.h"
#include "socket.h"

#include "mlab/console.pb.h"

namespace mlab::durable {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMission =
    "MISSION NAME \"m\"\nOVERLAY m.odl\nUNIT <u> ROBOT ROBOT\nCOMMAND LIST:\n 0. UNIT u START AA-AA1\n";
constexpr const char* kOverlay = "MISSION-AREA 500 400\nCONTROL MEASURES:\nAA AA1 50 50\n";
constexpr const char* kConfiguration = "assemblage Rest() -> Vector {\n  Noise(persistence = 6 s)\n}\n";

// A number from the environment: `MLAB_KILLS=500` for the long trial, `MLAB_KILL_SEED` for another one.
std::uint64_t setting(const char* name, std::uint64_t usual) {
  const char* text = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): a test program has one thread
  return text == nullptr ? usual : std::strtoull(text, nullptr, 10);
}

class Durable : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              fmt::format("mlab_durable_{}_{}", ::getpid(),
                          testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder_);
    for (const char* name : {"project", "state"}) fs::create_directories(folder_ / name);
    write("m.mdl", kMission);
    write("m.odl", kOverlay);
    write("c.cdl", kConfiguration);
    write("d.cdl", kConfiguration);
  }
  void TearDown() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / "project" / name) << text;
  }
  Server::Setup setup(std::vector<std::string> arguments) const {
    return {std::move(arguments),
            (folder_ / "project").string(),
            {{"XDG_STATE_HOME", (folder_ / "state").string()}}};
  }
  // Kills servers under the hands of an author, and looks what the next one has.
  void try_kills(const Speech& speech) const {
    const std::uint64_t kills = setting("MLAB_KILLS", 24);
    const std::uint64_t seed = setting("MLAB_KILL_SEED", 1);
    fmt::print("{} kills, MLAB_KILL_SEED={}\n", kills, seed);
    Author author(speech, seed);
    for (std::uint64_t kill = 0; kill <= kills; ++kill) {
      Server server(setup(speech.arguments()));
      ASSERT_NE(server.port(), 0) << server.printed();
      const std::string lost = author.work_and_kill(server);
      ASSERT_EQ(lost, "") << "after kill " << kill << " of seed " << seed;
    }
    fmt::print("{} edits were acknowledged\n", author.acknowledged());
    EXPECT_GT(author.acknowledged(), kills) << "a kill before the first edit is no trial";
  }

  fs::path folder_;
};

TEST_F(Durable, NoAcknowledgedEditIsLostWhenTheConsoleIsKilled) {
  try_kills(*console_speech());
}

TEST_F(Durable, NoAcknowledgedEditIsLostWhenTheDesignerIsKilled) {
  try_kills(*designer_speech());
}

// A person at the console, who types.
class Typist {
 public:
  explicit Typist(const Server& server)
      : speech_(console_speech()), socket_(server.port(), "/session?token=" + server.token()) {
    for (const std::string& message : speech_->greeting()) socket_.send(message);
    wait([&] { return revision_ > 0 && has_state_; });
  }
  // Types into the overlay, and waits for the answer and what is told after it.
  void type(const std::string& text) {
    is_answered_ = false;
    const std::uint64_t before = revision_;
    socket_.send(speech_->insert(++request_, "m.odl", revision_, text, "type"));
    EXPECT_TRUE(wait([&] { return is_answered_ && revision_ > before && has_state_; }));
    EXPECT_EQ(error_, "");
  }
  std::string save() {
    is_answered_ = false;
    socket_.send(speech_->save(++request_, "m.odl"));
    wait([&] { return is_answered_; });
    return error_;
  }
  // Why what is not saved would be lost, as the page is told.
  const std::string& not_kept() const { return not_kept_; }
  // Of the overlay.
  const std::string& text() const { return text_; }
  bool wait(const std::function<bool()>& is_true) {
    while (!is_true()) {
      const auto message = socket_.receive(60.0);
      if (!message) return false;
      const Speech::HeardAnswer heard = speech_->hear(*message);
      is_answered_ = is_answered_ || (heard.request != 0 && heard.request == request_);
      if (heard.request != 0) error_ = heard.error;
      if (heard.texts.contains("m.odl")) {
        std::tie(text_, revision_) = heard.texts.at("m.odl");
        has_state_ = false;  // it follows
      }
      console::ToBrowser in;
      if (!in.ParseFromString(*message) || !in.has_edits()) continue;
      has_state_ = true;
      not_kept_ = in.edits().not_kept();
    }
    return true;
  }

 private:
  std::unique_ptr<Speech> speech_;
  Socket socket_;
  std::uint32_t request_ = 0;
  std::string text_;
  std::uint64_t revision_ = 0;
  bool is_answered_ = false;
  bool has_state_ = false;
  std::string error_;
  std::string not_kept_;
};

TEST_F(Durable, AFullDiskIsToldAtOnceAndWhatIsLostAtTheEnd) {
  Server::Setup small = setup({"run", "m.mdl"});
  small.before = [where = (folder_ / "state").string()] { return get_small_disk(where, 32); };
  Server server(small);
  if (server.port() == 0 && server.end() == 97) GTEST_SKIP() << "no file system can be mounted here";
  ASSERT_NE(server.port(), 0) << server.printed();
  EXPECT_TRUE(server.prints("what is not saved is kept.")) << server.printed();
  Typist typist(server);
  typist.type("-- small\n");
  EXPECT_EQ(typist.not_kept(), "");
  typist.type("-- " + std::string(60'000, 'x') + "\n");
  EXPECT_TRUE(typist.wait([&] { return !typist.not_kept().empty(); }));
  EXPECT_NE(typist.not_kept().find("m.odl"), std::string::npos) << typist.not_kept();
  EXPECT_TRUE(server.prints("what is not saved is not kept: `m.odl`: No space left on device"))
      << server.printed();
  EXPECT_EQ(server.end(), 1) << server.printed();
  EXPECT_TRUE(server.prints("what was not saved is lost: `m.odl`: No space left on device"))
      << server.printed();
}

TEST_F(Durable, WhatWasToldNotToBeKeptIsKeptOnceItIsSaved) {
  Server::Setup nowhere = setup({"run", "m.mdl"});
  nowhere.environment = {{"XDG_STATE_HOME", ""}, {"HOME", ""}};
  Server server(nowhere);
  ASSERT_NE(server.port(), 0) << server.printed();
  EXPECT_TRUE(server.prints("what is not saved is lost then")) << server.printed();
  EXPECT_TRUE(server.prints("not kept: neither XDG_STATE_HOME nor HOME names a folder")) << server.printed();
  Typist typist(server);
  EXPECT_NE(typist.not_kept(), "");
  typist.type("-- a line\n");
  EXPECT_NE(typist.not_kept(), "");
  EXPECT_EQ(typist.save(), "");
  EXPECT_EQ(server.end(), 0) << "nothing is lost\n" << server.printed();
}

TEST_F(Durable, NeitherWhatIsTypedNorWhatSomebodyElseWritesIsLost) {
  const std::string theirs = std::string(kOverlay) + "-- theirs\n";
  const auto on_disk = [&] {
    std::ifstream file(folder_ / "project/m.odl");
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  {
    Server server(setup({"run", "m.mdl"}));
    ASSERT_NE(server.port(), 0) << server.printed();
    Typist typist(server);
    typist.type("-- mine\n");
    write("m.odl", theirs);
    EXPECT_NE(typist.save().find("changed by somebody else"), std::string::npos);
    server.kill();
  }
  Server server(setup({"run", "m.mdl"}));
  ASSERT_NE(server.port(), 0) << server.printed();
  Typist typist(server);
  EXPECT_NE(typist.text().find("-- mine"), std::string::npos) << typist.text();
  EXPECT_NE(typist.save().find("changed by somebody else"), std::string::npos)
      << "the next server knows, too";
  EXPECT_EQ(on_disk(), theirs);
}

TEST_F(Durable, TwoServersOfOneProjectKeepWhatIsTypedInEach) {
  {
    Server first(setup({"run", "m.mdl"}));
    ASSERT_NE(first.port(), 0) << first.printed();
    EXPECT_EQ(first.printed().find("another server"), std::string::npos) << first.printed();
    Typist at_first(first);
    at_first.type("-- typed in the first\n");
    Server second(setup({"edit", "c.cdl"}));
    ASSERT_NE(second.port(), 0) << second.printed();
    EXPECT_TRUE(second.prints("another server has this project open")) << second.printed();
    Server third(setup({"run", "m.mdl"}));
    ASSERT_NE(third.port(), 0) << third.printed();
    Typist at_third(third);
    EXPECT_EQ(at_third.text(), kOverlay);
    at_third.type("-- typed in the third\n");
    for (Server* one : {&first, &second, &third}) one->kill();
  }
  Server first(setup({"run", "m.mdl"}));
  ASSERT_NE(first.port(), 0) << first.printed();
  EXPECT_NE(Typist(first).text().find("-- typed in the first"), std::string::npos);
  EXPECT_TRUE(first.prints("m.odl was edited in two servers at once")) << first.printed();
  Server second(setup({"run", "m.mdl"}));
  Server third(setup({"run", "m.mdl"}));
  ASSERT_NE(third.port(), 0) << third.printed();
  EXPECT_NE(Typist(third).text().find("-- typed in the third"), std::string::npos);
}

TEST_F(Durable, AStateFolderThatCanNotBeMadeIsToldAtOnce) {
  Server::Setup setup_of_proc = setup({"edit", "c.cdl"});
  setup_of_proc.environment = {{"XDG_STATE_HOME", "/proc/no_such_folder"}};
  Server server(setup_of_proc);
  ASSERT_NE(server.port(), 0) << server.printed();
  EXPECT_TRUE(server.prints("what is not saved is lost then")) << server.printed();
  EXPECT_TRUE(server.prints("what is not saved is not kept: ")) << server.printed();
  EXPECT_EQ(server.end(), 0) << "nothing is lost\n" << server.printed();
}

// ---- the address

class Address : public Durable {
 protected:
  // A server that chooses its port itself: the one before it has left a port that is free again.
  Server::Setup next(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"run", "m.mdl"});
    Server::Setup out = setup(std::move(more));
    out.is_on_any_port = false;
    return out;
  }
  fs::path file() const {
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / "state")) {
      if (entry.path().filename() == "run.address") return entry.path();
    }
    return {};
  }
  // Where a server was found that then was killed.
  std::pair<int, std::string> first() const {
    Server server(setup({"run", "m.mdl"}));
    EXPECT_NE(server.port(), 0) << server.printed();
    server.kill();
    return {server.port(), server.token()};
  }
};

TEST_F(Address, IsThatOfTheServerBeforeWhateverEndedIt) {
  const auto [port, token] = first();
  for (int i = 0; i < 2; ++i) {
    Server again(next());
    EXPECT_EQ(again.port(), port) << again.printed();
    EXPECT_EQ(again.token(), token);
    if (i == 0) {
      EXPECT_EQ(again.end(), 0) << again.printed();
    }
  }
}

TEST_F(Address, IsReadableForNobodyElseAndElseNotBelieved) {
  const auto [port, token] = first();
  EXPECT_EQ(fs::status(file()).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(fs::status(file().parent_path()).permissions(), fs::perms::owner_all);
  fs::permissions(file(), fs::perms::group_read, fs::perm_options::add);
  {
    Server again(next());
    EXPECT_TRUE(again.prints("the address of the last start is not used again: others could have read it"))
        << again.printed();
    EXPECT_NE(again.token(), token);
  }
  EXPECT_EQ(fs::status(file()).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  fs::rename(file(), folder_ / "moved");
  fs::create_symlink(folder_ / "moved", folder_ / "link");
  for (const auto& entry : fs::recursive_directory_iterator(folder_ / "state")) {
    if (entry.path().filename() == "run.address.lock")
      fs::create_symlink(folder_ / "moved", entry.path().parent_path() / "run.address");
  }
  Server linked(next());
  EXPECT_TRUE(linked.prints("it can't be opened, or is a link")) << linked.printed();
}

TEST_F(Address, IsAnotherOneWhereSomebodyElseHasThePort) {
  const auto [port, token] = first();
  const int squatter = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const int yes = 1;
  ::setsockopt(squatter, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  ASSERT_EQ(::bind(squatter, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  ASSERT_EQ(::listen(squatter, 1), 0);
  {
    Server again(next());
    EXPECT_NE(again.port(), port);
    EXPECT_NE(again.token(), token) << "who has the port may have been told it";
  }
  ::close(squatter);
}

TEST_F(Address, OfAServerThatRunsStaysItsOwn) {
  Server one(setup({"run", "m.mdl"}));
  {
    Server two(setup({"run", "m.mdl"}));
    EXPECT_NE(two.token(), one.token());
  }
  one.kill();
  Server again(next());
  EXPECT_EQ(again.port(), one.port()) << again.printed();
  EXPECT_EQ(again.token(), one.token());
}

TEST_F(Address, HasANewTokenWhereThatIsAskedFor) {
  const auto [port, token] = first();
  Server again(next({"--new-token"}));
  EXPECT_EQ(again.port(), port) << again.printed();
  EXPECT_NE(again.token(), token);
  const std::string fresh = again.token();
  again.kill();
  Server last(next());
  EXPECT_EQ(last.token(), fresh) << "from then on it stays that one";
}

}  // namespace
}  // namespace mlab::durable
