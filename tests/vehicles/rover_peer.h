#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "mlab/base/random.h"

namespace mlab::vehicles {

/// How much faster than the machine's time the rover's and its device's runs.
inline constexpr int kSpeed = 6;

/// The rover of rover.mjs, in a process of its own that ends with this object.
class RoverPeer {
 public:
  /// @param port      that it sends to
  /// @param settings  `key=...`, `NAME=VALUE`
  explicit RoverPeer(std::uint16_t port, const std::vector<std::string>& settings = {});
  RoverPeer(const RoverPeer&) = delete;
  RoverPeer& operator=(const RoverPeer&) = delete;
  ~RoverPeer();

  /// Does what the line says, and tells what it is doing.
  nlohmann::json ask(const std::string& line = "");
  void kill();

 private:
  std::string read_line();

  pid_t id_ = -1;
  int input_ = -1;
  int output_ = -1;
  std::string pending_;
};

/// A port of UDP that nobody has.
std::uint16_t free_port();

/// Between a device, which listens at a port, and a rover, which sends to this relay's: loses and delays
/// datagrams, each way.
class Relay {
 public:
  using Clock = std::chrono::steady_clock;

  Relay(std::uint16_t device_port, std::uint64_t seed);
  Relay(const Relay&) = delete;
  Relay& operator=(const Relay&) = delete;
  ~Relay();

  /// That the rover is to send to.
  std::uint16_t port() const { return port_; }
  /// Passes on what is due. To be called all the time.
  void work();

  double loss = 0.0;
  Clock::duration delay{0};
  bool is_cut = false;

 private:
  struct Datagram {
    Clock::time_point at;
    bool to_device = false;
    std::string bytes;
  };
  void receive(int from, bool to_device);

  int rover_side_ = -1;
  int device_side_ = -1;
  std::uint16_t port_ = 0;
  std::uint16_t device_port_;
  std::uint16_t rover_port_ = 0;
  base::Random random_;
  std::vector<Datagram> waiting_;
};

}  // namespace mlab::vehicles
