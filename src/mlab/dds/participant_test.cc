#include "mlab/dds/participant.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <thread>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "mlab/dds/testing/fleet.h"

namespace mlab::dds {
namespace {

using std::chrono::milliseconds;
using Kind = Arrival::Kind;

/// Two participants, each of which waits for itself.
struct Two {
  Participant here = participant();
  Participant there = participant();
  Waiter waits = waiter();
  Waiter waits_there = waiter();
};

TEST(DdsParticipant, HearsBytesWithKeySenderAndTime) {
  Two two;
  Writer commands = writer(two.there, "veh-1/commands", ChannelKind::kCommands, &two.waits);
  Reader reads = reader(two.here, "veh-1/commands", ChannelKind::kCommands, two.waits);
  ASSERT_TRUE(comes_true(two.waits, [&] { return commands.readers().size() == 1; }));
  EXPECT_EQ(commands.readers().front(), two.here.guid());
  const std::string body("\0\xff any bytes\n", 13);
  const auto before = std::chrono::system_clock::now();
  ASSERT_EQ(commands.write("one", body), Written::kDone);
  const auto all = arrivals(two.waits, reads, Kind::kMessage);
  const Arrival message = first_of(all, Kind::kMessage);
  EXPECT_EQ(message.key, "one");
  EXPECT_EQ(message.body, body);
  EXPECT_EQ(message.sender, two.there.guid());
  EXPECT_GE(message.sent, before);
  EXPECT_LE(message.sent, std::chrono::system_clock::now());
  EXPECT_LE(message.noticed, std::chrono::steady_clock::now());
  EXPECT_EQ(all.front().kind, Kind::kMatched);
  EXPECT_EQ(all.front().sender, two.there.guid());
  EXPECT_EQ(reads.senders(), std::vector{two.there.guid()});
}

TEST(DdsParticipant, HearsInBothDirectionsAtTheSameTime) {
  Two two;
  Writer out = writer(two.here, "out", ChannelKind::kEvents, &two.waits);
  Reader out_there = reader(two.there, "out", ChannelKind::kEvents, two.waits_there);
  Writer back = writer(two.there, "back", ChannelKind::kEvents, &two.waits_there);
  Reader back_here = reader(two.here, "back", ChannelKind::kEvents, two.waits);
  ASSERT_TRUE(comes_true(two.waits, [&] { return !out.readers().empty(); }));
  ASSERT_TRUE(comes_true(two.waits_there, [&] { return !back.readers().empty(); }));
  constexpr int kMessages = 500;
  std::jthread other([&] {
    for (int i = 0; i < kMessages; ++i) write_surely(back, "", std::to_string(i));
  });
  for (int i = 0; i < kMessages; ++i) write_surely(out, "", std::to_string(i));
  other.join();
  const auto there = bodies(arrivals(two.waits_there, out_there, Kind::kMessage, kMessages));
  const auto here = bodies(arrivals(two.waits, back_here, Kind::kMessage, kMessages));
  ASSERT_EQ(there.size(), static_cast<std::size_t>(kMessages));
  ASSERT_EQ(here.size(), static_cast<std::size_t>(kMessages));
  for (int i = 0; i < kMessages; ++i) {
    ASSERT_EQ(there[static_cast<std::size_t>(i)], std::to_string(i));
    ASSERT_EQ(here[static_cast<std::size_t>(i)], std::to_string(i));
  }
}

TEST(DdsParticipant, TellsWhoComesLateTheNewestOfEachKey) {
  Two two;
  Writer status = writer(two.there, "status", ChannelKind::kStatus);
  for (const std::string body : {"1", "2", "3"}) {
    write_surely(status, "a", "a" + body);
    write_surely(status, "b", "b" + body);
    write_surely(status, "c", "c" + body);
  }
  ASSERT_EQ(status.end("c"), Written::kDone);
  Reader late = reader(two.here, "status", ChannelKind::kStatus, two.waits);
  std::multiset<std::string> told;
  for (const Arrival& arrival : arrivals(two.waits, late, Kind::kMessage, 2)) {
    if (arrival.kind == Kind::kMessage) told.insert(arrival.body);
  }
  EXPECT_EQ(told, (std::multiset<std::string>{"a3", "b3"}));
}

TEST(DdsParticipant, TellsWhoComesLateNoCommandOfBefore) {
  Two two;
  Writer commands = writer(two.there, "commands", ChannelKind::kCommands, &two.waits);
  write_surely(commands, "", "before");
  Reader late = reader(two.here, "commands", ChannelKind::kCommands, two.waits);
  ASSERT_TRUE(comes_true(two.waits, [&] { return !commands.readers().empty(); }));
  write_surely(commands, "", "after");
  EXPECT_EQ(bodies(arrivals(two.waits, late, Kind::kMessage)), std::vector<std::string>{"after"});
}

TEST(DdsParticipant, TellsWhatWasEndedApartFromWhatNobodyWritesAnyMore) {
  Two two;
  auto presence = std::make_unique<Writer>(writer(two.there, "presence", ChannelKind::kPresence));
  Reader reads = reader(two.here, "presence", ChannelKind::kPresence, two.waits);
  write_surely(*presence, "a", "");
  write_surely(*presence, "b", "");
  arrivals(two.waits, reads, Kind::kMessage, 2);
  ASSERT_EQ(presence->end("a"), Written::kDone);
  EXPECT_EQ(first_of(arrivals(two.waits, reads, Kind::kEnded), Kind::kEnded).key, "a");
  presence.reset();
  const auto gone = arrivals(two.waits, reads, Kind::kUnmatched);
  EXPECT_EQ(first_of(gone, Kind::kOrphaned).key, "b");
  EXPECT_EQ(first_of(gone, Kind::kOrphaned).sender, two.there.guid());
  EXPECT_EQ(first_of(gone, Kind::kSilent).sender, Guid{}) << "it went in good order";
  EXPECT_TRUE(reads.senders().empty());
}

TEST(DdsParticipant, KeepsFleetsApartWhoseDomainIsTheSame) {
  const std::string fleet = fleet_of_this_process();
  std::string same_domain;
  for (int i = 0; same_domain.empty(); ++i) {
    const std::string name = fmt::format("{}-{}", fleet, i);
    if (domain_of(name) == domain_of(fleet)) same_domain = name;
  }
  Participant here = participant(0, fleet);
  Participant there = participant(0, fleet);
  Participant stranger = participant(0, same_domain);
  Waiter waits = waiter();
  Writer of_here = writer(here, "status", ChannelKind::kStatus, &waits);
  Writer of_stranger = writer(stranger, "status", ChannelKind::kStatus, &waits);
  Reader reads = reader(there, "status", ChannelKind::kStatus, waits);
  Reader of_strangers = reader(stranger, "status", ChannelKind::kStatus, waits);
  write_surely(of_here, "", "ours");
  write_surely(of_stranger, "", "not ours");
  // Once both have heard from their own, as far away as from each other, they would have heard from the
  // others too.
  EXPECT_EQ(bodies(arrivals(waits, of_strangers, Kind::kMessage)), std::vector<std::string>{"not ours"});
  EXPECT_EQ(bodies(arrivals(waits, reads, Kind::kMessage)), std::vector<std::string>{"ours"});
  std::this_thread::sleep_for(milliseconds(300));
  EXPECT_TRUE(bodies(reads.take()).empty());
  EXPECT_TRUE(bodies(of_strangers.take()).empty());
  EXPECT_EQ(of_here.readers().size(), 1U);
  EXPECT_EQ(of_stranger.readers().size(), 1U);
}

TEST(DdsParticipant, TakesNothingThatIsWrittenAsAnotherKindAndSaysSo) {
  Two two;
  Writer events = writer(two.there, "topic", ChannelKind::kEvents, &two.waits);
  Reader commands = reader(two.here, "topic", ChannelKind::kCommands, two.waits);
  Reader right = reader(two.here, "topic", ChannelKind::kEvents, two.waits);
  ASSERT_TRUE(
      comes_true(two.waits, [&] { return !events.mismatches().empty() && !events.readers().empty(); }));
  write_surely(events, "", "an event");
  EXPECT_EQ(bodies(arrivals(two.waits, right, Kind::kMessage)), std::vector<std::string>{"an event"});
  EXPECT_TRUE(commands.take().empty());
  EXPECT_TRUE(commands.senders().empty());
  EXPECT_EQ(events.readers().size(), 1U);
  EXPECT_EQ(commands.mismatches(),
            std::vector{two.there.guid().text() + " writes `topic` as `events`: here it is `commands`"});
  EXPECT_EQ(events.mismatches(),
            std::vector{two.here.guid().text() + " reads `topic` as `commands`: here it is `events`"});
  EXPECT_TRUE(right.mismatches().empty());
}

TEST(DdsParticipant, SaysSoWhereQualityOfServiceDoesNotMatch) {
  Two two;
  Writer percepts = writer(two.there, "topic", ChannelKind::kLivePercepts, &two.waits);
  Reader events = reader(two.here, "topic", ChannelKind::kEvents, two.waits);
  ASSERT_TRUE(
      comes_true(two.waits, [&] { return !events.mismatches().empty() && !percepts.mismatches().empty(); }));
  EXPECT_EQ(events.mismatches().front(),
            "somebody writes `topic` in a way that does not go with `events`: reliability");
  EXPECT_EQ(percepts.mismatches().front(),
            "somebody reads `topic` in a way that does not go with `live percepts`: reliability");
}

TEST(DdsParticipant, CarriesTheLongestBodiesAndKeysAndRefusesLongerOnes) {
  Two two;
  Writer events = writer(two.there, "events", ChannelKind::kEvents, &two.waits);
  Reader reads = reader(two.here, "events", ChannelKind::kEvents, two.waits);
  ASSERT_TRUE(comes_true(two.waits, [&] { return !events.readers().empty(); }));
  std::string body(kMaxBody, 'x');
  for (std::size_t i = 0; i < body.size(); ++i) body[i] = static_cast<char>(i * 7);
  const std::string key(kMaxKey, 'k');
  write_surely(events, key, body);
  const Arrival message = first_of(arrivals(two.waits, reads, Kind::kMessage), Kind::kMessage);
  EXPECT_EQ(message.key, key);
  EXPECT_TRUE(message.body == body);
  EXPECT_EQ(events.write("", body + "x"), Written::kTooLong);
  EXPECT_EQ(events.write(key + "k", ""), Written::kBadKey);
  EXPECT_EQ(events.write(std::string_view("a\0b", 3), ""), Written::kBadKey);
  EXPECT_EQ(events.end(key + "k"), Written::kBadKey);
  write_surely(events, "", "");
  EXPECT_EQ(bodies(arrivals(two.waits, reads, Kind::kMessage)), std::vector<std::string>{""});
}

TEST(DdsParticipant, RefusesTopicsWithoutAProperName) {
  Participant one = participant();
  const Waiter waits = waiter();
  for (const std::string& name : {std::string(), std::string(201, 'a'), std::string("a b"), std::string("a*"),
                                  std::string("a\0b", 3)}) {
    EXPECT_FALSE(one.writer(name, ChannelKind::kEvents)) << name;
    EXPECT_FALSE(one.reader(name, ChannelKind::kEvents, waits)) << name;
  }
  EXPECT_EQ(one.writer("a b", ChannelKind::kEvents).error(),
            "the topic's name `a b` has more than letters, digits, `_`, `-`, `.` and `/`");
  EXPECT_TRUE(one.writer("1/veh-1_a.b", ChannelKind::kEvents));
}

TEST(DdsParticipant, KeepsTopicsApartWhoseNamesAreAlike) {
  Two two;
  Writer dash = writer(two.there, "a-b", ChannelKind::kStatus);
  Writer dot = writer(two.there, "a.b", ChannelKind::kStatus);
  Writer letters = writer(two.there, "a_mb", ChannelKind::kStatus);
  Reader reads = reader(two.here, "a-b", ChannelKind::kStatus, two.waits);
  write_surely(dot, "", "dot");
  write_surely(letters, "", "letters");
  write_surely(dash, "", "dash");
  EXPECT_EQ(bodies(arrivals(two.waits, reads, Kind::kMessage)), std::vector<std::string>{"dash"});
  EXPECT_EQ(reads.senders().size(), 1U);
}

TEST(DdsParticipant, TakesNoSettingFromTheEnvironment) {
  ::setenv("CYCLONEDDS_URI", "<CycloneDDS><Domain><General><Interfaces><nonsense/></CycloneDDS>", 1);
  const auto opened = Participant::open(
      {.fleet = fleet_of_this_process(), .interface_name = {}, .peers = {}, .lost_of_thousand = 0});
  ::unsetenv("CYCLONEDDS_URI");
  EXPECT_TRUE(opened) << opened.error();
}

TEST(DdsParticipant, RefusesBadSettingsWithASentence) {
  const auto opened =
      Participant::open({.fleet = "a*b", .interface_name = {}, .peers = {}, .lost_of_thousand = 0});
  ASSERT_FALSE(opened);
  EXPECT_NE(opened.error().find("the fleet's name `a*b`"), std::string::npos);
}

/// Takes all ports of a fleet's domain.
class TakenPorts {
 public:
  explicit TakenPorts(int domain) {
    for (int i = 0; i < 2 * kMaxParticipants; ++i) {
      const int socket = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
      sockaddr_in at{};
      at.sin_family = AF_INET;
      at.sin_port = htons(static_cast<std::uint16_t>(7400 + 250 * domain + 10 + i));
      // Those that are taken already are taken, too.
      [[maybe_unused]] const int bound = ::bind(socket, reinterpret_cast<const sockaddr*>(&at), sizeof at);
      sockets_.push_back(socket);
    }
  }
  TakenPorts(const TakenPorts&) = delete;
  TakenPorts& operator=(const TakenPorts&) = delete;
  ~TakenPorts() {
    for (const int socket : sockets_) ::close(socket);
  }

