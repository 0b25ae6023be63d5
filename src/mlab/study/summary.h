#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mlab/statistics/pairs.h"
#include "mlab/statistics/samples.h"
#include "mlab/statistics/shares.h"
#include "mlab/study/batch.h"

namespace mlab::study {

/// Which of the numbers are shown for each combination, in the order of `kNumbers`.
std::vector<NumberInfo> shown_numbers();

/// What the runs of a cell say.
struct CellSummary {
  std::uint32_t version = 0;
  std::uint32_t combination = 0;
  std::vector<mdl::Setting> settings;  ///< without what is drawn
  statistics::Count successes;
  statistics::Interval interval;
  std::vector<statistics::Sample> samples;  ///< by `shown_numbers`
};

/// Runs that failed alike.
struct FailureGroup {
  std::string cause;
  std::uint64_t count = 0;
  RunKey first;           ///< of them, by version, combination and seed
  std::string message;    ///< of that one
  std::string command;    ///< that repeats it
  std::string recording;  ///< of it, a file; empty: there is none
};

/// Whether a requirement is met, and by which combinations it is not.
struct Verdict {
  const Requirement* requirement = nullptr;
  std::vector<std::uint32_t> unmet;             ///< combinations
  std::vector<statistics::Interval> intervals;  ///< by combination
  bool is_met() const { return unmet.empty(); }
};

/// The two versions on the same seeds, of one combination.
struct Comparison {
  std::uint32_t combination = 0;
  std::uint64_t pairs = 0;
  statistics::Discordant successes;  ///< first: the mission, second: what it is compared with
  double p = 1.0;                    ///< of McNemar's test
  struct Difference {
    double median = 0.0;  ///< of the mission's number less the other's; over pairs where both are there
    double mean = 0.0;
    std::uint64_t pairs = 0;
    statistics::SignedRanks ranks;
  };
  std::vector<Difference> differences;  ///< by `shown_numbers`
};

struct Summary {
  std::vector<CellSummary> cells;
  std::vector<FailureGroup> failures;  ///< the most frequent first
  std::vector<Verdict> verdicts;
  std::vector<Comparison> comparisons;
  std::uint64_t runs = 0;
  std::uint64_t failed = 0;

  bool are_all_met() const;
};
Summary summary_of(const Batch& batch, const Definition& definition, const Plan& plan);

/// The command that carries a run out again, for a shell.
std::string command_of(const RunKey& key, const Definition& definition, const Plan& plan);
/// The command that computes a recorded run again, for a shell.
std::string replay_of(const std::string& recording);

}  // namespace mlab::study
