#pragma once

#include <cstdint>

#include "mlab/mcap/records.h"

namespace mlab::mcap {

/// How much memory a file may take that perhaps a stranger has written. What a record says of its size is
/// held against the file, and against these, before anything is allocated.
struct Limits {
  std::uint64_t chunk_bytes = kMostChunkBytes;          ///< of one chunk, uncompressed; below 4 GiB
  std::uint64_t open_bytes = std::uint64_t{512} << 20;  ///< of all chunks that overlap in time
  std::uint64_t definition_bytes = std::uint64_t{64}
                                   << 20;  ///< of all schemas and channels, of a summary, of metadata
  std::uint64_t attachment_bytes = std::uint64_t{1} << 30;  ///< of one attachment
};

}  // namespace mlab::mcap