 private:
  std::vector<int> sockets_;
};

TEST(DdsParticipant, SaysSoWhereAMachineHasNoPlaceLeft) {
  const std::string fleet = fleet_of_this_process();
  std::string error;
  {
    const TakenPorts taken(domain_of(fleet));
    const auto opened =
        Participant::open({.fleet = fleet, .interface_name = {}, .peers = {}, .lost_of_thousand = 0});
    ASSERT_FALSE(opened);
    error = opened.error();
  }
  EXPECT_NE(error.find("no place (of 120 on this machine) on the network of the fleet `" + fleet + "`"),
            std::string::npos)
      << error;
  EXPECT_NE(error.find("failed to create unicast sockets"), std::string::npos) << error;
  const Participant afterwards = participant();
  EXPECT_NE(afterwards.guid(), Guid{});
}

/// The devices that the sockets of this process which hear all addresses are tied to; empty for one that is
/// not.
std::vector<std::string> devices_heard() {
  std::vector<std::string> devices;
  for (int descriptor = 0; descriptor < 256; ++descriptor) {
    sockaddr_in at{};
    socklen_t size = sizeof at;
    if (::getsockname(descriptor, reinterpret_cast<sockaddr*>(&at), &size) != 0) continue;
    if (at.sin_family != AF_INET || at.sin_addr.s_addr != htonl(INADDR_ANY)) continue;
    std::array<char, 64> name{};
    socklen_t length = name.size();
    EXPECT_EQ(::getsockopt(descriptor, SOL_SOCKET, SO_BINDTODEVICE, name.data(), &length), 0);
    devices.emplace_back(name.data());
  }
  return devices;
}

TEST(DdsParticipant, HearsNobodyFromOtherMachinesUnlessAnInterfaceIsNamed) {
  const Participant one = participant();
  const Participant other = participant();
  const std::vector<std::string> devices = devices_heard();
  EXPECT_GE(devices.size(), 4U) << "those of multicast are there where the loopback carries it";
  EXPECT_EQ(devices, std::vector<std::string>(devices.size(), "lo"));
}

TEST(DdsParticipant, SaysNothingOnTheTerminal) {
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  {
    Two two;
    Writer status = writer(two.there, "status", ChannelKind::kStatus);
    Reader reads = reader(two.here, "status", ChannelKind::kStatus, two.waits);
    write_surely(status, "", "");
    arrivals(two.waits, reads, Kind::kMessage);
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

std::size_t threads_of_this_process() {
  std::size_t count = 0;
  for ([[maybe_unused]] const auto& one : std::filesystem::directory_iterator("/proc/self/task")) ++count;
  return count;
}

std::size_t descriptors_of_this_process() {
  std::size_t count = 0;
  for ([[maybe_unused]] const auto& one : std::filesystem::directory_iterator("/proc/self/fd")) ++count;
  return count;
}

/// What processes of this one's could have left there: names with its number, and those of shared memory for
/// messages.
std::set<std::string> left_behind() {
  std::set<std::string> found;
  for (const char* folder : {"/dev/shm", "/tmp", "."}) {
    for (const auto& one : std::filesystem::directory_iterator(folder)) {
      const std::string name = one.path().filename();
      for (const std::string& word : {std::string("iox"), std::string("cyclone"), std::string("iceoryx")})
        if (name.find(word) != std::string::npos) found.insert(one.path());
    }
  }
  return found;
}

TEST(DdsParticipant, LeavesNothingBehind) {
  std::thread([] {}).join();  // the sanitizer has one of its own from the first one on
  const auto before = left_behind();
  const std::size_t threads = threads_of_this_process();
  const std::size_t descriptors = descriptors_of_this_process();
  for (int i = 0; i < 3; ++i) {
    Two two;
    Writer status = writer(two.there, "status", ChannelKind::kStatus);
    Reader reads = reader(two.here, "status", ChannelKind::kStatus, two.waits);
    write_surely(status, "", "");
    ASSERT_FALSE(bodies(arrivals(two.waits, reads, Kind::kMessage)).empty());
    EXPECT_EQ(left_behind(), before);
  }
  EXPECT_EQ(left_behind(), before);
  // The kernel forgets a thread a moment after who waits for it goes on.
  for (int i = 0; i < 10'000 && threads_of_this_process() > threads; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_EQ(threads_of_this_process(), threads);
  EXPECT_EQ(descriptors_of_this_process(), descriptors);
}

TEST(DdsParticipant, LivesAsLongAsAnyOfItsReadersAndWriters) {
  Waiter waits = waiter();
  Participant there = participant();
  auto here = std::make_unique<Participant>(participant());
  Reader reads = reader(*here, "status", ChannelKind::kStatus, waits);
  here.reset();
  Writer status = writer(there, "status", ChannelKind::kStatus);
  write_surely(status, "", "still there");
  EXPECT_EQ(bodies(arrivals(waits, reads, Kind::kMessage)), std::vector<std::string>{"still there"});
}

TEST(DdsParticipant, HasPlaceForManyInOneProcess) {
  constexpr std::size_t kMany = 8;
  Waiter waits = waiter();
  std::vector<Participant> all;
  std::vector<Writer> writers;
  std::vector<Reader> readers;
  for (std::size_t i = 0; i < kMany; ++i) {
    all.push_back(participant());
    writers.push_back(writer(all.back(), "status", ChannelKind::kStatus, &waits));
    readers.push_back(reader(all.back(), "status", ChannelKind::kStatus, waits));
  }
  EXPECT_TRUE(comes_true(waits, [&] {
    return std::ranges::all_of(readers, [](const Reader& one) { return one.senders().size() == kMany; });
  }));
}

}  // namespace
}  // namespace mlab::dds
