#pragma once

#include <expected>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "mlab/history/history_writer.h"
#include "mlab/history/recording_file.h"
#include "mlab/mission/effect.h"
#include "mlab/run/mission_run.h"

namespace mlab::history {

/// A run that is recorded in a file, from the moment in which somebody starts it. Whatever becomes of the
/// file, the run goes on.
class Recorder {
 public:
  /// Where the file is to be; asked once, when the run is started.
  /// @errors  why there is no such place, as a sentence
  using Place = std::function<std::expected<std::string, std::string>()>;

  /// @param run  nothing has come into it yet; outlives this
  Recorder(Place place, run::MissionRun& run, const Circumstances& circumstances);
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  void see(const mission::Effect& effect) { writer_.see(effect); }
  void note_cycle() { writer_.note_cycle(); }
  /// No time passes.
  void note_rest() {
    if (file_) file_->flush();
  }
  /// The recording is complete. Without, it is one of a run that was cut off.
  void end(const std::string& outcome);

  /// Empty: nobody has started the run, or there is no place.
  const std::string& path() const { return path_; }
  /// Why the recording does not go on, as a sentence; empty: it does.
  const std::string& problem() const { return file_ ? file_->problem() : problem_; }

 private:
  void put(const wire::HistoryEntry& entry);
  void begin_file();

  const Place place_;
  const double started_at_;
  std::vector<wire::HistoryEntry> waiting_;  // until there is a file
  std::unique_ptr<RecordingWriter> file_;
  std::string path_;
  std::string problem_;  // where there is no file
  HistoryWriter writer_;
};

}  // namespace mlab::history
