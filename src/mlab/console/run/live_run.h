#pragma once

#include <cstdint>
#include <expected>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "mlab/console/run/alarms.h"
#include "mlab/console/run/estimates.h"
#include "mlab/console/run/event_log.h"
#include "mlab/console/run/series_recorder.h"
#include "mlab/console/run/trail_recorder.h"
#include "mlab/console/run/transition_recorder.h"
#include "mlab/history/recorder.h"
#include "mlab/run/mission_run.h"

namespace mlab::console {

/// A run, and all that is noted of it while it goes on. Nothing here changes how it goes on, so a run with
/// many people looking is the same as one with nobody.
class LiveRun {
 public:
  /// @param log       outlives it
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
  /// Something was asked of the executive, ever.
  bool was_started() const;

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
  void see(const mission::Effect& effect);
  void tell(const mission::effect::Tell& told);
  void print(bool robot_info);
  void tell_recording();

  std::shared_ptr<const run::Crew> crew_;
  std::unique_ptr<run::MissionRun> run_;
  EventLog& log_;
  std::unique_ptr<history::Recorder> recorder_;  // ends before the run
  std::string told_path_;                        // of the recording,
  std::string told_problem_;                     // and what is wrong with it
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

/// Display options that are on, as MDL names them.
std::vector<std::string> options_on(const mission::Options& options);

}  // namespace mlab::console
