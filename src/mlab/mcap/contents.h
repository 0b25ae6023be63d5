#pragma once

#include <cstddef>
#include <cstdint>
#include <expected>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mlab/mcap/ending.h"
#include "mlab/mcap/limits.h"
#include "mlab/mcap/records.h"
#include "mlab/mcap/source.h"

/// For sources of this module only.
namespace mlab::mcap {

/// A stretch of a file that holds messages: a chunk, or messages that follow each other outside of chunks.
struct Piece {
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
  std::uint64_t start_time = 0;     ///< no message of it is earlier [ns]
  std::uint64_t end_time = 0;       ///< nor later [ns]
  std::vector<ChannelId> channels;  ///< sorted; of a chunk without message indexes none: nobody knows
  bool is_chunk = true;
};

/// All that is known of a file once it is open.
struct Contents {
  Header header;
  Summary summary;
  std::vector<Piece> pieces;  ///< in the order of the file
  Ending ending;
};

/// Whether the file begins as MCAP does, and with which header.
/// @errors  a sentence that says what stands there, and what should
std::expected<Header, std::string> read_header(const Source& source);
/// Where the first record behind the header begins, in a file that has one.
std::uint64_t behind_header(const Source& source);

/// Out of the summary at the end of the file.
/// @errors  why there is none that can be relied on
std::expected<Contents, std::string> contents_by_summary(const Source& source, const Limits& limits);

/// The largest record that a chunk of this size can be, compressed or not.
std::uint64_t most_chunk_length(const Limits& limits);
/// What went wrong at reading, as a sentence.
std::string read_problem(int error);

}  // namespace mlab::mcap
