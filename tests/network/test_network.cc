#include "test_network.h"

#include <fmt/format.h>

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

// Those that hosts would not see of themselves; where the test program is, too, for it was built there.
std::vector<std::string> hidden_folders(const NetworkSetup& setup) {
  std::vector<std::string> wanted = setup.shared;
  wanted.push_back(fs::read_symlink("/proc/self/exe").parent_path());
  std::vector<std::string> out;
  for (const std::string& folder : wanted) {
    const std::string absolute = fs::absolute(folder).lexically_normal();
    if (absolute.starts_with("/tmp/")) out.push_back(absolute);
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
