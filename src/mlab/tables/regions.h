#pragma once

#include <expected>
#include <span>
#include <string>
#include <string_view>

namespace mlab::tables {

/// A piece of text files that is written from the descriptor tables. It stands between two marks in whatever
/// the file takes for comments:
///
///     // [[table measure_rows]]
///     ...
///     // [[end]]
///
/// or, where a file has none, both on one line in those of regular expressions: `(?#[[table
/// x]])...(?#[[end]])`.
struct Region {
  std::string_view name;
  std::string (*write)() =
      nullptr;  ///< what stands there: whole lines, or what stands between the marks of one line
};

/// What is wrong with the marks of a file.
struct BadMark {
  std::size_t line = 0;  ///< from 1
  std::string message;
};

/// The text with all its regions written anew; the same text where it has none.
std::expected<std::string, BadMark> refreshed(std::string_view text, std::span<const Region> regions);

/// All regions that there are.
std::span<const Region> all_regions();

}  // namespace mlab::tables
