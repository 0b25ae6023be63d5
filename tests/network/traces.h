#pragma once

#include <sys/types.h>

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace mlab::network {

/// Remembers what there is on this machine when a test begins, and names what has come and not gone: children
/// of this process (ended ones that nobody asked for, too), its open files (TUN devices, sockets), and
/// whatever lies in the folders, however deep. Of /tmp and /dev/shm a test that is not alone on its machine
/// can't say whose they are; Host::leftovers says it of its own.
class Traces {
 public:
  explicit Traces(std::vector<std::filesystem::path> folders = {});
  std::vector<std::string> left() const;

 private:
  std::set<std::string> look() const;

  std::vector<std::filesystem::path> folders_;
  std::set<std::string> before_;
};

}  // namespace mlab::network
