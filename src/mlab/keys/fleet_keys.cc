#include "mlab/keys/fleet_keys.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "mlab/keys/documents.h"
#include "mlab/keys/identity.h"
#include "mlab/keys/private_files.h"
#include "mlab/text/private_folder.h"
#include "mlab/text/shown.h"

namespace mlab::keys {
namespace fs = std::filesystem;
namespace {

constexpr int kAuthorityDays = 3650;
constexpr int kIdentityDays = 730;
constexpr std::size_t kLongestName = 64;
constexpr const char* kAuthorityKeyFile = "authority.key";
constexpr const char* kEnding = ".crt";

bool is_name_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' ||
         c == '.';
}

/// The certificates in a folder, by the names of their files.
std::vector<fs::path> certificates_in(const fs::path& folder) {
  std::vector<fs::path> out;
  std::error_code failure;
  for (const fs::directory_entry& one : fs::directory_iterator(folder, failure)) {
    if (one.path().extension() == kEnding) out.push_back(one.path());
  }
  std::ranges::sort(out);
  return out;
}

/// A place that nothing has yet: a name may be withdrawn again and again.
fs::path free_place(const fs::path& folder, const std::string& name) {
  std::error_code failure;
  for (int i = 1;; ++i) {
    fs::path place = folder / fmt::format("{}_{}{}", name, i, kEnding);
    if (!fs::exists(place, failure)) return place;
  }
}

}  // namespace

std::optional<std::string> why_no_identity_name(std::string_view name) {
  if (!name.empty() && name.size() <= kLongestName && name.front() != '.' && name != "authority" &&
      std::ranges::all_of(name, is_name_letter))
    return std::nullopt;
  return fmt::format(
      "`{}` can't be the name of an identity: 1 to {} letters, digits, `-`, `_` and `.`, not "
      "`authority`",
      text::shown(name), kLongestName);
}

fs::path FleetKeys::issued(const std::string& name) const {
  return authority() / "issued" / (name + kEnding);
}

fs::path FleetKeys::withdrawn_file() const {
  return authority() / kWithdrawnFile;
}

bool FleetKeys::are_there(const fs::path& folder) {
  std::error_code failure;
  return fs::exists(folder / "authority" / kAuthorityKeyFile, failure);
}

std::expected<FleetKeys, std::string> FleetKeys::open(const fs::path& folder, const std::string& fleet) {
  std::error_code failure;
  if (!are_there(folder) && fs::exists(folder / kOwnIdentity, failure))
    return std::unexpected(fmt::format(
        "`{}` holds an identity that was made on another machine: the fleet's keys are there, and not here",
        text::shown((folder / kOwnIdentity).string(), 1000)));
  if (const auto made = text::make_private_folder(folder); !made) return std::unexpected(made.error());
  auto lock = FolderLock::of(folder);
  if (!lock) return std::unexpected(std::move(lock.error()));
  FleetKeys out(folder, fleet, std::move(*lock));
  for (const fs::path& one : {out.authority(), out.authority() / "issued", out.authority() / "withdrawn"}) {
    if (const auto made = text::make_private_folder(one); !made) return std::unexpected(made.error());
  }
  const auto known = are_there(folder) ? out.read_authority() : out.make_authority();
  if (!known) return std::unexpected(known.error());
  if (!fs::exists(out.withdrawn_file(), failure)) {
    if (const auto written = out.write_list(); !written) return std::unexpected(written.error());
  }
  return out;
}

std::expected<void, std::string> FleetKeys::make_authority() {
  auto made = keys::make_authority("authority@" + fleet_, valid_for_days(kAuthorityDays));
  if (!made) return std::unexpected(made.error());
  authority_ = std::move(*made);
  auto document = sign_document(authority_, governance());
  if (!document) return std::unexpected(document.error());
  governance_ = std::move(*document);
  // The key last: where it is, all is.
  for (const auto& [name, text] :
       {std::pair(kAuthorityFile, &authority_.certificate), std::pair(kGovernanceFile, &governance_),
        std::pair(kAuthorityKeyFile, &authority_.key)}) {
    if (const auto written = write_private(authority() / name, *text); !written) return written;
  }
  return {};
}

std::expected<void, std::string> FleetKeys::read_authority() {
  for (const auto& [name, text] :
       {std::pair(kAuthorityFile, &authority_.certificate), std::pair(kGovernanceFile, &governance_),
        std::pair(kAuthorityKeyFile, &authority_.key)}) {
    auto read = read_file(authority() / name);
    if (!read) return std::unexpected(read.error());
    *text = std::move(*read);
  }
  const auto complaint = [&](const char* file, const std::string& what) {
    return std::unexpected(fmt::format("`{}` {}", text::shown((authority() / file).string(), 1000), what));
  };
  if (const auto good = check_certificate(authority_.certificate, authority_.certificate); !good)
    return complaint(kAuthorityFile, good.error());
  if (const auto good = check_key(authority_.certificate, authority_.key); !good)
    return complaint(kAuthorityKeyFile, good.error());
  return {};
}

