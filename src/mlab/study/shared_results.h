#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <expected>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mlab/study/locked_file.h"
#include "mlab/study/results_file.h"

namespace mlab::study {

/// Which of several processes that share the runs of a batch this one is.
struct Share {
  std::uint32_t rank = 0;
  std::uint32_t count = 1;
  std::uint32_t number = 0;  ///< of its file; no other has it
  std::string job;           ///< what started all of them; empty: nobody knows
  bool writes_table = true;  ///< one of them, once all is done

  bool is_alone() const { return count == 1; }
};

/// What several processes have done of one batch, on one machine or on many that share a file system: a file
/// for all, with what the batch is, and beside it one for each process, which only that process writes.
///
/// Nobody claims a run, and nobody looks whether others are alive: who has nothing left of his own takes what
/// no file has yet. A run is the same whoever carries it out, so one that is done twice counts once.
class SharedResults final : public Keeper {
 public:
  struct Joined;
  /// Begins the batch, or takes part in it.
  /// @param identity  what this process knows of it; where it names no `start-time`, that of who was first
  /// counts
  /// @param now       `start-time` of who is first, where it names none
  /// @param resumes   else runs that are there have to be of the same job
  /// @errors  a sentence about the file
  static std::expected<Joined, std::string> join(const std::string& path, const Identity& identity,
                                                 const std::string& now, const Share& share, bool resumes);
  /// To be called once all words are known, before the first run.
  /// @errors  likewise: a process that began before has read other texts
  std::optional<std::string> begin(const Identity& identity);

  bool append(const Row& row) override;
  bool append_recording(const RunKey& key, const std::string& file) override;
  std::map<RunKey, std::string> recordings() const override { return kept_recordings(path_); }
  std::vector<Row> news() override;
  bool is_over() const override;
  /// Nothing is left to do for anybody: table and page were written.
  /// @param keeps  what was done stays; else only a mark does, for who comes late
  void finish(bool keeps);

 private:
  static std::expected<Joined, std::string> join_at_once(const std::string& path, const Identity& identity,
                                                         const std::string& now, const Share& share,
                                                         bool resumes);
  SharedResults(std::string path, std::string own, LockedFile file);

  const std::string path_;
  const std::string own_;
  LockedFile file_;
  std::map<std::string, std::size_t> seen_;  // how much of whose file
  std::size_t beginning_ = 0;                // size of the file for all, before it says that all is over
  std::chrono::steady_clock::time_point synced_;
};

struct SharedResults::Joined {
  std::unique_ptr<SharedResults> results;  ///< null: the batch is over
  std::string start_time;                  ///< of all of them
  std::vector<std::string> damage;         ///< as ResultsFile::Opened
};

}  // namespace mlab::study
