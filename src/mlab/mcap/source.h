#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "mlab/text/diagnostic.h"

namespace mlab::mcap {

/// Where a reader's bytes come from. Several threads may read at once.
class Source {
 public:
  virtual ~Source() = default;

  /// Of the moment when it was opened: what is appended later is not looked at [bytes].
  virtual std::uint64_t size() const = 0;
  /// Fills `out` with what stands at `offset`.
  /// @return  0, or the system's number of the error; `ENODATA` where the file has become shorter
  virtual int read(std::uint64_t offset, std::span<std::byte> out) const = 0;
};

/// An ordinary file. It is read, not mapped: one that somebody shortens meanwhile is an error, no signal.
/// @errors  `cannot-read` with the system's reason
text::Result<std::shared_ptr<const Source>> open_source(const std::string& path);
/// A file that is open, and stays so as long as the source is used.
std::shared_ptr<const Source> source_of(int descriptor, std::uint64_t size);
/// Bytes in memory, which are kept as long as the source is used.
std::shared_ptr<const Source> source_of(std::span<const std::byte> bytes);

}  // namespace mlab::mcap
