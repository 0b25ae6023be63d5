#include "mlab/keys/identity.h"

#include <unistd.h>

#include <gtest/gtest.h>

#include "mlab/keys/certificates.h"
#include "mlab/keys/fleet_keys.h"
#include "mlab/keys/private_files.h"
#include "mlab/keys/testing/temporary_folder.h"

namespace mlab::keys {
namespace {
namespace fs = std::filesystem;

/// An identity `north` of the fleet `alpha`, whose files tests spoil.
class IdentityFolder : public ::testing::Test {
 protected:
  FleetKeys keys(const std::string& fleet = "alpha") {
    auto made = FleetKeys::open(temporary_.path() / fleet, fleet);
    EXPECT_TRUE(made) << made.error();
    return std::move(*made);
  }
  fs::path add(const std::string& name, const std::string& fleet = "alpha") {
    const auto made = keys(fleet).add(name);
    EXPECT_TRUE(made) << made.error();
    return *made;
  }
  static std::string problem(const fs::path& folder, const std::string& fleet = "alpha") {
    const auto checked = check_identity(folder, fleet);
    return checked ? "" : checked.error();
  }
  static bool complains(const std::string& problem, const char* file, const std::string& words) {
    return problem.contains(file) && problem.contains(words);
  }

  TemporaryFolder temporary_;
};

TEST_F(IdentityFolder, IsFitForUseAsItWasMade) {
  const fs::path north = add("north");
  const auto checked = check_identity(north, "alpha");
  ASSERT_TRUE(checked) << checked.error();
  EXPECT_EQ(checked->name, "north");
  EXPECT_GT(checked->end, 0);
}

TEST_F(IdentityFolder, OfAnotherFleetIsRefused) {
  EXPECT_TRUE(complains(problem(add("north"), "beta"), kCertificateFile,
                        "is of `north@alpha`, none of the fleet `beta`"));
}

TEST_F(IdentityFolder, IsRefusedWhereAFileIsMissingEmptyOrSomethingElse) {
  for (const char* file :
       {kAuthorityFile, kCertificateFile, kKeyFile, kGovernanceFile, kPermissionsFile, kWithdrawnFile}) {
    const fs::path north =
        add(fs::path(file).extension().string().substr(1) + fs::path(file).stem().string());
    const std::string was = read_file(north / file).value();
    fs::remove(north / file);
    EXPECT_TRUE(complains(problem(north), file, "is missing")) << problem(north);
    ASSERT_TRUE(write_private(north / file, ""));
    EXPECT_TRUE(complains(problem(north), file, "is no ")) << problem(north);
    ASSERT_TRUE(write_private(north / file, was.substr(0, was.size() / 2)));
    EXPECT_TRUE(complains(problem(north), file, "is no ")) << problem(north);
    fs::remove(north / file);
    fs::create_directory(north / file);
    EXPECT_TRUE(complains(problem(north), file, "is no file")) << problem(north);
  }
}

TEST_F(IdentityFolder, ThatCannotBeEnteredSaysSo) {
  const fs::path north = add("north");
  fs::permissions(north, fs::perms::none);
  const uid_t user = ::geteuid();
  constexpr uid_t kNobody = 65534;
  EXPECT_EQ(::seteuid(user == 0 ? kNobody : user), 0);  // root may enter whatever there is
  const std::string said = problem(north);
  ASSERT_EQ(::seteuid(user), 0);
  fs::permissions(north, fs::perms::owner_all);
  EXPECT_TRUE(complains(said, kAuthorityFile, "can't be read: Permission denied")) << said;
}

TEST_F(IdentityFolder, IsRefusedWhereAFileIsAnotherAuthoritys) {
  const fs::path strange = add("north", "beta");
  for (const char* file : {kCertificateFile, kGovernanceFile, kPermissionsFile, kWithdrawnFile, kKeyFile}) {
    const fs::path north =
        add(fs::path(file).extension().string().substr(1) + fs::path(file).stem().string());
    fs::copy_file(strange / file, north / file, fs::copy_options::overwrite_existing);
    EXPECT_TRUE(problem(north).contains(file)) << problem(north);
  }
}

TEST_F(IdentityFolder, IsRefusedWithThePermissionsOfSomebodyElse) {
  const fs::path north = add("north");
  fs::copy_file(add("south") / kPermissionsFile, north / kPermissionsFile,
                fs::copy_options::overwrite_existing);
  EXPECT_TRUE(complains(problem(north), kPermissionsFile, "is of another identity"));
}

TEST_F(IdentityFolder, IsRefusedWhereOthersCouldReadItsKey) {
  const fs::path north = add("north");
  fs::permissions(north / kKeyFile, fs::perms::group_read, fs::perm_options::add);
  EXPECT_TRUE(complains(problem(north), kKeyFile, "can be read or changed by others: `chmod 600 "));
}

TEST_F(IdentityFolder, IsRefusedOnceItIsOnTheListOfThoseWhoWereWithdrawn) {
  const fs::path north = add("north");
  const fs::path kept = temporary_.path() / "kept";
  fs::copy(north, kept);
  WithdrawalWatch watch(kept);
  EXPECT_FALSE(watch.has_changed());
  FleetKeys all = keys();
  ASSERT_TRUE(all.withdraw("north"));
  fs::copy_file(all.withdrawn_file(), kept / kWithdrawnFile, fs::copy_options::overwrite_existing);
  EXPECT_TRUE(watch.has_changed());
  EXPECT_FALSE(watch.has_changed());
  EXPECT_TRUE(complains(problem(kept), kCertificateFile, "was withdrawn")) << problem(kept);
}

TEST_F(IdentityFolder, IsNoticedOnceWhereItIsTakenAway) {
  WithdrawalWatch watch(add("north"));
  EXPECT_FALSE(watch.has_changed());
  ASSERT_TRUE(keys().withdraw("north"));
  EXPECT_TRUE(watch.has_changed());
  EXPECT_FALSE(watch.has_changed());
}

TEST(Certificates, ThatAreOutOfDateSaySinceWhen) {
  const auto authority = make_authority("authority@alpha", valid_for_days(10));
  ASSERT_TRUE(authority) << authority.error();
  Validity past = valid_for_days(0);
  past.begin -= 200'000;
  past.end -= 100'000;
  const auto old = make_identity(*authority, "north@alpha", past);
  ASSERT_TRUE(old) << old.error();
  EXPECT_EQ(check_certificate(old->certificate, authority->certificate).error(), "expired 1 day ago");
  Validity later = valid_for_days(10);
  later.begin += 400'000;
  const auto early = make_identity(*authority, "north@alpha", later);
  ASSERT_TRUE(early) << early.error();
  EXPECT_EQ(check_certificate(early->certificate, authority->certificate).error(),
            "counts only 3 days from now: is this machine's clock right?");
}

TEST_F(IdentityFolder, CountsWithAListThatIsNewerThanItsMachinesClockSays) {
  const fs::path north = add("north");
  add("south");
  FleetKeys all = keys();
  ASSERT_TRUE(all.withdraw("south"));
  const std::string authority = read_file(north / kAuthorityFile).value();
  const std::string list = read_file(all.withdrawn_file()).value();
  // As it would be read on a machine whose clock stands where the authority's begins.
  EXPECT_EQ(list_validity_of(list).begin, validity_of(authority).begin);
  EXPECT_EQ(problem(north), "");
}

TEST(Lists, ThatCountOnlyLaterSaySo) {
  const auto authority = make_authority("authority@alpha", valid_for_days(10));
  ASSERT_TRUE(authority) << authority.error();
  Validity later = valid_for_days(10);
  later.begin += 400'000;
  const auto list = make_withdrawal_list(*authority, {}, later);
  ASSERT_TRUE(list) << list.error();
  EXPECT_EQ(check_list(*list, authority->certificate).error(),
            "counts only 3 days from now: is this machine's clock right?");
}

TEST(Identities, ThatRunOutWithinAMonthSaySo) {
  constexpr std::int64_t kDay = 86'400;  // [s]
  EXPECT_EQ(running_out(seconds_now() + 31 * kDay), "");
  EXPECT_EQ(running_out(seconds_now() + 12 * kDay + 60), "runs out in 12 days");
  EXPECT_EQ(running_out(seconds_now() - 3 * kDay - 60), "ran out 3 days ago");
}

TEST_F(IdentityFolder, ThatHasRunOutSaysWhatMakesAnother) {
  const fs::path north = add("north");
  const auto authority = make_authority("authority@alpha", valid_for_days(10));
  ASSERT_TRUE(authority) << authority.error();
  Validity past = valid_for_days(0);
  past.end -= 100'000;
  const auto old = make_identity(*authority, "north@alpha", past);
  ASSERT_TRUE(old) << old.error();
  ASSERT_TRUE(write_private(north / kAuthorityFile, authority->certificate));
  ASSERT_TRUE(write_private(north / kCertificateFile, old->certificate));
  EXPECT_TRUE(complains(problem(north), kCertificateFile, "`mlab keys alpha --withdraw north`"))
      << problem(north);
  EXPECT_FALSE(counts_only_later(north));
  Validity later = valid_for_days(10);
  later.begin += 400'000;
  ASSERT_TRUE(write_private(north / kCertificateFile,
                            make_identity(*authority, "north@alpha", later).value().certificate));
  EXPECT_TRUE(counts_only_later(north));
}

TEST(Documents, CountWithEveryByteOfTheirText) {
  const auto authority = make_authority("authority@alpha", valid_for_days(10));
  const auto other = make_authority("authority@alpha", valid_for_days(10));
  ASSERT_TRUE(authority && other);
  std::string document = sign_document(*authority, "<dds>all</dds>\n").value();
  EXPECT_TRUE(check_document(document, authority->certificate).value().contains("<dds>all</dds>"));
  EXPECT_FALSE(check_document(document, other->certificate));
  document.replace(document.find("all"), 3, "ill");
  EXPECT_FALSE(check_document(document, authority->certificate));
}

}  // namespace
}  // namespace mlab::keys
