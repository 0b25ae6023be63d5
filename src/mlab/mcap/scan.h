#pragma once

#include <cstdint>
#include <expected>
#include <optional>
#include <string>
#include <vector>

#include "mlab/mcap/contents.h"
#include "mlab/mcap/encode.h"

/// For sources of this module only.
namespace mlab::mcap {

/// A message of a chunk that was looked at.
struct FoundMessage {
  ChannelId channel;
  IndexEntry entry;
};

/// What is found by looking through a file, record by record, and into its chunks.
struct Scan {
  Contents contents;
  std::uint64_t sound_end = 0;  ///< behind the last record that is whole and right
  /// Where nothing but indexes of its messages is sound behind the last sound chunk: what is in that one.
  std::optional<std::vector<FoundMessage>> last_chunk;
  std::string foreign;  ///< a sentence: what is in it that a writer of ours does not go on behind; or empty
};

/// @param why_not_summary  why the file is looked through, for one whose data prove to be all there
/// @errors  it is no MCAP file; a sentence that says what stands there, and what should
std::expected<Scan, std::string> scan(const Source& source, const Limits& limits,
                                      const std::string& why_not_summary);

}  // namespace mlab::mcap
