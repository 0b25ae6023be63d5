#pragma once

#include <cstdint>
#include <expected>
#include <memory>
#include <string>

#include "mlab/console/run/event_log.h"
#include "mlab/console/run/run_notes.h"
#include "mlab/history/recorder.h"
#include "mlab/run/mission_run.h"

namespace mlab::console {

/// A run, what is noted of it, and its recording. Nothing here changes how it goes on, so a run with many
/// people looking is the same as one with nobody.
class LiveRun {
 public:
  /// @param log       outlives it, or `go_on_in` is called before that ends
  /// @param recorder  of this run; null: it is not recorded
  LiveRun(std::shared_ptr<const run::Crew> crew, std::unique_ptr<run::MissionRun> run, EventLog& log,
          std::unique_ptr<history::Recorder> recorder = nullptr);
  ~LiveRun();
  LiveRun(const LiveRun&) = delete;
  LiveRun& operator=(const LiveRun&) = delete;

  run::MissionRun& run() { return *run_; }
  const run::MissionRun& run() const { return *run_; }
  /// What its robots are made of, as of the last edit.
  const std::shared_ptr<const run::Crew>& crew() const { return crew_; }
  void edit(std::shared_ptr<const run::Crew> crew);
  /// As MissionRun::take_over.
  std::expected<run::Takeover, std::string> take_over(std::shared_ptr<const run::Crew> crew);

  /// One control cycle, noted.
  run::MissionRun::Progress step();
  /// A cycle of a run that somebody else computes again.
  /// @param is_known  the log had got by then what comes of watching it
  void note_recomputed_cycle(bool is_known);
  /// Entries that the run itself has added to the log: whoever computes it again gets the same ones. Without
  /// alarms, which depend on whom people look at.
  std::uint64_t told() const { return notes_.told(); }
  /// From now on, with what has come into it until now recorded in that file (history::Recorder::go_on).
  void go_on_in(EventLog& log);
  /// The file; empty: it is not recorded.
  std::string recording() const { return recorder_ ? recorder_->path() : ""; }
  /// Something was asked of the executive, ever.
  bool was_started() const;

  /// What is noted of it.
  const RunNotes& notes() const { return notes_; }
  RunNotes& notes() { return notes_; }
  /// Null: nobody hears of its history.
  history::Recorder* recorder() { return recorder_.get(); }
  const history::Recorder* recorder() const { return recorder_.get(); }

 private:
  void tell_recording();

  std::shared_ptr<const run::Crew> crew_;
  std::unique_ptr<run::MissionRun> run_;
  EventLog* log_;
  std::unique_ptr<history::Recorder> recorder_;  // ends before the run
  std::string told_path_;                        // of the recording,
  std::string told_problem_;                     // and what is wrong with it
  RunNotes notes_;
};

}  // namespace mlab::console
