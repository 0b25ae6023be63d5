#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "host.h"
#include "link.h"
#include "relay.h"

namespace mlab::network {

struct NetworkSetup {
  std::uint64_t seed = 1;
  std::vector<HostSetup> hosts = {};
  /// Folders below /tmp that all hosts see, too, and write to; each host sees nothing else that lies there.
  std::vector<std::string> shared = {};
  Means means = {};
};

/// Hosts, and the relay that joins them: 10.77.0.1, 10.77.0.2, ... in the order of the setup, which know each
/// other by name. Nobody else is on their network, and they reach nobody else. Says its seed on standard
/// output. All of it is gone with this object, or with this process, however it ends.
/// `example_test.cc` shows how it is used.
class TestNetwork {
 public:
  /// @errors  std::runtime_error: such hosts can't be made here
  explicit TestNetwork(const NetworkSetup& setup);
  ~TestNetwork() = default;
  TestNetwork(const TestNetwork&) = delete;
  TestNetwork& operator=(const TestNetwork&) = delete;

  /// @errors  std::out_of_range: nobody has this name
  Host& host(const std::string& name);
  const std::vector<std::unique_ptr<Host>>& hosts() const { return hosts_; }

  /// Every link.
  void set(const Link& link) { relay_.set(link); }
  /// One direction.
  void set(const Host& from, const Host& to, const Link& link) {
    relay_.set(from.number(), to.number(), link);
  }
  /// Both directions, until they are joined. What is under way is lost.
  void cut(const Host& one, const Host& other);
  void join(const Host& one, const Host& other);
  /// From all others, and to all others again.
  void isolate(const Host& host);
  void join(const Host& host);

  Relay& relay() { return relay_; }
  Counters counters(const Host& from, const Host& to) const {
    return relay_.counters(from.number(), to.number());
  }
  Counters total() const { return relay_.total(); }
  /// Of all hosts.
  std::vector<std::string> leftovers() const;
  std::uint64_t overruns() const;
  std::uint64_t seed() const { return seed_; }

 private:
  void cut(const Host& one, const Host& other, bool is_cut);

  std::uint64_t seed_;
  Relay relay_;
  std::shared_ptr<EventLoop> outputs_;
  std::vector<std::unique_ptr<Host>> hosts_;
};

/// Why no hosts can be made on this machine in this way, by one that is made for it the first time somebody
/// asks; empty: they can.
std::string why_no_hosts(const Means& means = {});

/// At the beginning of each test that makes hosts: skips it, and says why.
#define MLAB_NEEDS_HOSTS()                                                         \
  if (const std::string reason = ::mlab::network::why_no_hosts(); !reason.empty()) \
  GTEST_SKIP() << "this machine can't make hosts for tests of the network: " << reason

}  // namespace mlab::network
