#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "mlab/study/batch.h"
#include "mlab/study/summary.h"

namespace mlab::study {

/// What came of recording failures.
struct FailureRecordings {
  std::uint64_t made = 0;
  std::uint64_t left_out = 0;         ///< causes beyond kMostRecordings
  std::uint64_t missing = 0;          ///< causes that are not recorded yet, as somebody wanted an end
  std::vector<std::string> problems;  ///< sentences
};
inline constexpr std::uint64_t kMostRecordings = 100;

/// What recordings say of themselves besides the run.
struct RecordedAs {
  std::string program_version;
  std::vector<std::string> overlay_folders;
  double started_at = 0.0;  ///< wall clock, seconds since 1970-01-01 00:00 UTC
};

/// Runs the first run of each cause again, with the same seed and settings, and records it. No file is
/// written over: where one of that name is there, another name is taken. A recording has its name once it is
/// whole; what is there before (`.part`) is removed where somebody wants an end.
/// @param summary    where recordings are noted, beside the causes
/// @param folder     made where there are failures
/// @param kept       which recordings were made is kept there, so that those of a batch that was interrupted
///                   count when it is resumed; null: nowhere
/// @param wants_end  as Batch::run
FailureRecordings record_failures(const Batch& batch, Summary& summary, const Definition& definition,
                                  const Plan& plan, const std::vector<std::unique_ptr<Scene>>& scenes,
                                  const std::string& folder, const RecordedAs& as, Keeper* kept,
                                  const std::function<bool()>& wants_end);

}  // namespace mlab::study
