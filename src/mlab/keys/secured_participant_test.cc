// Participants of a secured fleet: who proves that he belongs to it is heard, nobody else.

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "mlab/dds/participant.h"
#include "mlab/keys/certificates.h"
#include "mlab/keys/documents.h"
#include "mlab/keys/fleet_keys.h"
#include "mlab/keys/identity.h"
#include "mlab/keys/private_files.h"
#include "mlab/keys/testing/temporary_folder.h"

namespace mlab::keys {
namespace {
namespace fs = std::filesystem;

using namespace std::chrono_literals;
using dds::ChannelKind;

constexpr auto kPatience = 60s;  // for what takes a second on a machine that has nothing else to do

class SecuredParticipant : public ::testing::Test {
 protected:
  /// Tests run side by side.
  const std::string fleet_ = fmt::format("secured-{}", ::getpid());

  FleetKeys keys(const std::string& authority = "ours") {
    auto made = FleetKeys::open(temporary_.path() / authority, fleet_);
    EXPECT_TRUE(made) << made.error();
    return std::move(*made);
  }
  std::expected<dds::Participant, std::string> open(const std::optional<fs::path>& identity) {
    dds::Network network{.fleet = fleet_, .interface_name = {}, .peers = {}};
    if (identity) network.security = security_in(*identity);
    return dds::Participant::open(network);
  }
  dds::Participant participant(const std::optional<fs::path>& identity) {
    auto made = open(identity);
    EXPECT_TRUE(made) << made.error();
    return std::move(*made);
  }

  TemporaryFolder temporary_;
};

/// Who is heard here on one topic.
class Listener {
 public:
  explicit Listener(dds::Participant participant)
      : participant_(std::move(participant)),
        reader_(participant_.reader("agents", ChannelKind::kPresence, waiter_).value()) {}

  /// Waits until somebody has said `body`.
  bool hears(const std::string& body) {
    const auto until = std::chrono::steady_clock::now() + kPatience;
    while (std::chrono::steady_clock::now() < until) {
      for (const dds::Arrival& one : reader_.take()) {
        if (one.kind == dds::Arrival::Kind::kMessage) all_ += one.body + " ";
      }
      if (all_.contains(body)) return true;
      waiter_.wait(50ms);
    }
    return false;
  }
  const std::string& all() const { return all_; }
  std::vector<std::string> complaints() { return participant_.complaints(); }

 private:
  dds::Waiter waiter_ = dds::Waiter::make().value();
  dds::Participant participant_;
  dds::Reader reader_;
  std::string all_;
};

/// Somebody who says one thing, to whoever comes.
struct Speaker {
  Speaker(dds::Participant own, const std::string& body)
      : participant(std::move(own)), writer(participant.writer("agents", ChannelKind::kPresence).value()) {
    EXPECT_EQ(writer.write(body, body), dds::Written::kDone);
  }
  dds::Participant participant;
  dds::Writer writer;
};

/// Somebody who has no keys and writes under the name of a member's participant: that stands in each packet,
/// and numbers of writers are small ones.
class Impostor {
 public:
  Impostor(const std::string& fleet, dds::Guid member)
      : first_port_(7400 + 250 * dds::domain_of(fleet) + 10 + 2 * dds::kMaxParticipants - kPorts),
        member_(member),
        socket_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {}
  Impostor(const Impostor&) = delete;
  Impostor& operator=(const Impostor&) = delete;
  ~Impostor() { ::close(socket_); }

  /// As the second message of any of its writers, to all ports that the first participants of a fleet take,
  /// which are the last ones.
  void says(const std::string& body) const {
    constexpr int kMostWriters = 16;
    for (int writer = 1; writer <= kMostWriters; ++writer) {
      const std::string packet = packet_of(writer, body);
      for (int port = first_port_; port < first_port_ + kPorts; ++port) send(port, packet);
    }
  }