std::expected<fs::path, std::string> FleetKeys::add(const std::string& name) {
  if (auto problem = why_no_identity_name(name)) return std::unexpected(std::move(*problem));
  std::error_code failure;
  if (fs::exists(issued(name), failure) && !is_half_made(name))
    return std::unexpected(
        fmt::format("the fleet `{}` has an identity `{}` already: --withdraw {} makes place for another",
                    fleet_, name, name));
  const Validity validity = valid_for_days(kIdentityDays);
  const auto pair = make_identity(authority_, certified_name(name, fleet_), validity);
  if (!pair) return std::unexpected(pair.error());
  const auto document =
      sign_document(authority_, permissions(subject_in(pair->certificate), fleet_, validity));
  const auto list = read_file(withdrawn_file());
  if (!document) return std::unexpected(document.error());
  if (!list) return std::unexpected(list.error());
  fs::path folder = folder_ / name;
  if (const auto made = text::make_private_folder(folder); !made) return std::unexpected(made.error());
  const std::vector<std::pair<fs::path, const std::string*>> files = {
      {issued(name), &pair->certificate},  // first: what was handed out can be withdrawn
      {folder / kAuthorityFile, &authority_.certificate},
      {folder / kGovernanceFile, &governance_},
      {folder / kPermissionsFile, &*document},
      {folder / kWithdrawnFile, &*list},
      {folder / kKeyFile, &pair->key},
      {folder / kCertificateFile, &pair->certificate}};
  for (const auto& [file, text] : files) {
    const auto written = write_private(file, *text);
    if (written) continue;
    // Nobody has it yet: it is as if it had never been. What else lies there is somebody's.
    for (const auto& one : files) fs::remove(one.first, failure);
    fs::remove(folder, failure);
    return std::unexpected(written.error());
  }
  return folder;
}

// A folder that is not here is on its machine. The certificate is written last.
bool FleetKeys::is_half_made(const std::string& name) const {
  std::error_code failure;
  return fs::is_directory(folder_ / name, failure) && !fs::exists(folder_ / name / kCertificateFile, failure);
}

std::vector<std::string> FleetKeys::half_made() const {
  std::vector<std::string> out = names();
  std::erase_if(out, [this](const std::string& name) { return !is_half_made(name); });
  return out;
}

std::vector<FleetKeys::RunningOut> FleetKeys::running_out() const {
  std::vector<RunningOut> out;
  for (const std::string& name : names()) {
    const auto certificate = read_file(issued(name));
    if (!certificate) continue;
    std::string when = keys::running_out(validity_of(*certificate).end);
    if (!when.empty()) out.push_back({name, std::move(when)});
  }
  return out;
}

bool FleetKeys::was_withdrawn(const std::string& name) const {
  std::error_code failure;
  return fs::exists(authority() / "withdrawn" / fmt::format("{}_1{}", name, kEnding), failure);
}

std::expected<void, std::string> FleetKeys::withdraw(const std::string& name) {
  std::error_code failure;
  if (why_no_identity_name(name) || !fs::exists(issued(name), failure)) {
    std::string known;
    for (const std::string& one : names()) known += fmt::format("{}`{}`", known.empty() ? "" : ", ", one);
    return std::unexpected(fmt::format("the fleet `{}` has no identity `{}`: there is {}", fleet_,
                                       text::shown(name), known.empty() ? "none" : known));
  }
  // The list first: where that fails nothing has changed, and it can be done again.
  if (auto written = write_list(issued(name)); !written) return written;
  fs::rename(issued(name), free_place(authority() / "withdrawn", name), failure);
  if (failure) return std::unexpected(fmt::format("`{}` can't be withdrawn: {}", name, failure.message()));
  fs::remove_all(folder_ / name, failure);
  return {};
}

std::expected<void, std::string> FleetKeys::write_list(const fs::path& also) const {
  std::vector<std::string> withdrawn;
  std::vector<fs::path> files = certificates_in(authority() / "withdrawn");
  if (!also.empty()) files.push_back(also);
  for (const fs::path& file : files) {
    auto read = read_file(file);
    if (!read) return std::unexpected(read.error());
    withdrawn.push_back(std::move(*read));
  }
  // It counts wherever the authority does, also on a machine whose clock is some days behind.
  Validity validity = valid_for_days(kAuthorityDays);
  validity.begin = validity_of(authority_.certificate).begin;
  const auto list = make_withdrawal_list(authority_, withdrawn, validity);
  if (!list) return std::unexpected(list.error());
  if (const auto written = write_private(withdrawn_file(), *list); !written) return written;
  std::error_code failure;
  for (const std::string& name : names()) {
    if (!fs::is_directory(folder_ / name, failure)) continue;  // moved to its machine
    if (const auto written = write_private(folder_ / name / kWithdrawnFile, *list); !written) return written;
  }
  return {};
}

std::vector<std::string> FleetKeys::names() const {
  std::vector<std::string> out;
  for (const fs::path& file : certificates_in(authority() / "issued")) out.push_back(file.stem().string());
  return out;
}

}  // namespace mlab::keys
