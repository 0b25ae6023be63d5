#pragma once

#include <cstdint>
#include <string>
#include <utility>

namespace mlab::durable {

/// Mounts an empty file system of so many kilobytes there, which only this process and those that it starts
/// see; who is not root becomes root of a namespace for it.
/// @return  false: none can be mounted here
bool get_small_disk(const std::string& where, std::uint64_t kilobytes);

/// A disk that others fill, and make room on.
class CrowdedDisk {
 public:
  /// @param where  a folder of a file system that nobody but the test writes to
  explicit CrowdedDisk(std::string where) : where_(std::move(where)) {}

  /// Fills it, or makes room, so that so many bytes are left, up to a page.
  /// @return  false: it can't be done
  bool leave(std::uint64_t bytes) const;
  bool make_room() const { return leave(UINT64_MAX); }

 private:
  std::string where_;
};

}  // namespace mlab::durable
