#include "mlab/dds/security_settings.h"

#include <dds/dds.h>
#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "mlab/text/shown.h"

namespace mlab::dds {
namespace fs = std::filesystem;
namespace {

constexpr std::uintmax_t kMostBytes = 1 << 20;
constexpr std::size_t kLongestPath = 1000;

/// Cyclone loads what proves, permits and encrypts from libraries of its own.
struct Plugin {
  const char* property;  ///< how QoS properties of it begin
  const char* file;
  const char* word;  ///< of its functions
};
constexpr std::array<Plugin, 3> kPlugins = {{
    {"dds.sec.auth.library", "libdds_security_auth.so", "authentication"},
    {"dds.sec.access.library", "libdds_security_ac.so", "access_control"},
    {"dds.sec.crypto.library", "libdds_security_crypto.so", "crypto"},
}};

/// Where Cyclone itself was loaded from, so that the plugins are of the same version.
fs::path folder_of_cyclone() {
  Dl_info found{};
  if (::dladdr(reinterpret_cast<const void*>(&dds_create_participant), &found) == 0 ||
      found.dli_fname == nullptr)
    return {};
  std::error_code failure;
  return fs::canonical(found.dli_fname, failure).parent_path();
}

/// Debian's keeps them in a folder beside it, others beside it.
std::expected<std::string, std::string> place_of(const Plugin& plugin) {
  const fs::path folder = folder_of_cyclone();
  std::error_code failure;
  for (const fs::path& place : {folder / "libddsc0debian" / plugin.file, folder / plugin.file}) {
    if (fs::exists(place, failure)) return place.string();
  }
  return std::unexpected(fmt::format(
      "Cyclone DDS has no `{}` in `{}`, which a secured fleet needs: the package libddsc0debian brings it",
      plugin.file, text::shown((folder / "libddsc0debian").string(), kLongestPath)));
}

std::expected<void, std::string> set_plugins(dds_qos_t* qos) {
  for (const Plugin& plugin : kPlugins) {
    const auto place = place_of(plugin);
    if (!place) return std::unexpected(place.error());
    const std::string property = plugin.property;
    dds_qset_prop(qos, (property + ".path").c_str(), place->c_str());
    dds_qset_prop(qos, (property + ".init").c_str(), fmt::format("init_{}", plugin.word).c_str());
    dds_qset_prop(qos, (property + ".finalize").c_str(), fmt::format("finalize_{}", plugin.word).c_str());
  }
  return {};
}

/// @param begin  what a file of its kind holds
std::expected<std::string, std::string> text_of(const std::string& file, const char* what,
                                                std::string_view begin) {
  const std::string shown = text::shown(file, kLongestPath);
  std::error_code failure;
  const auto size = fs::is_regular_file(file, failure) ? fs::file_size(file, failure) : 0;
  if (!fs::exists(file, failure)) return std::unexpected(fmt::format("`{}`, {}, is missing", shown, what));
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  if (size > 0 && size <= kMostBytes) text << stream.rdbuf();
  if (!stream) return std::unexpected(fmt::format("`{}`, {}, can't be read", shown, what));
  if (text.view().contains(begin)) return std::move(text).str();
  return std::unexpected(fmt::format("`{}` is not {}: it has no `{}`", shown, what, begin));
}

/// One of a participant's files.
struct Part {
  std::string file;
  const char* property;
  const char* what;
  const char* begin;
};

std::array<Part, 7> parts_of(const Security& files) {
  constexpr const char* kCertificate = "-----BEGIN CERTIFICATE-----";
  constexpr const char* kSigned = "application/x-pkcs7-signature";
  return {{
      {files.authority, "dds.sec.auth.identity_ca", "the authority's certificate", kCertificate},
      {files.authority, "dds.sec.access.permissions_ca", "the authority's certificate", kCertificate},
      {files.certificate, "dds.sec.auth.identity_certificate", "a certificate", kCertificate},
      {files.key, "dds.sec.auth.private_key", "a private key", "PRIVATE KEY-----"},
      {files.governance, "dds.sec.access.governance", "the signed governance document", kSigned},
      {files.permissions, "dds.sec.access.permissions", "the signed permissions", kSigned},
      {files.withdrawn, "org.eclipse.cyclonedds.sec.auth.crl", "the list of withdrawn certificates",
       "-----BEGIN X509 CRL-----"},
  }};
}

}  // namespace

std::chrono::seconds time_left(const Security& security) {
  constexpr std::chrono::seconds kTakingLeave(2);
  constexpr std::chrono::seconds kLong = std::chrono::years(100);
  if (security.end == 0) return kLong;
  const std::chrono::sys_seconds end{std::chrono::seconds(security.end)};
  const auto now = std::chrono::ceil<std::chrono::seconds>(std::chrono::system_clock::now());
  return std::clamp(end - now - kTakingLeave, std::chrono::seconds(0), kLong);
}

std::expected<Qos, std::string> identity_of(const Network& network) {
  if (!network.security) return Qos();
  Qos qos(dds_create_qos());
  if (const auto set = set_plugins(qos.get()); !set) return std::unexpected(set.error());
  for (const Part& part : parts_of(*network.security)) {
    const auto text = text_of(part.file, part.what, part.begin);
    if (!text) return std::unexpected(text.error());
    // The text itself, not the path: what was looked at is what counts.
    dds_qset_prop(qos.get(), part.property, ("data:," + *text).c_str());
  }
  return qos;
}

}  // namespace mlab::dds
