#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "mlab/history/history.h"
#include "mlab/history/history_writer.h"
#include "mlab/run/mission_run.h"

namespace mlab::history::testing {

/// A mission of the project that is carried out, and whose history is written.
class WrittenRun {
 public:
  /// @param file  relative to the project's folder `missions`
  /// @param proceeds  each question is answered with yes at once
  /// @param is_in_real_time  what robots answer is written, as if they were elsewhere and nobody waited for
  /// them
  /// @param elsewhere  runs all programs that can be elsewhere; null: they run here
  explicit WrittenRun(const std::string& file, std::uint64_t seed = 1, bool proceeds = false,
                      bool is_in_real_time = false,
                      std::unique_ptr<robot::ProgramRunner> elsewhere = nullptr);

  run::MissionRun& run() { return *run_; }
  /// One cycle. False where no time passed.
  bool step();
  void end(const std::string& outcome = "interrupted") { writer_.end(outcome); }
  /// What was written so far; it grows.
  std::shared_ptr<const History> history() const { return history_; }
  /// What all robots held after each cycle, as numbers; in real time without what their programs held.
  const std::vector<std::uint64_t>& values() const { return values_; }
  const std::vector<wire::HistoryEntry>& entries() const { return entries_; }

  /// Another version of the mission's file, in which `from` was written as `to`.
  std::shared_ptr<const run::Crew> edited(const std::string& from, const std::string& to);
  /// A line that was typed, as the console takes it.
  void type(const std::string& line);

 private:
  std::string path_;
  std::shared_ptr<History> history_ = std::make_shared<History>();
  std::vector<wire::HistoryEntry> entries_;
  HistoryWriter writer_;
  std::unique_ptr<run::MissionRun> run_;
  std::vector<std::uint64_t> values_;
};

/// Poses, states and the value of every port of every robot; bodies and the world; what was noted of the run.
std::uint64_t all_of(const run::MissionRun& run);
/// The same, but for what programs hold.
std::uint64_t all_outside_of_programs(const run::MissionRun& run);

}  // namespace mlab::history::testing
