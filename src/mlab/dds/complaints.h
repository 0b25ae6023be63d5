#pragma once

#include <cstdint>
#include <deque>
#include <mutex>
#include <string>
#include <vector>

namespace mlab::dds {

/// What Cyclone warns of in one of its domains, instead of on the terminal. Filled by any thread.
class Complaints {
 public:
  /// Takes what is said of the domain from now on, and what is said on this thread of none in particular
  /// until `opened()`.
  explicit Complaints(std::uint32_t domain);
  Complaints(const Complaints&) = delete;
  Complaints& operator=(const Complaints&) = delete;
  ~Complaints();

  void opened();
  void add(std::string complaint);
  /// All since the last call, the newest 50.
  std::vector<std::string> take();

 private:
  std::uint32_t domain_;
  std::mutex mutex_;
  std::deque<std::string> said_;
};

}  // namespace mlab::dds
