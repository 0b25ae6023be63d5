#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace mlab::network {

/// How a host is made. The first way that works, unless a test wants to try another.
struct Means {
  bool needs_user_namespace = false;  ///< also where root could do without
  bool needs_veth = false;            ///< also where there is a TUN device
};

/// What the keeper of a host is told before it makes it.
struct KeeperSetup {
  int number = 1;                        ///< of the host, from 1
  std::vector<std::string> names = {};   ///< of all hosts, in the order of their numbers
  std::vector<std::string> shared = {};  ///< folders below /tmp that it sees; of others it sees all
  std::chrono::nanoseconds uptime{0};    ///< that its CLOCK_MONOTONIC and CLOCK_BOOTTIME are ahead
  Means means = {};

  std::vector<std::string> words() const;
  static std::optional<KeeperSetup> read(const std::vector<std::string>& words);
};

/// Where what belongs to the harness lies on a host.
inline constexpr const char* kHarnessFolder = "/tmp/.host";
inline constexpr const char* kClockFile = "/tmp/.host/clock";

/// As whose descriptor a keeper finds its socket.
inline constexpr int kKeeperSocket = 3;

}  // namespace mlab::network