 private:
  static std::string number(std::uint32_t value) {
    std::string out;
    for (int shift = 0; shift < 32; shift += 8) out += static_cast<char>((value >> shift) & 0xffU);
    return out;
  }
  /// XCDR1, little endian: a text with its zero, at a multiple of four the bytes.
  static std::string envelope_of(const std::string& text) {
    std::string out("\0\1\0\0", 4);
    out += number(static_cast<std::uint32_t>(text.size() + 1)) + text + '\0';
    while (out.size() % 4 != 0) out += '\0';
    return out + number(static_cast<std::uint32_t>(text.size())) + text;
  }
  std::string packet_of(int writer, const std::string& text) const {
    constexpr char kWithKey = 2;
    std::string data("\0\0\x10\0\0\0\0\0\0\0", 10);  // where what follows begins, for any reader
    data += std::string{static_cast<char>(writer), kWithKey};
    data += number(0) + number(2) + envelope_of(text);
    while (data.size() % 4 != 0) data += '\0';
    constexpr std::size_t kPrefix = 12;
    std::string out("RTPS\x02\x01\x01\x10", 8);
    out.append(reinterpret_cast<const char*>(member_.bytes.data()), kPrefix);
    out += std::string("\x15\x05", 2) + static_cast<char>(data.size() & 0xffU) +
           static_cast<char>(data.size() >> 8U);
    return out + data;
  }
  void send(int port, const std::string& packet) const {
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(static_cast<std::uint16_t>(port));
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    ::sendto(socket_, packet.data(), packet.size(), 0, reinterpret_cast<const sockaddr*>(&to), sizeof to);
  }

  static constexpr int kPorts = 40;

