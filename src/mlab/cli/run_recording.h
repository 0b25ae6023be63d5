#pragma once

#include <memory>
#include <string>

#include "mlab/history/recorder.h"
#include "mlab/run/mission_run.h"
#include "mlab/viewers/viewers.h"

namespace mlab::cli {

/// What is kept of a run while it goes on: its history, and beside it what other people's viewers show.
class RunRecording {
 public:
  /// @param file         made when the run is started
  /// @param run          nothing has come into it yet; outlives this
  /// @param viewer_rate  poses for viewers [Hz, of simulated time]; 0: nothing for viewers
  RunRecording(std::string file, run::MissionRun& run, const history::Circumstances& circumstances,
               double viewer_rate);

  void see(const mission::Effect& effect);
  void note(run::MissionRun::Progress progress);
  /// Beside the run, once it is started: as history::Recorder.
  void put_metadata(const mcap::Metadata& metadata) { recorder_.put_metadata(metadata); }
  /// Why what comes from now on is not kept, once; empty: it is, or that was said.
  std::string take_problem();
  /// The run is over. Says where the recording is, or that it is not whole.
  /// @param command  that was typed: `mlab run`
  /// @return false: it is not whole
  bool end(const std::string& command, const std::string& outcome);

 private:
  history::Recorder recorder_;
  std::unique_ptr<viewers::Viewers> viewers_;  // null: nothing for viewers
  bool is_problem_taken_ = false;
};

}  // namespace mlab::cli
