#pragma once

#include <cstddef>
#include <expected>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mlab/study/row.h"

// The files in which a batch keeps what is done: a line of JSON each, which ends with a checksum of the rest
// of it. Lines without one are of earlier versions, and count as they are.
namespace mlab::study {

/// What a batch is, in words by name: two batches are the same where all of them are equal.
using Identity = std::vector<std::pair<std::string, std::string>>;

/// The first line of each file.
std::string header_line(const Identity& identity);
std::string row_line(const Row& row);
/// A failure is recorded in a file, or was about to be.
std::string recording_line(const RunKey& key, const std::string& file);
/// Nothing is left to do: table and page were written.
std::string end_line();

/// Nothing where it is none.
std::optional<Identity> header_in(std::string_view line);
/// Empty: there is none of that name.
std::string word_in(const Identity& identity, std::string_view name);
bool has_word(const Identity& identity, std::string_view name);
/// Where the batch of a file and this one part, as a sentence about the file; empty: nowhere. What only the
/// file has a word for does not count.
std::string difference(const Identity& there, const Identity& here);

/// A file of results.
struct Contents {
  Identity header;
  std::vector<Row> rows;
  bool is_over = false;
  std::size_t size = 0;           ///< of whole lines
  std::size_t damaged = 0;        ///< lines that say nothing, or not what was written
  std::size_t first_damaged = 0;  ///< its line, from 1
};
/// @errors  a sentence about the file: its first line is none of ours
std::expected<Contents, std::string> understand(std::string_view all);

/// The runs in lines that somebody may be writing now. What is no run is passed over.
/// @param size  of whole lines
std::vector<Row> rows_in(std::string_view lines, std::size_t& size);
/// The files of recordings that lines name, likewise; of each run the last one.
std::map<RunKey, std::string> recordings_in(std::string_view lines);

}  // namespace mlab::study
