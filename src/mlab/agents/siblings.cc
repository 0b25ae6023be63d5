#include "mlab/agents/siblings.h"

#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "mlab/base/hash.h"

namespace mlab::agents {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kStop = ".stop";
constexpr std::string_view kSeen = ".seen";
/// Between two looks at who is there.
constexpr std::chrono::seconds kRollCall(2);
/// Who has not noted for so long that he is there isn't.
constexpr std::chrono::seconds kMissingAfter = kSeenEvery + std::chrono::seconds(3);
constexpr int kLooks = 3;
/// More are not looked at: as many participants have place on a machine.
constexpr std::size_t kMostSiblings = dds::kMaxParticipants;

std::string text_in(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream out;
  out << stream.rdbuf();
  return std::move(out).str();
}

std::optional<std::string> name_in(const std::string& file, std::string_view before, std::string_view after) {
  if (!file.starts_with(before) || !file.ends_with(after)) return std::nullopt;
  if (file.size() < before.size() + after.size()) return std::nullopt;
  std::string out = file.substr(before.size(), file.size() - before.size() - after.size());
  return is_agent_name(out) ? std::optional(std::move(out)) : std::nullopt;
}

}  // namespace

std::string company_of(const dds::Network& network) {
  std::error_code failure;
  const std::string parts[] = {
      text_in("/proc/sys/kernel/random/boot_id"), fs::read_symlink("/proc/self/ns/net", failure).string(),
      dds::own_address_on(network), network.security ? text_in(network.security->authority) : std::string()};
  std::uint64_t hash = base::hash_text(network.security ? "secured" : "open");
  for (const std::string& part : parts) hash = base::hash_text(part, base::mix_bits(hash + part.size()));
  return fmt::format("{:016x}", hash);
}

Siblings::Siblings(const std::string& stop_file, std::string company) : company_(std::move(company)) {
  const fs::path own(stop_file);
  const std::string name = own.filename().string();
  const auto at = name.find('@');
  if (at == std::string::npos) return;
  const auto own_name = name_in(name, name.substr(0, at + 1), kStop);
  if (!own_name) return;
  folder_ = own.parent_path();
  before_ = name.substr(0, at + 1);
  own_ = *own_name;
}

Siblings::Siblings(fs::path folder, const std::string& fleet, std::string company)
    : folder_(std::move(folder)), before_(fleet + "@"), company_(std::move(company)) {}

fs::path Siblings::file(const std::string& name, std::string_view what) const {
  return folder_ / fmt::format("{}{}{}", before_, name, what);
}

Siblings::Stamp Siblings::stamp_of(const fs::path& file) {
  struct stat about{};
  if (::stat(file.c_str(), &about) != 0) return {};
  const auto since =
      std::chrono::seconds(about.st_mtim.tv_sec) + std::chrono::nanoseconds(about.st_mtim.tv_nsec);
  return {about.st_ino,
          std::chrono::file_clock::from_sys(std::chrono::sys_time<std::chrono::nanoseconds>(since))};
}

const std::vector<Sibling>& Siblings::look() {
  if (folder_.empty()) return all_;
  const Clock::time_point now = Clock::now();
  const Stamp folder = stamp_of(folder_);
  if (std::exchange(folder_was_, folder) != folder) looks_left_ = kLooks;
  if (looks_left_ > 0) {
    --looks_left_;
    look_into_folder();
  }
  if (now >= next_roll_call_) {
    next_roll_call_ = now + kRollCall;
    for (auto& [name, known] : known_) {
      const Stamp seen = stamp_of(file(name, kSeen));
      if (seen == known.seen) continue;
      known.seen = seen;
      known.sibling.heard = now;
      look_at_company(name, known);
    }
  }
  look_who_is_there(now);
  return all_;
}

void Siblings::look_into_folder() {
  std::set<std::string> there;
  std::set<std::string> keep_one;
  std::error_code failure;
  for (fs::directory_iterator each(folder_, failure); !failure && each != fs::directory_iterator();
       each.increment(failure)) {
    const std::string entry = each->path().filename().string();
    if (auto seen = name_in(entry, before_, kSeen); seen && *seen != own_ && there.size() < kMostSiblings)
      there.insert(std::move(*seen));
    if (auto stop = name_in(entry, before_, kStop)) keep_one.insert(std::move(*stop));
  }
  std::erase_if(known_, [&](const auto& one) { return !there.contains(one.first); });
  for (const std::string& name : there) {
    const auto [at, is_new] = known_.try_emplace(name);
    Known& known = at->second;
    if (is_new) {
      known.sibling.name = name;
      known.seen = stamp_of(file(name, kSeen));
      const auto age =
          std::chrono::duration_cast<Clock::duration>(fs::file_time_type::clock::now() - known.seen.written);
      known.sibling.heard = Clock::now() - std::max(age, Clock::duration::zero());
    }
    if (known.company.empty()) look_at_company(name, known);
    if (keep_one.contains(name)) {
      look_at_stop(name, known);
    } else {
      known.stop = {};
      known.sibling.stop = {};
    }
  }
}

void Siblings::look_at_company(const std::string& name, Known& known) const {
  std::uint64_t when = 0;
  std::ifstream(file(name, kSeen)) >> when >> known.company;
}

void Siblings::look_at_stop(const std::string& name, Known& known) const {
  const fs::path kept = file(name, kStop);
  const Stamp stamp = stamp_of(kept);
  if (stamp == known.stop) return;
  // One that can't be read is its agent's to make something of.
  auto state = decode(text_in(kept));
  if (!state) return;
  known.stop = stamp;
  known.sibling.stop = std::move(*state);
}

void Siblings::look_who_is_there(Clock::time_point now) {
  all_.clear();
  for (auto& [name, known] : known_) {
    known.sibling.is_there = now - known.sibling.heard < kMissingAfter;
    if (known.company == company_) all_.push_back(known.sibling);
  }
}

}  // namespace mlab::agents
