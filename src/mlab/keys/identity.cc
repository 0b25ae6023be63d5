#include "mlab/keys/identity.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "mlab/keys/certificates.h"
#include "mlab/keys/private_files.h"
#include "mlab/text/shown.h"

namespace mlab::keys {
namespace fs = std::filesystem;
namespace {

struct Files {
  std::string authority;
  std::string certificate;
  std::string key;
  std::string governance;
  std::string permissions;
  std::string withdrawn;
};

std::expected<Files, std::string> read_all(const fs::path& folder) {
  Files out;
  for (const auto& [name, text] :
       {std::pair(kAuthorityFile, &out.authority), std::pair(kCertificateFile, &out.certificate),
        std::pair(kKeyFile, &out.key), std::pair(kGovernanceFile, &out.governance),
        std::pair(kPermissionsFile, &out.permissions), std::pair(kWithdrawnFile, &out.withdrawn)}) {
    auto read = read_file(folder / name);
    if (!read) return std::unexpected(read.error());
    *text = std::move(*read);
  }
  return out;
}

/// A sentence of a file and what is wrong with it.
std::unexpected<std::string> wrong(const fs::path& folder, const char* file, const std::string& what) {
  return std::unexpected(fmt::format("`{}` {}", text::shown((folder / file).string(), 1000), what));
}

/// What helps where a certificate has run out; empty where it has not.
std::string renewal_of(const Files& files) {
  const auto has_run_out = [](const std::string& one) { return validity_of(one).end <= seconds_now(); };
  const std::string whole = text::shown(name_in(files.certificate), 200);
  const std::size_t at = whole.find('@');
  if (at == std::string::npos) return "";
  const std::string name = whole.substr(0, at);
  const std::string fleet = whole.substr(at + 1);
  if (has_run_out(files.authority))
    return fmt::format(" by this machine's clock: all keys of the fleet `{}` have to be made anew", fleet);
  if (!has_run_out(files.certificate)) return "";
  return fmt::format(
      " by this machine's clock: where the fleet's keys are, `mlab keys {0} --withdraw {1}` and then `mlab "
      "keys {0} --add {1}` make another",
      fleet, name);
}

std::expected<void, std::string> check_signatures(const fs::path& folder, const Files& files) {
  if (const auto good = check_certificate(files.authority, files.authority); !good)
    return wrong(folder, kAuthorityFile, good.error() + renewal_of(files));
  if (const auto good = check_certificate(files.certificate, files.authority); !good)
    return wrong(folder, kCertificateFile, good.error() + renewal_of(files));
  if (const auto good = check_key(files.certificate, files.key); !good)
    return wrong(folder, kKeyFile, good.error());
  if (const auto good = check_document(files.governance, files.authority); !good)
    return wrong(folder, kGovernanceFile, good.error());
  const auto permissions = check_document(files.permissions, files.authority);
  if (!permissions) return wrong(folder, kPermissionsFile, permissions.error());
  const std::string subject = fmt::format("<subject_name>{}</subject_name>", subject_in(files.certificate));
  if (permissions->contains(subject)) return {};
  return wrong(folder, kPermissionsFile, "is of another identity");
}

}  // namespace

dds::Security security_in(const fs::path& folder) {
  const auto certificate = read_file(folder / kCertificateFile);
  return {.authority = (folder / kAuthorityFile).string(),
          .certificate = (folder / kCertificateFile).string(),
          .key = (folder / kKeyFile).string(),
          .governance = (folder / kGovernanceFile).string(),
          .permissions = (folder / kPermissionsFile).string(),
          .withdrawn = (folder / kWithdrawnFile).string(),
          .end = certificate ? validity_of(*certificate).end : 0};
}

bool counts_only_later(const fs::path& folder) {
  const std::array files = {kAuthorityFile, kCertificateFile};
  return std::ranges::any_of(files, [&](const char* file) {
    const auto certificate = read_file(folder / file);
    return certificate && seconds_now() < validity_of(*certificate).begin;
  });
}

std::string running_out(std::int64_t end) {
  constexpr std::int64_t kSoon = std::int64_t{30} * 86'400;  // [s]
  const std::int64_t left = end - seconds_now();
  if (left > kSoon) return "";
  if (left > 0) return fmt::format("runs out in {}", days_between(seconds_now(), end));
  return fmt::format("ran out {} ago", days_between(end, seconds_now()));
}

std::expected<Identity, std::string> check_identity(const fs::path& folder, const std::string& fleet) {
  const auto files = read_all(folder);
  if (!files) return std::unexpected(files.error());
  if (const auto is_secret = check_private(folder / kKeyFile); !is_secret)
    return std::unexpected(is_secret.error());
  if (const auto good = check_signatures(folder, *files); !good) return std::unexpected(good.error());
  const std::string whole = name_in(files->certificate);
  const std::string name = whole.substr(0, whole.find('@'));
  if (whole != certified_name(name, fleet))
    return wrong(folder, kCertificateFile,
                 fmt::format("is of `{}`, none of the fleet `{}`", text::shown(whole, 200), fleet));
  const auto is_gone = is_withdrawn(files->withdrawn, files->certificate, files->authority);
  if (!is_gone) return wrong(folder, kWithdrawnFile, is_gone.error());
  if (*is_gone) return wrong(folder, kCertificateFile, "was withdrawn: it takes part no more");
  return Identity{.name = name, .end = validity_of(files->certificate).end};
}

bool WithdrawalWatch::has_changed() {
  if (folder_.empty()) return false;
  std::error_code failure;
  const bool was_there = std::exchange(is_there_, fs::exists(folder_ / kCertificateFile, failure));
  if (was_there && !is_there_) return true;
  auto now = read_file(folder_ / kWithdrawnFile);
  const auto authority = read_file(folder_ / kAuthorityFile);
  if (!now || !authority || *now == seen_ || !check_list(*now, *authority)) return false;
  seen_ = std::move(*now);
  return true;
}

}  // namespace mlab::keys
