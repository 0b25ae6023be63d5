#include "mlab/keys/fleet_keys.h"

#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/keys/identity.h"
#include "mlab/keys/private_files.h"
#include "mlab/keys/testing/temporary_folder.h"

namespace mlab::keys {
namespace {
namespace fs = std::filesystem;

FleetKeys opened(const fs::path& folder) {
  auto made = FleetKeys::open(folder, "alpha");
  EXPECT_TRUE(made) << made.error();
  return std::move(*made);
}

TEST(FleetKeys, AreMadeOnceAndFoundAgain) {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path() / "keys" / "alpha";
  EXPECT_FALSE(FleetKeys::are_there(folder));
  const fs::path north = opened(folder).add("north").value();
  EXPECT_TRUE(FleetKeys::are_there(folder));
  const fs::path south = opened(folder).add("south").value();
  EXPECT_EQ(read_file(north / kAuthorityFile), read_file(south / kAuthorityFile));
  EXPECT_EQ(opened(folder).names(), (std::vector<std::string>{"north", "south"}));
  EXPECT_TRUE(check_identity(south, "alpha"));
}

TEST(FleetKeys, CanBeReadByNobodyElse) {
  const TemporaryFolder temporary;
  ASSERT_TRUE(opened(temporary.path() / "alpha").add("north"));
  for (const fs::directory_entry& one : fs::recursive_directory_iterator(temporary.path() / "alpha"))
    EXPECT_EQ(one.status().permissions(),
              one.is_directory() ? fs::perms::owner_all : fs::perms::owner_read | fs::perms::owner_write)
        << one.path();
}

TEST(FleetKeys, KeepTheListOfWithdrawnIdentitiesInAllFolders) {
  const TemporaryFolder temporary;
  FleetKeys keys = opened(temporary.path() / "alpha");
  const fs::path north = keys.add("north").value();
  const fs::path south = keys.add("south").value();
  const fs::path moved = keys.add("moved").value();
  fs::remove_all(moved);
  ASSERT_TRUE(keys.withdraw("north"));
  EXPECT_FALSE(fs::exists(north));
  EXPECT_FALSE(fs::exists(moved)) << "it is on another machine";
  EXPECT_EQ(read_file(south / kWithdrawnFile), read_file(keys.withdrawn_file()));
  EXPECT_EQ(keys.names(), (std::vector<std::string>{"moved", "south"}));
  EXPECT_TRUE(check_identity(south, "alpha"));
  ASSERT_TRUE(keys.withdraw("moved"));
}

TEST(FleetKeys, AreAsBeforeWhereAWithdrawalFailed) {
  const TemporaryFolder temporary;
  FleetKeys keys = opened(temporary.path() / "alpha");
  const fs::path north = keys.add("north").value();
  const std::string certificate = read_file(north / kCertificateFile).value();
  fs::remove(keys.withdrawn_file());
  fs::create_directories(keys.withdrawn_file() / "in the way");
  ASSERT_FALSE(keys.withdraw("north"));
  EXPECT_EQ(keys.names(), std::vector<std::string>{"north"});
  EXPECT_TRUE(fs::exists(north));
  fs::remove_all(keys.withdrawn_file());
  ASSERT_TRUE(keys.withdraw("north")) << "it can be done again";
  const auto is_gone =
      is_withdrawn(read_file(keys.withdrawn_file()).value(), certificate,
                   read_file(temporary.path() / "alpha" / "authority" / kAuthorityFile).value());
  EXPECT_TRUE(is_gone && *is_gone);
}

TEST(FleetKeys, TakeBackAnIdentityThatCanNotBeWrittenWhole) {
  const TemporaryFolder temporary;
  FleetKeys keys = opened(temporary.path() / "alpha");
  const fs::path north = temporary.path() / "alpha" / "north";
  fs::create_directories(north / kKeyFile / "in the way");
  ASSERT_FALSE(keys.add("north"));
  EXPECT_TRUE(keys.names().empty());
  for (const char* file :
       {kAuthorityFile, kGovernanceFile, kPermissionsFile, kWithdrawnFile, kCertificateFile})
    EXPECT_FALSE(fs::exists(north / file)) << file;
  EXPECT_TRUE(fs::exists(north / kKeyFile / "in the way")) << "it is somebody's";
  fs::remove_all(north);
  ASSERT_TRUE(keys.add("north"));
  EXPECT_TRUE(check_identity(north, "alpha"));
}

TEST(FleetKeys, MakeAnewWhatIsHalfMade) {
  const TemporaryFolder temporary;
  FleetKeys keys = opened(temporary.path() / "alpha");
  const fs::path north = keys.add("north").value();
  EXPECT_TRUE(keys.half_made().empty());
  fs::remove(north / kCertificateFile);  // as somebody leaves it who is killed
  EXPECT_EQ(keys.half_made(), std::vector<std::string>{"north"});
  ASSERT_TRUE(keys.add("north"));
  EXPECT_TRUE(keys.half_made().empty());
  EXPECT_TRUE(check_identity(north, "alpha"));
  fs::remove_all(north);
  EXPECT_TRUE(keys.half_made().empty()) << "it is on its machine";
  EXPECT_FALSE(keys.was_withdrawn("north"));
  ASSERT_TRUE(keys.withdraw("north"));
  EXPECT_TRUE(keys.was_withdrawn("north"));
}

TEST(FleetKeys, AreMadeByOneAtATime) {
  const TemporaryFolder temporary;
  std::vector<std::thread> makers;
  for (int i = 0; i < 4; ++i) {
    makers.emplace_back([&, i] {
      auto keys = FleetKeys::open(temporary.path() / "alpha", "alpha");
      ASSERT_TRUE(keys) << keys.error();
      EXPECT_TRUE(keys->add("n" + std::to_string(i)));
    });
  }
  for (std::thread& maker : makers) maker.join();
  FleetKeys keys = opened(temporary.path() / "alpha");
  EXPECT_EQ(keys.names().size(), 4U);
  for (const std::string& name : keys.names())
    EXPECT_TRUE(check_identity(temporary.path() / "alpha" / name, "alpha")) << name;
}

TEST(FleetKeys, GiveANameThatWasWithdrawnToAnother) {
  const TemporaryFolder temporary;
  FleetKeys keys = opened(temporary.path() / "alpha");
  for (int i = 0; i < 3; ++i) {
    const auto north = keys.add("north");
    ASSERT_TRUE(north) << north.error();
    EXPECT_TRUE(check_identity(*north, "alpha")) << "the old one is withdrawn, not this";
    ASSERT_TRUE(keys.withdraw("north"));
  }
}

TEST(FleetKeys, RefuseNamesThatAreTakenUnknownOrNone) {
  const TemporaryFolder temporary;
  FleetKeys keys = opened(temporary.path() / "alpha");
  ASSERT_TRUE(keys.add("north"));
  EXPECT_EQ(keys.add("north").error(),
            "the fleet `alpha` has an identity `north` already: --withdraw north makes place for another");
  EXPECT_EQ(keys.withdraw("south").error(), "the fleet `alpha` has no identity `south`: there is `north`");
  for (const char* name : {"", ".", "..", "a/b", "authority", "a b", "<a>", "a,CN=b", "a@b"})
    EXPECT_FALSE(keys.add(name)) << name;
  EXPECT_FALSE(keys.add(std::string(65, 'a')));
}

TEST(FleetKeys, AreMadeForTheLongestNames) {
  const TemporaryFolder temporary;
  const std::string fleet(64, 'f');
  const auto made = FleetKeys::open(temporary.path(), fleet).value().add(std::string(64, 'n'));
  ASSERT_TRUE(made) << made.error();
  EXPECT_EQ(check_identity(*made, fleet).value().name, std::string(64, 'n'));
}

TEST(FleetKeys, AreNotMadeBesideAnIdentityThatWasBrought) {
  const TemporaryFolder temporary;
  fs::create_directories(temporary.path() / "alpha" / kOwnIdentity);
  EXPECT_TRUE(FleetKeys::open(temporary.path() / "alpha", "alpha").error().contains("on another machine"));
}

TEST(FleetKeys, AreNotMadeAnewWhereAPartIsMissing) {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path() / "alpha";
  static_cast<void>(opened(folder));
  fs::remove(folder / "authority" / kAuthorityFile);
  EXPECT_TRUE(FleetKeys::open(folder, "alpha").error().contains("is missing"));
}

}  // namespace
}  // namespace mlab::keys
