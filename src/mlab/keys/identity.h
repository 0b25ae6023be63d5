#pragma once

#include <cstdint>
#include <expected>
#include <filesystem>
#include <string>
#include <utility>

#include "mlab/dds/security.h"

// One identity of a secured fleet, as it lies on the machine that uses it.
namespace mlab::keys {

/// The files of an identity's folder.
inline constexpr const char* kAuthorityFile = "authority.crt";      ///< who has signed all of it, PEM
inline constexpr const char* kCertificateFile = "identity.crt";     ///< PEM
inline constexpr const char* kKeyFile = "identity.key";             ///< PEM, secret: mode 0600
inline constexpr const char* kGovernanceFile = "governance.p7s";    ///< S/MIME: what is protected
inline constexpr const char* kPermissionsFile = "permissions.p7s";  ///< S/MIME: what the identity may do
inline constexpr const char* kWithdrawnFile = "withdrawn.crl";  ///< PEM: who doesn't belong to it any more

/// The same for a participant of the fleet, which reads them when it is opened.
dds::Security security_in(const std::filesystem::path& folder);

/// What certificates call an identity.
inline std::string certified_name(const std::string& name, const std::string& fleet) {
  return name + "@" + fleet;
}

/// What stands in an identity's folder, and is fit for use.
struct Identity {
  std::string name;      ///< within the fleet
  std::int64_t end = 0;  ///< till when it is good [s since 1970]
};

/// Looks whether an identity can be used now.
/// @param folder  its files
/// @param fleet   whose it has to be
/// @errors  a sentence for a person: a file that is missing, somebody else's, out of date, readable by
/// others;
///          another fleet's; withdrawn
std::expected<Identity, std::string> check_identity(const std::filesystem::path& folder,
                                                    const std::string& fleet);

/// The identity counts at some later time by this machine's clock, which may not be set yet: a machine
/// without a clock of its own learns the time from the network, some seconds after it was switched on.
bool counts_only_later(const std::filesystem::path& folder);

/// Of what is good till then: `runs out in 12 days`, `ran out 3 days ago`; empty: it is good for a month at
/// least.
/// @param end  [s since 1970]
std::string running_out(std::int64_t end);

/// Notices that the list of those who were withdrawn is another one. One that the authority has not signed,
/// or not yet whole, is none.
class WithdrawalWatch {
 public:
  /// @param folder  of an identity; empty: nothing is watched
  explicit WithdrawalWatch(std::filesystem::path folder) : folder_(std::move(folder)) { has_changed(); }

  /// Whether it has changed since the last call, or the begin, or the identity itself is there no more. Reads
  /// two small files.
  bool has_changed();

 private:
  std::filesystem::path folder_;
  std::string seen_;
  bool is_there_ = false;  // the identity, at the last call
};

}  // namespace mlab::keys
