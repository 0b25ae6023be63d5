#pragma once

#include <expected>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/keys/certificates.h"
#include "mlab/keys/private_files.h"

// The keys of a secured fleet, on the machine where they are made.
namespace mlab::keys {

/// The identity of the machine itself, which is used where no other is named; also what the folder is called
/// that an identity is put into on another machine.
inline constexpr const char* kOwnIdentity = "own";

/// Why that can't be the name of an identity: 1 to 64 letters, digits, `-`, `_` and `.` can, with no dot in
/// front. Nothing: it can.
std::optional<std::string> why_no_identity_name(std::string_view name);

/// The authority of a fleet, and all identities that it has made. In its folder:
///
///     authority/          secret: who has it makes members of the fleet
///     authority/issued/   certificates of all members, authority/withdrawn/ of those who are none any more
///     NAME/               an identity, to be moved to its machine (identity.h)
///
/// Folders have mode 0700, files 0600. Whoever is killed in between leaves whole files behind; calling the
/// same once more goes on. What can't be written whole, on a full disk say, is taken back. Who has opened
/// them keeps others waiting.
class FleetKeys {
 public:
  /// Makes the authority where there is none, and the folder.
  /// @param folder  of the fleet's keys
  /// @errors  a sentence: what can't be read or written; an authority of which a part is missing; an own
  ///          identity that was made elsewhere
  static std::expected<FleetKeys, std::string> open(const std::filesystem::path& folder,
                                                    const std::string& fleet);

  /// Whether `open` would find an authority there.
  static bool are_there(const std::filesystem::path& folder);

  /// Makes an identity, good for two years. One that is half made is made anew.
  /// @return  its folder
  /// @errors  a sentence: a name that can't be used or is in use
  std::expected<std::filesystem::path, std::string> add(const std::string& name);

  /// From now on the identity is on the list of those who don't belong to the fleet, and its folder is
  /// removed. All folders of identities here get that list; those on other machines have to be brought it.
  /// @errors  a sentence: there is no identity of that name; the list can't be written, and it can be done
  /// again
  std::expected<void, std::string> withdraw(const std::string& name);

  /// Those that are good, by name.
  std::vector<std::string> names() const;
  /// Of these, those whose folder here lacks files, by name: they can't be used.
  std::vector<std::string> half_made() const;
  /// Of those that run out within a month, or have: `runs out in 12 days`.
  struct RunningOut {
    std::string name;
    std::string when;
  };
  std::vector<RunningOut> running_out() const;
  /// Whether an identity of that name was withdrawn once.
  bool was_withdrawn(const std::string& name) const;
  /// The list of those who were withdrawn, a file to be brought to other machines.
  std::filesystem::path withdrawn_file() const;

 private:
  FleetKeys(std::filesystem::path folder, std::string fleet, FolderLock lock)
      : folder_(std::move(folder)), fleet_(std::move(fleet)), lock_(std::move(lock)) {}
  std::expected<void, std::string> make_authority();
  std::expected<void, std::string> read_authority();
  /// @param also  a certificate that is to be withdrawn; empty: none
  std::expected<void, std::string> write_list(const std::filesystem::path& also = {}) const;
  std::filesystem::path authority() const { return folder_ / "authority"; }
  std::filesystem::path issued(const std::string& name) const;
  bool is_half_made(const std::string& name) const;

  std::filesystem::path folder_;
  std::string fleet_;
  FolderLock lock_;
  KeyPair authority_;
  std::string governance_;
};

}  // namespace mlab::keys