  int first_port_;
  dds::Guid member_;
  int socket_;
};

TEST_F(SecuredParticipant, HearsWhoBelongsToTheFleetAndNobodyElse) {
  const fs::path north = keys().add("north").value();
  const fs::path south = keys().add("south").value();
  const fs::path strange = keys("theirs").add("south").value();
  // Those who must not be heard come first.
  const Speaker unsecured(participant(std::nullopt), "unsecured");
  const Speaker stranger(participant(strange), "strange");
  Listener without(participant(std::nullopt));
  ASSERT_TRUE(without.hears("unsecured"));
  Listener theirs(participant(strange));
  ASSERT_TRUE(theirs.hears("strange"));
  Listener ours(participant(south));
  const Speaker member(participant(north), "member");
  EXPECT_TRUE(ours.hears("member")) << fmt::format("{}", fmt::join(ours.complaints(), "\n"));
  EXPECT_EQ(ours.all(), "member ");
  // Another one that they hear is later than what they must not hear.
  const Speaker last_unsecured(participant(std::nullopt), "later");
  EXPECT_TRUE(without.hears("later"));
  EXPECT_EQ(without.all(), "unsecured later ");
  const Speaker last_stranger(participant(strange), "late");
  EXPECT_TRUE(theirs.hears("late"));
  EXPECT_EQ(theirs.all(), "strange late ");
}

TEST_F(SecuredParticipant, HearsNothingThatIsOnlySaidInTheNameOfAMember) {
  // Whose packets are not encrypted can be spoken for: so what the impostor sends is what would be obeyed.
  Listener without(participant(std::nullopt));
  Speaker unsecured(participant(std::nullopt), "unsecured");
  ASSERT_TRUE(without.hears("unsecured"));
  const Impostor false_one(fleet_, unsecured.participant.guid());
  false_one.says("forged");
  EXPECT_TRUE(without.hears("forged")) << without.all();
  Listener ours(participant(keys().add("south").value()));
  Speaker member(participant(keys().add("north").value()), "member");
  ASSERT_TRUE(ours.hears("member"));
  const Impostor impostor(fleet_, member.participant.guid());
  impostor.says("forged");
  ASSERT_EQ(member.writer.write("second", "second"), dds::Written::kDone);
  EXPECT_TRUE(ours.hears("second"));
  EXPECT_EQ(ours.all(), "member second ");
}

TEST_F(SecuredParticipant, DoesNotHearWhoWasWithdrawn) {
  FleetKeys all = keys();
  const fs::path north = all.add("north").value();
  const fs::path south = all.add("south").value();
  const fs::path east = all.add("east").value();
  const fs::path stolen = temporary_.path() / "stolen";
  const fs::path unaware = temporary_.path() / "unaware";
  fs::copy(north, stolen);  // both with the list of before
  fs::copy(south, unaware);
  ASSERT_TRUE(all.withdraw("north"));
  const Speaker withdrawn(participant(stolen), "withdrawn");
  Listener listener(participant(south));
  Listener old(participant(unaware));
  ASSERT_TRUE(old.hears("withdrawn")) << "who has not heard of it";
  const Speaker member(participant(east), "member");
  EXPECT_TRUE(listener.hears("member"));
  const Speaker later(participant(east), "later");
  EXPECT_TRUE(listener.hears("later"));
  EXPECT_EQ(listener.all(), "member later ");
}

TEST_F(SecuredParticipant, IsRefusedTopicsThatItHasNoPermissionFor) {
  const fs::path north = keys().add("north").value();
  dds::Network other{.fleet = "other-" + fleet_, .interface_name = {}, .peers = {}};
  other.security = security_in(north);
  auto lost = dds::Participant::open(other);
  ASSERT_TRUE(lost) << lost.error();
  EXPECT_FALSE(lost->writer("agents", ChannelKind::kPresence)) << "the partition of another fleet";
}

/// An identity that runs out in some seconds: that of a folder, made anew by an authority of its own.
void let_run_out(const fs::path& folder, const std::string& fleet, std::int64_t seconds) {
  const KeyPair authority = make_authority("authority@" + fleet, valid_for_days(10)).value();
  Validity validity = valid_for_days(0);
  validity.end += seconds;
  const KeyPair own = make_identity(authority, certified_name("north", fleet), validity).value();
  const std::string allowed = permissions(subject_in(own.certificate), fleet, validity);
  const std::pair<const char*, std::string> files[] = {
      {kAuthorityFile, authority.certificate},
      {kCertificateFile, own.certificate},
      {kKeyFile, own.key},
      {kGovernanceFile, sign_document(authority, governance()).value()},
      {kPermissionsFile, sign_document(authority, allowed).value()},
      {kWithdrawnFile, make_withdrawal_list(authority, {}, valid_for_days(10)).value()}};
  for (const auto& [name, text] : files) ASSERT_TRUE(write_private(folder / name, text));
}

TEST_F(SecuredParticipant, BeginsNothingOnceItsIdentityHasRunOut) {
  const fs::path north = keys().add("north").value();
  const dds::Participant good = participant(north);
  ASSERT_NO_FATAL_FAILURE(let_run_out(north, fleet_, 10));
  dds::Participant late = participant(north);
  EXPECT_FALSE(late.has_run_out());
  dds::Writer before = late.writer("agents", ChannelKind::kPresence).value();
  const auto last = std::chrono::steady_clock::now() + kPatience;
  while (!late.has_run_out() && std::chrono::steady_clock::now() < last) std::this_thread::sleep_for(100ms);
  ASSERT_TRUE(late.has_run_out());
  std::this_thread::sleep_for(4s);  // Cyclone has cut it off
  EXPECT_FALSE(good.has_run_out());
  const dds::Waiter waiter = dds::Waiter::make().value();
  for (const std::string& problem : {late.writer("life", ChannelKind::kPresence).error(),
                                     late.reader("life", ChannelKind::kPresence, waiter).error()})
    EXPECT_TRUE(problem.contains("has run out")) << problem;
  // What it had goes on in vain, and ends in order.
  EXPECT_NE(before.write("north", "anybody"), dds::Written::kFull);
}

TEST_F(SecuredParticipant, IsRefusedWithASentenceThatNamesTheFile) {
  const fs::path north = keys().add("north").value();
  const std::string was = read_file(north / kPermissionsFile).value();
  fs::remove(north / kPermissionsFile);
  EXPECT_TRUE(open(north).error().contains("permissions.p7s`, the signed permissions, is missing"));
  ASSERT_TRUE(write_private(north / kPermissionsFile, "nothing"));
  EXPECT_TRUE(open(north).error().contains("permissions.p7s` is not the signed permissions"));
  ASSERT_TRUE(write_private(north / kPermissionsFile, was));
  fs::copy_file(keys("theirs").add("north").value() / kPermissionsFile, north / kPermissionsFile,
                fs::copy_options::overwrite_existing);
  const auto refused = open(north);
  ASSERT_FALSE(refused) << "signed by somebody else";
  EXPECT_TRUE(refused.error().contains("no participant of the fleet")) << refused.error();
}

}  // namespace
}  // namespace mlab::keys
