#pragma once

#include <cstddef>
#include <expected>
#include <string>
#include <utility>
#include <vector>

#include "mlab/journal/journal.h"

namespace mlab::journal {

/// A run that did not end.
struct Unfinished {
  std::string path;  ///< of its journal
  Stand stand;
};

/// The journals of one project, a file for each run. Those of runs that ended are removed; of the others the
/// newest kMost stay.
class JournalFolder {
 public:
  static constexpr std::size_t kMost = 10;

  /// @param folder  made when it is needed; empty: nothing is kept
  explicit JournalFolder(std::string folder) : folder_(std::move(folder)) {}

  const std::string& folder() const { return folder_; }
  /// Where the journal of a run that begins now is to be.
  /// @param now  wall clock, seconds since 1970-01-01 00:00 UTC
  /// @errors  why nothing can be kept there, as a sentence
  std::expected<std::string, std::string> place(double now) const;

  struct Found {
    std::vector<Unfinished> runs;        ///< the one that was written last first
    std::vector<std::string> set_aside;  ///< sentences: files that are no journals, and where they are now
    std::size_t held = 0;                ///< how many other processes have
  };
  /// Looks at all that are there. What other processes have open is left alone and counted; what can't be
  /// read gets another name and is never removed.
  Found look() const;

  /// Gives a file that can't be read another name. @return  a sentence that says so
  static std::string set_aside(const std::string& path, const std::string& why);
  /// The journal with all that belongs to it.
  static void remove(const std::string& path);

 private:
  std::vector<std::string> paths() const;

  std::string folder_;
};

}  // namespace mlab::journal
