#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "mlab/console/run/alarms.h"
#include "mlab/console/run/estimates.h"
#include "mlab/console/run/event_log.h"
#include "mlab/console/run/series_recorder.h"
#include "mlab/console/run/trail_recorder.h"
#include "mlab/console/run/transition_recorder.h"
#include "mlab/mission/effect.h"
#include "mlab/run/mission_run.h"

namespace mlab::console {

/// All that is noted of a run while it goes on, or while it is computed again. Reads only, so the run is the
/// same with it and without.
class RunNotes {
 public:
  /// @param run  begins; outlives this
  /// @param log  outlives it, or `go_on_in` is called before that ends
  RunNotes(const run::MissionRun& run, EventLog& log);
  RunNotes(const RunNotes&) = delete;
  RunNotes& operator=(const RunNotes&) = delete;

  /// What the run's observer is told.
  void see(const mission::Effect& effect);
  /// Once per cycle, and where none could be made.
  /// @param has_stepped  it was
  void look(bool has_stepped);
  /// Once per cycle of a run that somebody computes again.
  /// @param is_known  the log had got by then what comes of watching it
  void look_again(bool is_known);
  /// From now on.
  void go_on_in(EventLog& log) { log_ = &log; }
  /// Entries that the run itself has added to the log, without alarms.
  std::uint64_t told() const { return told_; }
  /// Its programs or its plan were exchanged.
  void change();

  const Alarms& alarms() const { return alarms_; }
  Alarms& alarms() { return alarms_; }
  const TrailRecorder& trails() const { return trails_; }
  TrailRecorder& trails() { return trails_; }
  SeriesRecorder& series() { return series_; }
  const SeriesRecorder& series() const { return series_; }
  TransitionRecorder& transitions() { return transitions_; }
  const TransitionRecorder& transitions() const { return transitions_; }
  const Estimates& estimates() const { return estimates_; }
  /// When the questions that are open were asked [s], and their texts, by id.
  const std::map<std::uint32_t, double>& asked() const { return asked_; }
  const std::map<std::uint32_t, std::string>& question_texts() const { return texts_; }
  /// As the mission has them and SET has changed them.
  const mission::Options& options() const { return options_; }
  /// True where something happened since this was asked last, other than that time passed.
  bool take_news() { return std::exchange(has_news_, false); }

 private:
  void add_seen(const mission::Effect& effect);
  void note_cycle(EventLog& alarms);

  const run::MissionRun& run_;
  EventLog* log_;
  std::uint64_t told_ = 0;
  Alarms alarms_;
  Estimates estimates_;
  TrailRecorder trails_;
  SeriesRecorder series_;
  TransitionRecorder transitions_;
  std::map<std::uint32_t, double> asked_;
  std::map<std::uint32_t, std::string> texts_;
  mission::Options options_;
  bool has_news_ = true;
};

}  // namespace mlab::console
