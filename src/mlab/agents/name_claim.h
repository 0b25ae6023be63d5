#pragma once

#include <string_view>

namespace mlab::agents {

/// Holds an agent's name in a fleet on this machine (its network namespace) against agents of other users
/// too: they do not meet on the network. By a socket in Linux's abstract namespace, which goes with its
/// process.
class NameClaim {
 public:
  NameClaim(std::string_view fleet, std::string_view name);
  NameClaim(const NameClaim&) = delete;
  NameClaim& operator=(const NameClaim&) = delete;
  ~NameClaim();

  /// By another agent. Where no socket can be had nobody holds it.
  bool is_taken() const { return is_taken_; }

 private:
  int descriptor_ = -1;
  bool is_taken_ = false;
};

}  // namespace mlab::agents
