#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace mlab::mcap {

/// A record that can't be read, and what is wrong with it. Those around it can.
struct Damage {
  std::uint64_t offset = 0;  ///< where the record begins in the file
  std::string what;          ///< `a chunk whose checksum differs: ...`
};

/// How far a file can be read, and why no further.
struct Ending {
  static constexpr std::size_t kMostDamages = 100;

  bool is_whole = true;              ///< its writer closed it: the summary is there, and right
  std::uint64_t readable_bytes = 0;  ///< from its beginning
  std::uint64_t file_bytes = 0;
  std::string why;              ///< it is not whole; empty where it is
  std::vector<Damage> damages;  ///< in front of that, in their order; the first `kMostDamages`, found by
                                ///< looking through a file that is not whole
  /// What stands where it can be read no further is not what its writer wrote; else the file just ends there,
  /// as where its writer was killed.
  bool is_broken = false;

  /// `readable up to byte 1200 of 1300: the file ends with 91 of the 300 bytes of a chunk ...`; empty where
  /// the file is whole.
  std::string sentence() const;
};

}  // namespace mlab::mcap
