#include "keeper/setup.h"

#include <cstdlib>

namespace mlab::network {

std::vector<std::string> KeeperSetup::words() const {
  std::vector<std::string> out = {std::to_string(number), std::to_string(uptime.count()),
                                  means.needs_user_namespace ? "1" : "0", means.needs_veth ? "1" : "0",
                                  std::to_string(names.size())};
  out.insert(out.end(), names.begin(), names.end());
  out.insert(out.end(), shared.begin(), shared.end());
  return out;
}

std::optional<KeeperSetup> KeeperSetup::read(const std::vector<std::string>& words) {
  constexpr std::size_t kFixed = 5;
  if (words.size() < kFixed) return std::nullopt;
  KeeperSetup out;
  out.number = std::atoi(words[0].c_str());
  out.uptime = std::chrono::nanoseconds(std::atoll(words[1].c_str()));
  out.means = {.needs_user_namespace = words[2] == "1", .needs_veth = words[3] == "1"};
  const std::size_t names = kFixed + static_cast<std::size_t>(std::atoi(words[4].c_str()));
  if (names > words.size()) return std::nullopt;
  out.names.assign(words.begin() + kFixed, words.begin() + static_cast<std::ptrdiff_t>(names));
  out.shared.assign(words.begin() + static_cast<std::ptrdiff_t>(names), words.end());
  return out;
}

}  // namespace mlab::network
