#include "test_network.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "address.h"

namespace mlab::network {
namespace {

namespace fs = std::filesystem;

bool is_in(const std::string& folder, const std::string& other) {
  return folder == other || folder.starts_with(other + "/");
}

// Those that hosts would not see of themselves; where the project is, and was built, too. One that is in
// another one comes with that.
std::vector<std::string> hidden_folders(const NetworkSetup& setup) {
  std::vector<std::string> wanted = setup.shared;
  for (const fs::path& own : {fs::read_symlink("/proc/self/exe"), fs::path(MLAB_SHIFTED_CLOCK)})
    wanted.push_back(own.parent_path());
  wanted.emplace_back(MLAB_NETWORK_SOURCES);
  for (std::string& folder : wanted) folder = fs::absolute(folder).lexically_normal();
  std::ranges::sort(wanted);
  std::vector<std::string> out;
  for (const std::string& folder : wanted) {
    const bool comes_with =
        std::ranges::any_of(out, [&](const std::string& other) { return is_in(folder, other); });
    if (folder.starts_with("/tmp/") && !comes_with) out.push_back(folder);
  }
  return out;
}

}  // namespace

TestNetwork::TestNetwork(const NetworkSetup& setup)
    : seed_(setup.seed), relay_(setup.seed), outputs_(std::make_shared<EventLoop>()) {
  if (setup.hosts.size() > kMaxHosts) throw std::runtime_error("more hosts than addresses");
  KeeperSetup keeper{.shared = hidden_folders(setup), .means = setup.means};
  for (const HostSetup& host : setup.hosts) keeper.names.push_back(host.name);
  for (const HostSetup& host : setup.hosts) {
    keeper.uptime = host.uptime;
    hosts_.push_back(std::make_unique<Host>(keeper, relay_, outputs_));
    ++keeper.number;
  }
  fmt::print("[network] {} hosts, seed {}\n", hosts_.size(), seed_);
  std::fflush(stdout);
}

Host& TestNetwork::host(const std::string& name) {
  for (const auto& host : hosts_) {
    if (host->name() == name) return *host;
  }
  throw std::out_of_range("no host " + name);
}

void TestNetwork::cut(const Host& one, const Host& other, bool is_cut) {
  relay_.cut(one.number(), other.number(), is_cut);
  relay_.cut(other.number(), one.number(), is_cut);
}

void TestNetwork::cut(const Host& one, const Host& other) {
  cut(one, other, true);
}

void TestNetwork::join(const Host& one, const Host& other) {
  cut(one, other, false);
}

void TestNetwork::isolate(const Host& host) {
  for (const auto& other : hosts_) cut(host, *other, true);
}

void TestNetwork::join(const Host& host) {
  for (const auto& other : hosts_) cut(host, *other, false);
}

std::vector<std::string> TestNetwork::leftovers() const {
  std::vector<std::string> out;
  for (const auto& host : hosts_) {
    for (std::string& one : host->leftovers()) out.push_back(std::move(one));
  }
  return out;
}

std::uint64_t TestNetwork::overruns() const {
  std::uint64_t sum = 0;
  for (const auto& host : hosts_) sum += host->overruns();
  return sum;
}

std::string why_no_hosts(const Means& means) {
  static std::mutex mutex;
  static std::map<std::pair<bool, bool>, std::string> known;
  const std::scoped_lock lock(mutex);
  const auto [found, is_new] = known.try_emplace({means.needs_user_namespace, means.needs_veth});
  if (!is_new) return found->second;
  try {
    Relay relay(0);
    const Host host({.names = {"trial"}, .means = means}, relay, std::make_shared<EventLoop>());
  } catch (const std::exception& failure) {
    found->second = failure.what();
  }
  return found->second;
}

}  // namespace mlab::network
