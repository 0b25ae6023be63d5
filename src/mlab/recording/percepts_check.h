#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "mlab/percepts_file.pb.h"

namespace mlab::recording {

/// The longest entry that a file of percepts may have: ten thousand robots, each with three kilobytes
/// [bytes].
inline constexpr std::size_t kMostBytes = std::size_t{32} << 20;
/// So many robots may get a body, or get one again.
inline constexpr std::size_t kMostBodies = 100'000;

/// Reads an entry out of its bytes, at most `kMostBytes`. Strangers' bytes take no more than some hundred
/// megabytes while they are read, and what is read can be acted on: all numbers are numbers, all columns
/// equally long.
/// @errors  a sentence that says what stands there, and what may: `cycle.states[2].pose.x is nan, ...`
std::optional<std::string> parse_entry(std::string_view bytes, wire::RecordedEntry& out);

}  // namespace mlab::recording
